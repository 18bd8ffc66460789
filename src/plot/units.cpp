#include "units.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

namespace creepcontact::plot {
namespace {

struct KindOfPrefix {
  std::string_view prefix, name;
  Dimension dimension;
};

// The first that fits counts.
constexpr std::array kinds{
    KindOfPrefix{"displacement_", "displacement", Dimension::length},
    KindOfPrefix{"gap", "gap", Dimension::length},
    KindOfPrefix{"stress_", "stress", Dimension::stress},
    KindOfPrefix{"von_mises", "von Mises stress", Dimension::stress},
    KindOfPrefix{"principal_", "principal stress", Dimension::stress},
    KindOfPrefix{"hydrostatic", "mean stress", Dimension::stress},
    KindOfPrefix{"contact_pressure", "contact pressure", Dimension::stress},
    KindOfPrefix{"creep_strain", "creep strain", Dimension::none},
    KindOfPrefix{"strain_", "strain", Dimension::none},
    KindOfPrefix{"temperature", "temperature", Dimension::temperature},
    KindOfPrefix{"damage", "damage", Dimension::none},
    KindOfPrefix{"life_fraction", "life fraction", Dimension::none},
    KindOfPrefix{"contact_area", "contact area", Dimension::area},
    KindOfPrefix{"contact_force_", "contact force", Dimension::force},
    KindOfPrefix{"reaction_", "reaction", Dimension::force},
};

using Words = std::vector<std::string_view>;

Words known_units(Dimension dimension) {
  switch (dimension) {
    case Dimension::time:
      return {"s", "ms", "min", "h", "hr", "hour", "hours", "d", "day", "days", "a", "yr", "year", "years"};
    case Dimension::length:
    case Dimension::area:
      return {"mm", "m", "cm", "um", "µm", "km", "in", "ft"};
    case Dimension::force:
      return {"N", "kN", "MN", "mN", "uN", "µN", "lbf", "lb", "kip", "kgf", "tf"};
    case Dimension::stress:
      return {"Pa", "kPa", "MPa", "GPa", "bar", "psi", "ksi", "Msi", "N/mm2", "N/mm^2", "N/m2", "N/m^2"};
    case Dimension::temperature:
      return {"degC", "°C", "C", "K", "degF", "°F", "F"};
    default:
      return {};
  }
}

std::vector<std::string> words(const std::string& units) {
  std::vector<std::string> result(1);
  for (char c : units) {
    if (c == ',' || c == ';' || std::isspace(static_cast<unsigned char>(c))) {
      if (!result.back().empty()) result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

}  // namespace

QuantityKind kind_of(const io::SummaryProbe& probe) {
  const auto kind =
      std::ranges::find_if(kinds, [&](const KindOfPrefix& k) { return probe.quantity.starts_with(k.prefix); });
  if (kind == kinds.end()) return {"value", Dimension::none};
  const std::string name(kind->name);
  const bool is_total = kind->dimension == Dimension::force || kind->dimension == Dimension::area;
  if (probe.integrated_over.empty() || is_total) return {name, kind->dimension};
  if (kind->dimension == Dimension::stress && probe.integrated_over == "surface") return {"force", Dimension::force};
  return {name + ", sum", Dimension::none};
}

std::string name_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::time:
      return "time";
    case Dimension::length:
      return "length";
    case Dimension::area:
      return "area";
    case Dimension::force:
      return "force";
    case Dimension::stress:
      return "stress";
    case Dimension::temperature:
      return "temperature";
    default:
      return "value";
  }
}

std::string unit_of(Dimension dimension, const std::string& units) {
  const Words known = known_units(dimension);
  for (const std::string& word : words(units)) {
    if (std::ranges::count(known, word) == 0) continue;
    if (dimension == Dimension::area) return word + "²";
    return word == "degC" ? "°C" : word == "degF" ? "°F" : word;
  }
  return "";
}

std::string labelled(const std::string& name, Dimension dimension, const std::string& units) {
  const std::string unit = unit_of(dimension, units);
  return unit.empty() ? name : name + " (" + unit + ")";
}

}  // namespace creepcontact::plot
