#include "gasket_tables.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <utility>

#include "material_tables.hpp"

namespace creepcontact::deck {
namespace {

using Rows = std::vector<std::vector<double>>;

config::GasketCurve curve_of(const Rows& rows) {
  config::GasketCurve curve;
  for (const auto& row : rows) {
    curve.pressure.push_back(rounded(row[0]));
    curve.closure.push_back(rounded(row[1]));
  }
  return curve;
}

bool is_curve(const config::GasketCurve& curve) {
  return curve.pressure.size() >= 2 && curve.pressure.front() == 0 && is_increasing(curve.pressure) &&
         is_increasing(curve.closure);
}

/// Rows by their temperature.
std::map<double, Rows> by_temperature(const Table& table, std::size_t column) {
  std::map<double, Rows> result;
  for (const auto& row : table.rows) result[row[column]].push_back(row);
  return result;
}

/// Place of the last point of a loading curve up to which it is elastic: where the slope first drops below the largest
/// so far.
std::size_t onset_of_yield(const config::GasketCurve& loading, const GasketBehavior& of) {
  double largest = 0;
  for (std::size_t i = 1; i < loading.closure.size(); ++i) {
    if (of.yield_onset) {
      if (loading.closure[i] >= *of.yield_onset) return i;
      continue;
    }
    const double slope =
        (loading.pressure[i] - loading.pressure[i - 1]) / (loading.closure[i] - loading.closure[i - 1]);
    if (slope < (1 - of.slope_drop) * largest) return i - 1;
    largest = std::max(largest, slope);
  }
  return loading.closure.size() - 1;
}

class GasketMaker {
 public:
  GasketMaker(Draft& draft, const GasketBehavior& behavior) : draft_(draft), behavior_(behavior) {}

  bool set_curves(config::Gasket& made) {
    if (!behavior_.loading) {
      refuse(behavior_.material.place, "GASKET BEHAVIOR",
             fmt::format("'{}' has no *GASKET THICKNESS BEHAVIOR", behavior_.material.name));
      return false;
    }
    const auto loading = by_temperature(*behavior_.loading, 2);
    const auto unloading = behavior_.unloading ? by_temperature(*behavior_.unloading, 3) : std::map<double, Rows>();
    const bool varies = loading.size() > 1;
    if (varies) draft_.varies = true;
    for (const auto& [T, rows] : loading) {
      config::GasketCurve curve = curve_of(rows);
      if (!is_curve(curve))
        return refuse_curve(*behavior_.loading,
                            "expected at least two rows of a pressure and a closure that increase, the first one with "
                            "the pressure 0");
      if (varies) curve.T = T;
      made.loading.push_back(std::move(curve));
    }
    for (std::size_t i = 0; i < made.loading.size(); ++i) {
      const auto found = varies && unloading.size() > 1 ? unloading.find(*made.loading[i].T) : unloading.begin();
      if (unloading.size() > 1 && (!varies || found == unloading.end() || unloading.size() != loading.size()))
        return refuse_curve(*behavior_.unloading, "its temperatures are not those of the loading");
      if (!set_unloading(made.loading[i], unloading.empty() ? Rows() : found->second, made)) return false;
    }
    return true;
  }

 private:
  bool set_unloading(const config::GasketCurve& loading, const Rows& rows, config::Gasket& made) {
    const std::size_t onset = onset_of_yield(loading, behavior_);
    const bool is_elastic = !behavior_.is_damage && onset + 1 == loading.closure.size();
    if (rows.empty()) {
      if (is_elastic) return true;  // it unloads as it loads
      return refuse_curve(*behavior_.loading,
                          "there is no DIRECTION=UNLOADING, and how the gasket unloads decides the pressure that is "
                          "left; give its curves, or [gaskets.<name>] with 'unloading' by hand");
    }
    config::GasketUnloading unloading;
    unloading.T = loading.T;
    // As long as it is elastic it comes back along the loading curve.
    for (std::size_t i = 1; i <= onset && !behavior_.is_damage; ++i) {
      config::GasketCurve& elastic = unloading.curves.emplace_back();
      const auto end = static_cast<std::ptrdiff_t>(i) + 1;
      elastic.closure.assign(loading.closure.begin(), loading.closure.begin() + end);
      elastic.pressure.assign(loading.pressure.begin(), loading.pressure.begin() + end);
    }
    std::map<double, Rows> curves;  // by the residual closure, or the largest one
    for (const auto& row : rows) curves[row[2]].push_back(row);
    for (auto& [key, own] : curves) {
      std::ranges::sort(own, {}, [](const auto& row) { return row[1]; });
      config::GasketCurve curve = curve_of(own);
      if (!curve.pressure.empty() && curve.pressure.front() > 0) {
        curve.pressure.insert(curve.pressure.begin(), 0);
        curve.closure.insert(curve.closure.begin(), behavior_.is_damage ? 0 : rounded(key));
      }
      if (!is_curve(curve))
        return refuse_curve(*behavior_.unloading,
                            "expected curves whose pressures and closures increase, each with its residual closure "
                            "(TYPE=DAMAGE: its largest closure) in the third place");
      if (!unloading.curves.empty() && !(curve.closure.back() > unloading.curves.back().closure.back()))
        continue;  // below the onset of yield
      unloading.curves.push_back(std::move(curve));
    }
    made.unloading.push_back(std::move(unloading));
    return true;
  }

  void refuse(const Place& place, const std::string& card, const std::string& why) {
    draft_.impossible.push_back({place, card, why});
  }
  bool refuse_curve(const Table& table, const std::string& why) {
    refuse(table.place, "GASKET THICKNESS BEHAVIOR", why);
    return false;
  }

  Draft& draft_;
  const GasketBehavior& behavior_;
};

}  // namespace

std::string name_of_gasket(const Draft& draft, const std::string& wanted) {
  std::string name;
  for (const char letter : wanted) name += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
  const auto is_taken = [&](const std::string& one) {
    return std::ranges::find(draft.config.gaskets, one, &config::Gasket::name) != draft.config.gaskets.end();
  };
  std::string free = name;
  for (int i = 2; is_taken(free); ++i) free = fmt::format("{}_{}", name, i);
  return free;
}

std::string make_gasket(Draft& draft, const GasketLayer& layer) {
  const GasketSection& section = layer.section;
  const auto refuse = [&](const std::string& why) {
    draft.impossible.push_back({section.place, "GASKET SECTION", why});
    return std::string();
  };
  const auto found = draft.deck.gasket_behaviors.find(section.behavior);
  if (found == draft.deck.gasket_behaviors.end())
    return refuse(fmt::format("there is no *GASKET BEHAVIOR '{}'", section.behavior));
  const double thickness = rounded(layer.thickness - section.gap - section.space);
  if (!(thickness > 0))
    return refuse(
        fmt::format("the thickness {:.6g} less the gap {:.6g} and the void {:.6g} is not positive; give the "
                    "thickness in the first field",
                    layer.thickness, section.gap, section.space));
  const Material& material = found->second.material;
  for (const config::Gasket& known : draft.config.gaskets)
    if (known.thickness == thickness && draft.comments.beside["gaskets." + known.name] == material.place.text())
      return known.name;
  config::Gasket made;
  made.name = name_of_gasket(draft, material.name);
  made.thickness = thickness;
  if (!GasketMaker(draft, found->second).set_curves(made)) return "";
  const std::string key = "gaskets." + made.name;
  draft.comment(key, material.place.text());
  if (const auto expansion = expansion_of(draft, material)) {
    made.thermal_expansion = *expansion;
    made.reference_temperature = rounded(draft.loading.initial_temperature);
  }
  make_creep(draft, material, "gasket does not creep", made.creep, key);
  draft.config.gaskets.push_back(std::move(made));
  return draft.config.gaskets.back().name;
}

}  // namespace creepcontact::deck
