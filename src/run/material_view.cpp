#include "creepcontact/run/material_view.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/base/units.hpp"
#include "creepcontact/config/material_library.hpp"
#include "creepcontact/material/bar.hpp"
#include "creepcontact/material/registry.hpp"
#include "creepcontact/model/materials.hpp"
#include "creepcontact/run/vocabulary.hpp"

namespace creepcontact::run {
namespace {

constexpr double shorter = 1e3, longer = 1e5;  // times of the table and of isochronous curves

std::vector<double> decades_of(double first, double last, int per_decade) {
  const int n = static_cast<int>(std::round(per_decade * std::log10(last / first)));
  std::vector<double> all;
  for (int i = 0; i <= n; ++i) all.push_back(first * std::pow(last / first, static_cast<double>(i) / n));
  return all;
}

/// A variant as a bar at one temperature.
class VariantBar {
 public:
  VariantBar(const config::LibraryMaterial& steel, const config::LibraryVariant& variant, double T)
      : name_(variant.name), temperature_(T) {
    const config::Material data = config::library_material(steel, variant.name, steel.units, vocabulary());
    material_ = model::make_material(data);
    rupture_ = data.rupture ? model::rupture_data(*data.rupture) : nullptr;
    std::erase_if(material_.creep, [](const auto& law) { return !law->strains(); });
    if (steel.has("young_modulus")) young_modulus_ = material_.young_modulus({.T = T});
  }

  const std::string& name() const { return name_; }
  bool creeps() const { return material_.creeps(); }
  bool ruptures() const { return rupture_ != nullptr; }
  std::optional<double> young_modulus() const { return young_modulus_; }

  material::BarHistory creep(double stress, const std::vector<double>& times) const {
    return material::bar_history(material_.creep, {.stress = stress, .temperature = temperature_}, times);
  }
  material::BarHistory relaxation(double stress, const std::vector<double>& times) const {
    return material::bar_history(
        material_.creep, {.stress = stress, .temperature = temperature_, .young_modulus = young_modulus_.value()},
        times);
  }
  /// Infinite after rupture.
  double strain(double stress, double time) const {
    const material::BarHistory history = creep(stress, {time});
    return history.states.empty() ? std::numeric_limits<double>::infinity() : history.states.front().creep_strain;
  }
  /// The stress after which the strain is this at this time.
  double stress_of(double strain_then, double time) const {
    return solved([&](double stress) { return strain(stress, time) < strain_then; });
  }
  double rupture_strength(double time) const {
    return solved([&](double stress) { return rupture_->rate(stress, temperature_).value * time < 1; });
  }

 private:
  /// The largest stress that is low enough.
  template <class Low>
  static double solved(const Low& is_low) {
    double low = 10;  // near zero polynomials in the logarithm of the stress mean nothing
    while (low > 1e-3 && !is_low(low)) low /= 2;
    double high = 2 * low;
    while (high < 1e12 && is_low(high)) high *= 2;
    for (int i = 0; i < 60; ++i) {
      const double middle = std::sqrt(low * high);
      (is_low(middle) ? low : high) = middle;
    }
    return low;
  }

  std::string name_;
  double temperature_;
  material::Material material_;
  std::shared_ptr<const material::RuptureData> rupture_;
  std::optional<double> young_modulus_;
};

double two_digits(double value) {
  const double scale = std::pow(10, 1 - std::floor(std::log10(value)));
  return std::round(value * scale) / scale;
}

config::LibraryMaterial steel_of(const std::string& name) {
  const auto library = config::material_library(vocabulary().materials);
  const auto exact = std::ranges::find_if(library, [&](const config::LibraryMaterial& steel) {
    return steel.key == name || std::ranges::count(steel.also, name) > 0;
  });
  if (exact != library.end()) return *exact;
  const auto found = config::matching(library, name);
  if (found.size() == 1) return found.front();
  std::vector<std::string> keys;
  for (const auto& steel : found.empty() ? library : found) keys.push_back(steel.key);
  throw ConfigError(fmt::format("material: {} steel '{}'{} (there are: {})", found.empty() ? "no" : "more than one",
                                name, found.empty() ? did_you_mean(name, keys) : "", fmt::join(keys, ", ")));
}

/// Variants of which the program has all laws, and names of the others.
std::vector<VariantBar> bars_of(const config::LibraryMaterial& steel, const std::string& wanted, double T,
                                std::vector<std::string>& left_out) {
  std::vector<VariantBar> bars;
  for (const config::LibraryVariant& variant : steel.variants) {
    if (!wanted.empty() && variant.name != wanted) continue;
    const bool known = std::ranges::all_of(
        variant.laws, [](const std::string& law) { return material::find_creep_law(law) != nullptr; });
    if (known)
      bars.emplace_back(steel, variant, T);
    else
      left_out.push_back(variant.name);
  }
  return bars;
}

void add_points(plot::Series& series, const std::vector<double>& times, const material::BarHistory& history,
                double material::BarState::*value) {
  for (std::size_t i = 0; i < history.states.size(); ++i) {
    series.x.push_back(times[i]);
    series.y.push_back(history.states[i].*value);
  }
}

/// Pictures of some bars at one temperature.
class ViewFigures {
 public:
  ViewFigures(const config::LibraryMaterial& steel, const std::vector<VariantBar>& bars, std::string title)
      : units_(steel.units), bars_(bars), title_(std::move(title)), key_(steel.key) {}

  std::vector<plot::NamedFigure> figures(const std::vector<double>& stresses) const {
    std::vector<plot::NamedFigure> all;
    plot::Figure over_time{title_, {labelled("time", Dimension::time), true}, {}};
    const auto add = [&](const plot::Axis& y, std::vector<plot::Series> series) {
      std::erase_if(series, [](const plot::Series& one) { return one.x.empty(); });
      if (series.size() > plot::max_series) series.resize(plot::max_series);
      if (!series.empty()) over_time.panels.push_back({y, std::move(series)});
    };
    if (!stresses.empty()) {
      for (const double stress : stresses)
        add({fmt::format("strain, {}", with_unit(stress, Dimension::stress, units_)), true}, creep_curves(stress));
      add({labelled("held bar", Dimension::stress)}, relaxations(stresses.front()));
    }
    add({labelled("strength", Dimension::stress), true}, strengths());
    if (!over_time.panels.empty()) all.push_back({key_, over_time});
    if (!stresses.empty()) {
      plot::Panel curves{{labelled("stress", Dimension::stress)}, isochronous(stresses.front())};
      if (curves.series.size() > plot::max_series) curves.series.resize(plot::max_series);
      all.push_back({key_ + "_isochronous",
                     {title_ + ": isochronous curves",
                      {bars_.front().young_modulus() ? "strain" : "creep strain"},
                      {std::move(curves)}}});
    }
    return all;
  }

 private:
  std::string labelled(const std::string& what, Dimension dimension) const {
    return fmt::format("{} [{}]", what, unit_of(dimension, units_));
  }

  std::vector<plot::Series> creep_curves(double stress) const {
    std::vector<plot::Series> all;
    const std::vector<double> times = decades_of(1, longer, 8);
    for (const VariantBar& bar : bars_) {
      if (!bar.creeps()) continue;
      plot::Series series{bar.name(), {}, {}};
      add_points(series, times, bar.creep(stress, times), &material::BarState::creep_strain);
      all.push_back(std::move(series));
    }
    return all;
  }

  std::vector<plot::Series> relaxations(double stress) const {
    std::vector<plot::Series> all;
    const std::vector<double> times = decades_of(1, longer, 8);
    for (const VariantBar& bar : bars_) {
      if (!bar.creeps() || !bar.young_modulus()) continue;
      plot::Series series{bar.name(), {}, {}};
      add_points(series, times, bar.relaxation(stress, times), &material::BarState::stress);
      all.push_back(std::move(series));
    }
    return all;
  }

  std::vector<plot::Series> strengths() const {
    std::vector<plot::Series> all;
    for (const VariantBar& bar : bars_) {
      if (!bar.ruptures()) continue;
      plot::Series series{bar.name(), decades_of(100, longer, 4), {}};
      for (const double time : series.x) series.y.push_back(bar.rupture_strength(time));
      all.push_back(std::move(series));
    }
    return all;
  }

  std::vector<plot::Series> isochronous(double largest) const {
    constexpr int n_stresses = 24;
    std::vector<plot::Series> all;
    for (const VariantBar& bar : bars_) {
      if (!bar.creeps()) continue;
      plot::Series early{fmt::format("{}, {}", bar.name(), with_unit(shorter, Dimension::time, units_)), {0}, {0}},
          late{fmt::format("{}, {}", bar.name(), with_unit(longer, Dimension::time, units_)), {0}, {0}};
      for (int i = 1; i <= n_stresses; ++i) {
        const double stress = largest * i / n_stresses;
        const auto history = bar.creep(stress, {shorter, longer});
        constexpr double most = 0.03;
        for (std::size_t k = 0; k < history.states.size(); ++k) {
          plot::Series& series = k == 0 ? early : late;
          const double strain =
              history.states[k].creep_strain + (bar.young_modulus() ? stress / *bar.young_modulus() : 0);
          if (strain > most) continue;
          series.x.push_back(strain);
          series.y.push_back(stress);
        }
      }
      all.push_back(std::move(early));
      all.push_back(std::move(late));
    }
    return all;
  }

  std::string units_;
  const std::vector<VariantBar>& bars_;
  std::string title_, key_;
};

std::string view_cell(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : "rupture";
}

/// Numbers of each variant, columns as wide as their longest entry.
std::string view_table(const config::LibraryMaterial& steel, const std::vector<VariantBar>& bars,
                       const std::vector<double>& stresses) {
  const auto time = [&](double value) { return with_unit(value, Dimension::time, steel.units); };
  const auto stress = [&](double value) { return with_unit(value, Dimension::stress, steel.units); };
  std::vector<std::vector<std::string>> rows{{"variant"}};
  if (!stresses.empty())
    for (const double t : {shorter, longer})
      rows[0].push_back(fmt::format("strain, {}, {}", stress(stresses.back()), time(t)));
  if (!stresses.empty() && bars.front().young_modulus())
    rows[0].push_back(fmt::format("{} relaxed, {}", stress(stresses.front()), time(longer)));
  rows[0].push_back(fmt::format("rupture, {}", time(longer)));
  rows[0].emplace_back("status");
  for (const VariantBar& bar : bars) {
    std::vector<std::string> row{bar.name()};
    if (!stresses.empty())
      for (const double t : {shorter, longer})
        row.push_back(bar.creeps() ? view_cell(bar.strain(stresses.back(), t)) : "-");
    if (!stresses.empty() && bars.front().young_modulus())
      row.push_back(bar.creeps() ? stress(bar.relaxation(stresses.front(), {longer}).last.stress) : "-");
    row.push_back(bar.ruptures() ? stress(bar.rupture_strength(longer)) : "-");
    const auto variant = std::ranges::find(steel.variants, bar.name(), &config::LibraryVariant::name);
    row.push_back(steel.source(variant->source)->status);
    rows.push_back(std::move(row));
  }
  std::vector<std::size_t> width(rows[0].size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) text += fmt::format("{:<{}}  ", row[i], width[i]);
    text += row.back() + '\n';
  }
  return text;
}

}  // namespace

MaterialView material_view(const std::string& name, const MaterialViewOptions& options) {
  const config::LibraryMaterial steel = steel_of(name);
  std::vector<std::string> variants;
  for (const config::LibraryVariant& variant : steel.variants) variants.push_back(variant.name);
  if (!options.variant.empty() && std::ranges::count(variants, options.variant) == 0)
    throw ConfigError(fmt::format("--law: {} has no variant '{}'{} (there are: {})", steel.key, options.variant,
                                  did_you_mean(options.variant, variants), fmt::join(variants, ", ")));
  if (variants.empty())
    throw ConfigError(fmt::format("material: the library has no creep or rupture of {}", steel.key));
  const double T = options.temperature.value_or(steel.variants.front().checks.front().T);
  std::vector<std::string> left_out;
  const std::vector<VariantBar> bars = bars_of(steel, options.variant, T, left_out);
  MaterialView view;
  view.text =
      fmt::format("{} ({}) at {}\n", steel.name, steel.composition, with_unit(T, Dimension::temperature, steel.units));
  std::vector<double> stresses;
  const auto first = std::ranges::find_if(bars, &VariantBar::creeps);
  if (first != bars.end())
    for (const double time : {1e3, 1e4, 1e5}) stresses.push_back(two_digits(first->stress_of(0.01, time)));
  if (!bars.empty()) {
    view.text += view_table(steel, bars, stresses);
    view.figures =
        ViewFigures(steel, bars, fmt::format("{} at {}", steel.name, with_unit(T, Dimension::temperature, steel.units)))
            .figures(stresses);
  }
  if (!left_out.empty())
    view.text += fmt::format("left out, since the program lacks their laws: {}\n", fmt::join(left_out, ", "));
  return view;
}

}  // namespace creepcontact::run
