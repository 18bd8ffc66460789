#include "random_table.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "creepcontact/config/dotted_key.hpp"
#include "fitted_scatter.hpp"
#include "table.hpp"

namespace creepcontact::config {
namespace {

enum class DistributionKind { normal, lognormal, uniform, triangular, table };
constexpr auto names_of(DistributionKind) {
  return std::to_array<settings::EnumName<DistributionKind>>({{"normal", DistributionKind::normal},
                                                              {"lognormal", DistributionKind::lognormal},
                                                              {"uniform", DistributionKind::uniform},
                                                              {"triangular", DistributionKind::triangular},
                                                              {"table", DistributionKind::table}});
}

/// As in the file.
struct GivenKey {
  Reference key;
  std::optional<DistributionKind> kind;
  std::optional<double> median, factor, mean, deviation, min, mode, max;
  std::vector<double> values, weights, cumulative;
  std::filesystem::path fit;
};

/// The keys of a distribution, and those that it need not have.
struct Demand {
  std::vector<std::string> required, optional = {};
};

Demand demand_of(DistributionKind kind) {
  switch (kind) {
    case DistributionKind::normal:
      return {{"mean", "deviation"}};
    case DistributionKind::lognormal:
      return {{"median", "factor"}};
    case DistributionKind::uniform:
      return {{"min", "max"}};
    case DistributionKind::triangular:
      return {{"min", "mode", "max"}};
    case DistributionKind::table:
      break;
  }
  return {{"values"}, {"weights", "cumulative"}};
}

/// Only the keys that the distribution takes, and all that it needs. @returns whether it is so
bool has_its_keys(const Item& item, DistributionKind kind, Context& context) {
  const Demand demand = demand_of(kind);
  std::vector<std::string> taken{"key", "distribution"};
  taken.insert(taken.end(), demand.required.begin(), demand.required.end());
  taken.insert(taken.end(), demand.optional.begin(), demand.optional.end());
  bool fits = true;
  for (const std::string& key : demand.required) {
    if (item.has(key)) continue;
    context.errors.add(item.child("distribution").location,
                       fmt::format("the distribution \"{}\" needs '{}'", settings::name_of(kind), key));
    fits = false;
  }
  for (const auto& [key, node] : *item.node->as_table()) {
    if (std::ranges::count(taken, key.str()) > 0) continue;
    context.errors.add(item.child(key.str()).location,
                       fmt::format("the distribution \"{}\" has no '{}'", settings::name_of(kind), key.str()),
                       fmt::format("'{}'", fmt::join(demand.required, "', '")));
    fits = false;
  }
  return fits;
}

/// Sorted by value, with the shares added up. @returns nullopt after a mistake
std::optional<statistics::Table> table_of(const GivenKey& given, const Item& item, Context& context) {
  const auto mistake = [&](const char* key, const std::string& found, const std::string& allowed) {
    context.errors.add(item.child(key).location, found, allowed);
    return std::nullopt;
  };
  const std::size_t n = given.values.size();
  if (n < 2) return mistake("values", fmt::format("{} values", n), "at least two");
  if (item.has("weights") && item.has("cumulative"))
    return mistake("weights", "'weights' and 'cumulative'", "one of them, or none: all values occur equally often");
  if (item.has("cumulative")) {
    const std::vector<double>& p = given.cumulative;
    if (p.size() != n)
      return mistake("cumulative", fmt::format("{} probabilities for {} values", p.size(), n), "one per value");
    if (!std::ranges::is_sorted(p) || p.front() != 0 || p.back() != 1)
      return mistake("cumulative", fmt::format("{}", fmt::join(p, ", ")), "from 0 to 1, in ascending order");
    if (std::ranges::adjacent_find(given.values, std::greater_equal()) != given.values.end())
      return mistake("values", fmt::format("{}", fmt::join(given.values, ", ")),
                     "ascending numbers, with 'cumulative'");
    return statistics::Table{given.values, p, true};
  }
  std::vector<double> weights = given.weights.empty() ? std::vector<double>(n, 1.0) : given.weights;
  if (weights.size() != n)
    return mistake("weights", fmt::format("{} weights for {} values", weights.size(), n), "one per value");
  std::map<double, double> shares;
  for (std::size_t i = 0; i < n; ++i) shares[given.values[i]] += weights[i];
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(total > 0)) return mistake("weights", "no weight above 0", "weights of at least 0, with one above");
  statistics::Table table;
  double sum = 0;
  for (const auto& [value, share] : shares) {
    sum += share;
    table.values.push_back(value);
    table.cumulative.push_back(sum / total);
  }
  table.cumulative.back() = 1;
  return table;
}

std::optional<statistics::Distribution> distribution_of(const GivenKey& given, const Item& item, Context& context) {
  const auto mistake = [&](const char* key, const std::string& found, const std::string& allowed) {
    context.errors.add(item.child(key).location, found, allowed);
    return std::nullopt;
  };
  switch (*given.kind) {
    case DistributionKind::normal:
      return statistics::Normal{*given.mean, *given.deviation};
    case DistributionKind::lognormal:
      return statistics::Lognormal{*given.median, *given.factor};
    case DistributionKind::uniform:
      if (!(*given.min < *given.max))
        return mistake("max", fmt::format("{}", *given.max), fmt::format("a number above min = {}", *given.min));
      return statistics::Uniform{*given.min, *given.max};
    case DistributionKind::triangular:
      if (!(*given.min < *given.max))
        return mistake("max", fmt::format("{}", *given.max), fmt::format("a number above min = {}", *given.min));
      if (!(*given.min <= *given.mode && *given.mode <= *given.max))
        return mistake("mode", fmt::format("{}", *given.mode), fmt::format("from {} to {}", *given.min, *given.max));
      return statistics::Triangular{*given.min, *given.mode, *given.max};
    case DistributionKind::table:
      break;
  }
  const auto table = table_of(given, item, context);
  return table ? std::optional<statistics::Distribution>(*table) : std::nullopt;
}

/// Keys as they are in the file: one with `fit` means several.
struct KeysOfEntry {
  std::vector<RandomKey> keys;
  std::vector<RandomCorrelation> correlations;
};

std::optional<KeysOfEntry> keys_of_fit(const GivenKey& given, const Item& item, Context& context) {
  for (const auto& [key, node] : *item.node->as_table()) {
    if (key == "key" || key == "fit") continue;
    context.errors.add(item.child(key.str()).location, fmt::format("'{}' together with 'fit'", key.str()),
                       "'key' and 'fit': the distributions are in that file");
    return std::nullopt;
  }
  KeysOfEntry all;
  const Location place = item.child("fit").location;
  const auto fitted = read_fitted_scatter(given.fit, place, context.errors);
  if (!fitted) return std::nullopt;
  for (const FittedConstant& constant : fitted->constants) {
    RandomKey& key = all.keys.emplace_back();
    key.key = {given.key.name + '.' + constant.key, given.key.location};
    key.location = item.location;
    key.fitted = constant.value;
    key.kind = constant.is_logarithmic ? "lognormal" : "normal";
    if (constant.is_logarithmic)
      key.distribution = statistics::Lognormal{constant.value, std::exp(constant.deviation)};
    else
      key.distribution = statistics::Normal{constant.value, constant.deviation};
  }
  for (std::size_t i = 0; i < all.keys.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const double value = fitted->correlation[i][j]; value != 0)
        all.correlations.push_back({{all.keys[i].key, all.keys[j].key}, value, place});
  return all;
}

Value<KeysOfEntry> random_key_table() {
  const auto keys = table<GivenKey>({
      field<GivenKey>("key", &GivenKey::key, reference("a key of the configuration, \"materials.rotor.creep[0].A\""),
                      "key that is distributed, written as for `--set`; with `fit` the table of a creep law, "
                      "`materials.rotor.creep[0]`",
                      Presence::required),
      field<GivenKey>("distribution", &GivenKey::kind, choice<DistributionKind>("distribution"),
                      "kind of the distribution")
          .otherwise("*required*, except with `fit`"),
      field<GivenKey>("median", &GivenKey::median, number(greater(0)), "lognormal: half of the values are below it"),
      field<GivenKey>("factor", &GivenKey::factor, number(greater(1)),
                      "lognormal: one standard deviation of the logarithm is ln(factor), so that 68 % of the values "
                      "are between median/factor and median x factor"),
      field<GivenKey>("mean", &GivenKey::mean, number(), "normal: mean"),
      field<GivenKey>("deviation", &GivenKey::deviation, number(greater(0)), "normal: standard deviation"),
      field<GivenKey>("min", &GivenKey::min, number(), "uniform, triangular: smallest value"),
      field<GivenKey>("mode", &GivenKey::mode, number(), "triangular: most frequent value"),
      field<GivenKey>("max", &GivenKey::max, number(), "uniform, triangular: largest value"),
      field<GivenKey>("values", &GivenKey::values, list(number()), "table: measured values"),
      field<GivenKey>("weights", &GivenKey::weights, list(number(at_least(0))), "table: how often each value occurs")
          .otherwise("all equally often"),
      field<GivenKey>("cumulative", &GivenKey::cumulative, list(number({.min = 0, .max = 1})),
                      "table: instead of weights, the probability of at most each value, from 0 to 1; all numbers "
                      "between the values then occur too"),
      field<GivenKey>("fit", &GivenKey::fit, path(),
                      "instead of a distribution: the constants of a law with the scatter that `creepcontact fit` "
                      "found, the file `NAME_scatter.toml` that it writes"),
  });
  return converted<KeysOfEntry>(
      keys,
      [](GivenKey given, const Item& item, Context& context) -> std::optional<KeysOfEntry> {
        if (item.has("fit")) return given.fit.empty() ? std::nullopt : keys_of_fit(given, item, context);
        if (!item.has("distribution")) {
          context.errors.add(item.location, "no distribution", "'distribution' or 'fit'");
          return std::nullopt;
        }
        if (!given.kind || !has_its_keys(item, *given.kind, context)) return std::nullopt;
        const auto is_wrong = [&](const std::string& key) {  // told when it was read
          const std::map<std::string, bool> found{
              {"mean", given.mean.has_value()},     {"deviation", given.deviation.has_value()},
              {"median", given.median.has_value()}, {"factor", given.factor.has_value()},
              {"min", given.min.has_value()},       {"mode", given.mode.has_value()},
              {"max", given.max.has_value()},       {"values", true}};
          return !found.at(key);
        };
        if (std::ranges::any_of(demand_of(*given.kind).required, is_wrong)) return std::nullopt;
        const auto distribution = distribution_of(given, item, context);
        if (!distribution) return std::nullopt;
        return KeysOfEntry{{{given.key, *distribution, std::string(settings::name_of(*given.kind)), item.location}},
                           {}};
      },
      [](const KeysOfEntry&) { return GivenKey(); });
}

Value<RandomCorrelation> correlation_table() {
  const auto keys = table<RandomCorrelation>({
      field<RandomCorrelation>("keys", &RandomCorrelation::keys, list(reference("a key of [[random.keys]]")),
                               "two keys of `[[random.keys]]`", Presence::required),
      field<RandomCorrelation>("value", &RandomCorrelation::value,
                               number({.min = -1, .max = 1, .open_min = true, .open_max = true}),
                               "their correlation; that of the logarithms for lognormal keys", Presence::required),
  });
  return converted<RandomCorrelation>(
      keys, [](RandomCorrelation one, const Item& item, Context& context) -> std::optional<RandomCorrelation> {
        one.location = item.location;
        if (one.keys.size() == 2) return one;
        if (item.has("keys") && item.child("keys").node->is_array())
          context.errors.add(item.child("keys").location, fmt::format("{} keys", one.keys.size()), "two keys");
        return std::nullopt;
      });
}

/// [random] with its keys as they are in the file.
struct GivenRandom : Random {
  std::vector<KeysOfEntry> entries;
};

std::size_t index_of(const std::vector<RandomKey>& keys, const std::string& name) {
  const auto found =
      std::ranges::find_if(keys, [&](const RandomKey& key) { return parts_of(key.key.name) == parts_of(name); });
  return static_cast<std::size_t>(found - keys.begin());
}

void add_correlations(Random& random, Diagnostics& errors) {
  const std::size_t n = random.keys.size();
  std::vector<std::string> names;
  for (const RandomKey& key : random.keys) names.push_back(key.key.name);
  std::vector<double> matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] = 1;
  bool is_known = true;
  for (const RandomCorrelation& one : random.correlations) {
    const std::size_t a = index_of(random.keys, one.keys[0].name), b = index_of(random.keys, one.keys[1].name);
    for (const Reference& key : one.keys)
      if (index_of(random.keys, key.name) == n) {
        errors.add_unknown(key.location, fmt::format("'{}' is not a key of [[random.keys]]", key.name), key.name,
                           names);
        is_known = false;
      }
    if (!is_known) continue;
    if (a == b || matrix[a * n + b] != 0) {
      errors.add(one.location,
                 a == b ? fmt::format("'{}' twice", one.keys[0].name)
                        : fmt::format("'{}' and '{}' already have a correlation", one.keys[0].name, one.keys[1].name),
                 "two different keys, each pair once");
      is_known = false;
      continue;
    }
    matrix[a * n + b] = matrix[b * n + a] = one.value;
  }
  if (!is_known || random.correlations.empty()) return;
  random.factor = statistics::correlation_factor(matrix, n);
  if (random.factor.empty())
    errors.add(random.correlations.back().location,
               "these correlations contradict each other: their matrix is not positive definite (if a goes with b and "
               "b with c, then a goes with c)",
               "correlations of smaller magnitude, or the missing ones between the other pairs");
}

}  // namespace

Value<Random> random_table() {
  const auto keys = table<GivenRandom>({
      field<GivenRandom>("samples", &Random::samples, integer(2, 100'000),
                         "number of runs for each combination of axes", Presence::required),
      field<GivenRandom>(
          "method", &Random::method, choice<statistics::SamplingMethod>("method"),
          "how the samples are spread: evenly in all keys at once, evenly in each key, or independently"),
      field<GivenRandom>("seed", &Random::seed, integer(0), "another seed gives other samples, the same one the same"),
      field<GivenRandom>("quantiles", &Random::quantiles,
                         list(number({.min = 0, .max = 1, .open_min = true, .open_max = true})),
                         "probabilities, ascending, of the columns of `quantiles.csv`"),
      field<GivenRandom>("keys", &GivenRandom::entries, tables(random_key_table()), "what is distributed"),
      field<GivenRandom>("correlations", &Random::correlations, tables(correlation_table()),
                         "keys that vary together; others are independent"),
  });
  return converted<Random>(
      keys,
      [](GivenRandom read, const Item& item, Context& context) -> std::optional<Random> {
        Random random = read;
        random.location = item.location;
        for (KeysOfEntry& entry : read.entries) {
          random.keys.insert(random.keys.end(), entry.keys.begin(), entry.keys.end());
          random.correlations.insert(random.correlations.end(), entry.correlations.begin(), entry.correlations.end());
        }
        if (!item.has("keys")) context.errors.add(item.location, "nothing is distributed", "[[random.keys]]");
        if (random.quantiles.empty())
          context.errors.add(item.child("quantiles").location, "an empty list",
                             "ascending probabilities, at least one");
        if (std::ranges::adjacent_find(random.quantiles, std::greater_equal()) != random.quantiles.end())
          context.errors.add(item.child("quantiles").location, fmt::format("{}", fmt::join(random.quantiles, ", ")),
                             "ascending probabilities");
        return random;
      },
      [](const Random&) { return GivenRandom(); });
}

void check_random(Study& study, Diagnostics& errors) {
  if (!study.random) return;
  Random& random = *study.random;
  for (auto key = random.keys.begin(); key != random.keys.end(); ++key) {
    const std::vector<std::string> parts = parts_of(key->key.name);
    if (parts.front() == "mesh")
      errors.add(key->key.location, fmt::format("'{}': every sample would have a mesh of its own", key->key.name),
                 "keys outside [mesh]; give meshes apart as runs with [[axes]], whose combinations all get the same "
                 "samples");
    if (parts.front() == "time" || parts.front() == "output")
      errors.add(key->key.location,
                 fmt::format("'{}': samples would be compared at times or with errors of their own", key->key.name),
                 "keys that describe the model");
    const auto overlaps = [&](const std::string& other) {
      return is_within(parts, parts_of(other)) || is_within(parts_of(other), parts);
    };
    const auto before =
        std::find_if(random.keys.begin(), key, [&](const RandomKey& other) { return overlaps(other.key.name); });
    if (before != key)
      errors.add(key->key.location,
                 fmt::format("'{}' is already distributed, in line {}", key->key.name, before->key.location.line));
    for (const Product& product : products(study)) {
      for (const Axis& axis : product.axes)
        if (overlaps(axis.key.name))
          errors.add(key->key.location,
                     fmt::format("'{}' also has an axis, in line {}", key->key.name, axis.key.location.line),
                     "values on an axis, or a distribution");
      for (const Setting& setting : product.settings)
        if (overlaps(setting.key))
          errors.add(key->key.location,
                     fmt::format("'{}' is also set in [[runs]], in line {}", key->key.name, setting.key_location.line),
                     "a value in [[runs]], or a distribution");
    }
  }
  if (random.keys.size() > statistics::max_dimensions)
    errors.add(random.location, fmt::format("{} keys", random.keys.size()),
               fmt::format("at most {}", statistics::max_dimensions));
  if (errors.empty()) add_correlations(random, errors);
}

}  // namespace creepcontact::config
