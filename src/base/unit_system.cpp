#include "creepcontact/base/unit_system.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "creepcontact/base/suggestion.hpp"

namespace creepcontact {
namespace {

constexpr std::array unit_dimensions{Dimension::stress, Dimension::time, Dimension::length, Dimension::temperature,
                                     Dimension::force};
const std::vector<std::string> masses{"kg", "g", "t", "tonne", "lbm", "slug"};

std::string some_of(Dimension dimension) {
  return fmt::format("{} ({})", name_of(dimension), fmt::join(known_units(dimension), ", "));
}

/// Rids a number of the rounding of its factors: 32.00000000000001
double rounded(double value) {
  constexpr double digits = 1e10;
  return std::round(value * digits) / digits;
}

}  // namespace

std::string accepted_units() {
  return fmt::format("a list such as \"mm, N, MPa, h, degC\" with {} and {}; also {}, degC unless given, and {}",
                     some_of(Dimension::stress), some_of(Dimension::time), some_of(Dimension::temperature),
                     some_of(Dimension::length));
}

UnitSystem unit_system(const std::string& text) {
  std::map<Dimension, std::pair<std::string, UnitScale>> found;
  for (const std::string& word : unit_words(text)) {
    if (std::ranges::count(masses, word) > 0) continue;
    const auto* const dimension =
        std::ranges::find_if(unit_dimensions, [&](Dimension one) { return unit_scale(one, word).has_value(); });
    if (dimension == unit_dimensions.end()) {
      std::vector<std::string> all;
      for (const Dimension one : unit_dimensions) std::ranges::copy(known_units(one), std::back_inserter(all));
      throw std::invalid_argument(fmt::format("'{}' is not a known unit{}", word, did_you_mean(word, all)));
    }
    const auto [place, is_new] = found.try_emplace(*dimension, word, *unit_scale(*dimension, word));
    if (!is_new && place->second.first != word)
      throw std::invalid_argument(
          fmt::format("two units of {}, {} and {}", name_of(*dimension), place->second.first, word));
  }
  const auto factor = [&](Dimension dimension) {
    const auto at = found.find(dimension);
    return at == found.end() ? std::optional<double>() : std::optional(at->second.second.factor);
  };
  const auto stress = factor(Dimension::stress), time = factor(Dimension::time), length = factor(Dimension::length),
             force = factor(Dimension::force);
  if (!time) throw std::invalid_argument("no unit of time");
  if (!stress && !(force && length)) throw std::invalid_argument("no unit of stress");
  UnitSystem result{.stress = stress ? *stress : *force / (*length * *length), .time = *time};
  if (force && length && std::abs(*force / (*length * *length) / result.stress - 1) > 1e-6)
    throw std::invalid_argument(fmt::format("{0} per {1}^2 is not {2}: the units are not consistent",
                                            found[Dimension::force].first, found[Dimension::length].first,
                                            found[Dimension::stress].first));
  result.length = length ? *length : unit_scale(Dimension::length, "mm")->factor;
  const auto temperature = found.find(Dimension::temperature);
  result.temperature =
      temperature == found.end() ? *unit_scale(Dimension::temperature, "degC") : temperature->second.second;
  return result;
}

UnitChange unit_change(const UnitSystem& from, const UnitSystem& to) {
  const auto ratio = [](double old, double now) { return old == now ? 1.0 : old / now; };
  UnitChange change{.stress = ratio(from.stress, to.stress),
                    .time = ratio(from.time, to.time),
                    .length = ratio(from.length, to.length)};
  change.degree = rounded(from.temperature.factor / to.temperature.factor);
  change.zero = rounded((from.temperature.offset - to.temperature.offset) / to.temperature.factor);
  return change;
}

}  // namespace creepcontact
