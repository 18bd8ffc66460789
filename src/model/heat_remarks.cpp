#include "heat_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/base/log.hpp"

namespace creepcontact::model {
namespace {

constexpr double hardly_heated = 10;   // times of the run to heat through
constexpr double coarse_biot = 1;      // element Biot number
constexpr double noticed_jump = 0.05;  // of the range of temperatures

}  // namespace

void tell_of_heat(const heat::Definition& all, const heat::Figures& figures, double end, bool starts_steady) {
  for (std::size_t b = 0; b < all.bodies.size(); ++b) {
    const std::string& name = all.bodies[b].name;
    const auto [depth, time] = figures.bodies[b];
    if (!(depth > 0)) continue;
    log::info(
        "heat: body '{}' heats through in about {:.3g} units of t (its volume over the surface through which heat "
        "comes, {:.3g}, squared, over the diffusivity)",
        name, time, depth);
    if (time > hardly_heated * end)
      log::warning(
          "heat: body '{}' takes about {:.3g} units of t to heat through, and the run lasts {:.3g}: is heat.time_unit "
          "= {:g} the unit of t in the unit of time of the heat data?",
          name, time, end, all.time_unit);
  }
  const auto jump = [&](const heat::FilmFigures& film) {
    return starts_steady ? film.later_jump : std::max(film.first_jump, film.later_jump);
  };
  for (const heat::FilmFigures& film : figures.films)
    if (film.biot > coarse_biot && jump(film) > noticed_jump * film.range)
      log::warning(
          "heat: {} has the element Biot number {:.2g} (coefficient times size of the element over the conductivity), "
          "and its fluid jumps by {:.3g}: just after that, temperatures one element deep undershoot by some per cent "
          "of it; elements of {:.2g} at that surface, or a ramp of the fluid, avoid it",
          all.flows[film.flow].name, film.biot, jump(film), film.element_size / film.biot / 3);
}

}  // namespace creepcontact::model
