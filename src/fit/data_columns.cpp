#include "data_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/base/units.hpp"

namespace creepcontact::fit {
namespace {

struct RoleName {
  const char* name;
  ColumnRole role;
};
// The first name of a role is the one in messages. Without accents: "déformation" is "deformation".
constexpr auto role_names = std::to_array<RoleName>({
    {"time", ColumnRole::time},
    {"stress", ColumnRole::stress},
    {"strain", ColumnRole::strain},
    {"creep_strain", ColumnRole::creep_strain},
    {"total_strain", ColumnRole::total_strain},
    {"temperature", ColumnRole::temperature},
    {"temp", ColumnRole::temperature},
    {"test", ColumnRole::test},
    {"test_name", ColumnRole::test},
    {"specimen", ColumnRole::test},
    {"batch", ColumnRole::batch},
    {"melt", ColumnRole::batch},
    {"heat", ColumnRole::batch},
    {"cast", ColumnRole::batch},
    {"kind", ColumnRole::kind},
    {"rate", ColumnRole::rate},
    {"creep_rate", ColumnRole::rate},
    {"strain_rate", ColumnRole::rate},
    {"minimum_creep_rate", ColumnRole::rate},
    {"min_creep_rate", ColumnRole::rate},
    {"secondary_creep_rate", ColumnRole::rate},
    {"rupture", ColumnRole::rupture},
    {"rupture_time", ColumnRole::rupture},
    {"time_to_rupture", ColumnRole::rupture},
    {"creep_rupture_time", ColumnRole::rupture},
});
/// German and French.
constexpr auto foreign_names = std::to_array<RoleName>({
    {"zeit", ColumnRole::time},
    {"spannung", ColumnRole::stress},
    {"dehnung", ColumnRole::strain},
    {"kriechdehnung", ColumnRole::creep_strain},
    {"gesamtdehnung", ColumnRole::total_strain},
    {"totaldehnung", ColumnRole::total_strain},
    {"temperatur", ColumnRole::temperature},
    {"probe", ColumnRole::test},
    {"versuch", ColumnRole::test},
    {"pruefling", ColumnRole::test},
    {"schmelze", ColumnRole::batch},
    {"charge", ColumnRole::batch},
    {"versuchsart", ColumnRole::kind},
    {"kriechrate", ColumnRole::rate},
    {"kriechgeschwindigkeit", ColumnRole::rate},
    {"minimale_kriechrate", ColumnRole::rate},
    {"minimale_kriechgeschwindigkeit", ColumnRole::rate},
    {"dehnrate", ColumnRole::rate},
    {"bruchzeit", ColumnRole::rupture},
    {"standzeit", ColumnRole::rupture},
    {"beanspruchungsdauer_bis_zum_bruch", ColumnRole::rupture},
    {"temps", ColumnRole::time},
    {"duree", ColumnRole::time},
    {"contrainte", ColumnRole::stress},
    {"deformation", ColumnRole::strain},
    {"deformation_de_fluage", ColumnRole::creep_strain},
    {"deformation_totale", ColumnRole::total_strain},
    {"essai", ColumnRole::test},
    {"eprouvette", ColumnRole::test},
    {"coulee", ColumnRole::batch},
    {"type_d'essai", ColumnRole::kind},
    {"vitesse_de_fluage", ColumnRole::rate},
    {"vitesse_minimale_de_fluage", ColumnRole::rate},
    {"vitesse_de_deformation", ColumnRole::rate},
    {"temps_a_rupture", ColumnRole::rupture},
    {"temps_a_la_rupture", ColumnRole::rupture},
    {"duree_de_vie", ColumnRole::rupture},
});

std::optional<ColumnRole> role_of(const std::string& name) {
  for (const std::span<const RoleName> language :
       {std::span<const RoleName>(role_names), std::span<const RoleName>(foreign_names)})
    for (const RoleName& known : language)
      if (name == known.name) return known.role;
  return std::nullopt;
}

/// "Prüfling" -> "Pruefling", "Déformation" -> "Deformation"
std::string without_accents(std::string text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 13> letters{{{"ä", "ae"},
                                                                                   {"ö", "oe"},
                                                                                   {"ü", "ue"},
                                                                                   {"Ü", "Ue"},
                                                                                   {"ß", "ss"},
                                                                                   {"é", "e"},
                                                                                   {"É", "E"},
                                                                                   {"è", "e"},
                                                                                   {"ê", "e"},
                                                                                   {"à", "a"},
                                                                                   {"À", "A"},
                                                                                   {"ç", "c"},
                                                                                   {"’", "'"}}};
  for (const auto& [accented, plain] : letters)
    for (std::size_t at = text.find(accented); at != std::string::npos; at = text.find(accented, at))
      text.replace(at, accented.size(), plain);
  return text;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t_/"), last = text.find_last_not_of(" \t_");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// "Creep strain" -> "creep_strain"
std::string plain(const std::string& text) {
  std::string name = without_accents(trimmed(text));
  for (char& c : name) c = c == ' ' || c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

struct Heading {
  std::string name, unit;
};

/// "time [h]", "time (h)", "time / h", "time_h", "Zeit in h"
Heading heading_of(const std::string& cell) {
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const std::size_t begin = cell.find(open), end = cell.rfind(close);
    if (begin != std::string::npos && end != std::string::npos && end > begin)
      return {plain(cell.substr(0, begin)), trimmed(cell.substr(begin + 1, end - begin - 1))};
  }
  if (role_of(plain(cell))) return {plain(cell), ""};
  // The longest name counts: "rupture time h"
  for (std::size_t at = cell.size(); at > 0 && (at = cell.find_last_of(" _/", at - 1)) != std::string::npos;) {
    if (!role_of(plain(cell.substr(0, at)))) continue;
    std::string unit = trimmed(cell.substr(at + 1));
    for (const std::string_view word : {"in ", "en "})
      if (unit.starts_with(word)) unit.erase(0, word.size());
    return {plain(cell.substr(0, at)), unit};
  }
  return {plain(cell), ""};
}

/// Factor to a strain without unit.
std::optional<double> strain_factor(const std::string& unit) {
  static const std::map<std::string, double> units{
      {"", 1},           {"-", 1},    {"1", 1},       {"mm/mm", 1},   {"m/m", 1},     {"%", 0.01},
      {"percent", 0.01}, {"‰", 1e-3}, {"mm/m", 1e-3}, {"um/m", 1e-6}, {"µm/m", 1e-6}, {"microstrain", 1e-6}};
  const auto found = units.find(unit);
  return found == units.end() ? std::nullopt : std::optional(found->second);
}

struct RateUnit {
  std::string strain, time;
};

/// "1/h", "%/h", "h^-1", "h-1", "mm/mm/h"
RateUnit rate_unit(const std::string& unit) {
  for (const char* power : {"^-1", "^(-1)", "-1", "⁻¹", "−1"})
    if (unit.ends_with(power)) return {"", trimmed(unit.substr(0, unit.size() - std::string(power).size()))};
  const std::size_t slash = unit.rfind('/');
  if (slash == std::string::npos) return {unit, ""};
  return {trimmed(unit.substr(0, slash)), trimmed(unit.substr(slash + 1))};
}

std::string known_of(ColumnRole role) {
  for (const RoleName& known : role_names)
    if (known.role == role) return known.name;
  return "";
}

}  // namespace

void DataColumns::set_unit(ColumnRole role, const std::string& unit, const std::string& file) {
  Column& column = *columns_[static_cast<std::size_t>(role)];
  const auto refuse = [&](const std::string& allowed) {
    throw ConfigError(fmt::format("{}: column '{}': the unit '{}' is none of a {}; allowed: {}", file, column.name,
                                  unit, known_of(role), allowed));
  };
  const auto quantity = [&](Dimension dimension, std::string& of_fit) {
    if (unit.empty()) return;
    const auto scale = unit_scale(dimension, unit);
    if (!scale) refuse(fmt::format("{}", fmt::join(known_units(dimension), ", ")));
    if (of_fit.empty()) of_fit = unit;
    column.factor = scale->factor / unit_scale(dimension, of_fit)->factor;
  };
  switch (role) {
    case ColumnRole::time:
    case ColumnRole::rupture:
      return quantity(Dimension::time, units_.time);
    case ColumnRole::stress:
      return quantity(Dimension::stress, units_.stress);
    case ColumnRole::temperature:
      return quantity(Dimension::temperature, units_.temperature);
    case ColumnRole::strain:
    case ColumnRole::creep_strain:
    case ColumnRole::total_strain:
      if (const auto factor = strain_factor(unit))
        column.factor = *factor;
      else
        refuse("none, '-', '%', 'mm/mm', 'm/m', 'mm/m', 'um/m'");
      return;
    case ColumnRole::rate: {
      const RateUnit parts = unit.empty() ? RateUnit{} : rate_unit(unit);
      const auto factor = strain_factor(parts.strain);
      const auto time = unit_scale(Dimension::time, parts.time);
      if (!factor || (!unit.empty() && !time)) refuse("a strain per time, such as '1/h', '%/h', 's^-1'");
      column.factor = *factor;
      if (unit.empty()) return;
      if (units_.time.empty()) units_.time = parts.time;
      column.factor *= unit_scale(Dimension::time, units_.time)->factor / time->factor;
      return;
    }
    case ColumnRole::test:
    case ColumnRole::kind:
      return;
  }
}

DataColumns::DataColumns(const std::string& file, const std::vector<std::string>& names) {
  std::array<std::string, n_column_roles> units;
  std::vector<std::string> known;
  known.reserve(role_names.size());
  for (const RoleName& role : role_names) known.emplace_back(role.name);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Heading heading = heading_of(names[i]);
    const auto role = role_of(heading.name);
    if (!role) {
      unused_.push_back(fmt::format("'{}'{}", names[i], did_you_mean(heading.name, known)));
      continue;
    }
    auto& column = columns_[static_cast<std::size_t>(*role)];
    if (column)
      throw ConfigError(fmt::format("{}: the columns '{}' and '{}' are both the {}; rename or remove one of them", file,
                                    column->name, names[i], known_of(*role)));
    column = Column{i, names[i]};
    units[static_cast<std::size_t>(*role)] = heading.unit;
  }
  const auto has = [&](ColumnRole role) { return columns_[static_cast<std::size_t>(role)].has_value(); };
  for (int i = 0; i < n_column_roles; ++i)  // the time before the rate, whose unit follows it
    if (has(static_cast<ColumnRole>(i))) set_unit(static_cast<ColumnRole>(i), units[static_cast<std::size_t>(i)], file);
  const std::string unknown = fmt::format(
      "{}; known names of columns: {}",
      unused_.empty() ? "" : fmt::format(" (not known: {})", fmt::join(unused_, ", ")), fmt::join(known, ", "));
  if (!has(ColumnRole::stress)) throw ConfigError(fmt::format("{}: no column 'stress'{}", file, unknown));
  if (!has(ColumnRole::time) && !has(ColumnRole::rate) && !has(ColumnRole::rupture))
    throw ConfigError(fmt::format("{}: no column 'time', 'rate' or 'rupture_time'{}", file, unknown));
  const auto refuse_both = [&](ColumnRole a, ColumnRole b) {
    if (has(a) && has(b))
      throw ConfigError(
          fmt::format("{}: columns '{}' and '{}'; allowed: one of them", file, (*this)[a]->name, (*this)[b]->name));
  };
  refuse_both(ColumnRole::strain, ColumnRole::creep_strain);
  refuse_both(ColumnRole::strain, ColumnRole::total_strain);
  // A unit on one side only: whether the numbers fit each other cannot be known.
  const bool rate_has_unit = !units[static_cast<std::size_t>(ColumnRole::rate)].empty();
  for (const ColumnRole role : {ColumnRole::time, ColumnRole::rupture, ColumnRole::rate})
    if (has(role) && units[static_cast<std::size_t>(role)].empty() && !units_.time.empty())
      throw ConfigError(
          fmt::format("{}: column '{}' has no unit, but another one has the time in '{}'; write '{} [{}]'", file,
                      (*this)[role]->name, units_.time, known_of(role),
                      role == ColumnRole::rate && !rate_has_unit ? "1/" + units_.time : units_.time));
}

}  // namespace creepcontact::fit
