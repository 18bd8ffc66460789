#include "heat_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "creepcontact/base/log.hpp"
#include "creepcontact/base/unit_system.hpp"

namespace creepcontact::model {
namespace {

constexpr double hardly_heated = 10;                   // times of the run to heat through
constexpr double coarse_biot = 1;                      // element Biot number
constexpr double noticed_jump = 0.05;                  // of the range of temperatures
constexpr Interval diffusivity_of_solids{2e-8, 2e-3};  // m^2/s: polymers have 1e-7, silver 1.7e-4, diamond 1e-3

/// In m^2/s. @param units  of the configuration; nullopt: they do not tell
std::optional<double> diffusivity_in_si(const heat::HeatingThrough& body, const std::string& units) {
  if (units.empty()) return std::nullopt;
  try {
    const UnitSystem of_model = unit_system(units);
    return body.depth * body.depth / body.time * of_model.length * of_model.length / of_model.time;
  } catch (const std::invalid_argument&) {  // a text that is only copied
    return std::nullopt;
  }
}

}  // namespace

void tell_of_heat(const heat::Definition& all, const heat::Figures& figures, double end, bool starts_steady,
                  const std::string& units) {
  for (std::size_t b = 0; b < all.bodies.size(); ++b) {
    const std::string& name = all.bodies[b].name;
    const heat::HeatingThrough& body = figures.bodies[b];
    const auto [depth, time] = body;
    if (!(depth > 0 && time > 0)) continue;
    log::info(
        "heat: body '{}' heats through in about {:.3g} units of t (its volume over the surface through which heat "
        "comes, {:.3g}, squared, over the diffusivity)",
        name, time, depth);
    if (const std::optional<double> diffusivity = diffusivity_in_si(body, units)) {
      const auto [least, most] = diffusivity_of_solids;
      if (!(*diffusivity >= least && *diffusivity <= most))
        log::warning(
            "heat: the diffusivity of body '{}' (conductivity over heat capacity and density) is {:.2g} m^2/s by the "
            "units '{}' and heat.time_unit = {:g}; solids have 1e-7 to 1e-3: one of these data has another unit of "
            "length or time",
            name, *diffusivity, units, all.time_unit);
    } else if (time > hardly_heated * end) {
      log::warning(
          "heat: body '{}' takes about {:.3g} units of t to heat through, and the run lasts {:.3g}: is heat.time_unit "
          "= {:g} the unit of t in the unit of time of the heat data?",
          name, time, end, all.time_unit);
    }
  }
  const auto jump = [&](const heat::Jumps& jumps) {
    const double largest = starts_steady ? jumps.later : std::max(jumps.first, jumps.later);
    return largest > noticed_jump * jumps.range ? largest : 0;
  };
  for (const heat::GivenFigures& given : figures.given)
    if (const double largest = jump(given.jumps); largest > 0)
      log::warning(
          "heat: the {} jumps by {:.3g}: just after that, temperatures one element deep undershoot by some per cent of "
          "it, until heat has come through the first elements; a ramp avoids it",
          all.given[given.given].name, largest);
  for (const heat::FilmFigures& film : figures.films)
    if (const double largest = jump(film.jumps); film.biot > coarse_biot && largest > 0)
      log::warning(
          "heat: {} has the element Biot number {:.2g} (coefficient times size of the element over the conductivity). "
          "Its "
          "fluid jumps by {:.3g}, or its coefficient so that as much heat flows. Just after that, temperatures one "
          "element "
          "deep undershoot by some per cent of it. Elements of {:.2g} at that surface, or a ramp of the fluid, avoid "
          "it",
          all.flows[film.flow].name, film.biot, largest, film.element_size / film.biot / 3);
}

}  // namespace creepcontact::model
