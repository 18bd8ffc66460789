#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/config/study.hpp"
#include "diagnostics.hpp"
#include "item.hpp"
#include "known_words.hpp"
#include "random_checks.hpp"
#include "toml_document.hpp"

namespace creepcontact::config {
namespace {

/// Axes by what varies on its own: one axis, or all of a zip. In the order of their first axes.
std::vector<std::vector<std::size_t>> independent(const std::vector<Axis>& axes) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto partners = std::find_if(groups.begin(), groups.end(),
                                       [&](const auto& group) { return run_together(axes[a], axes[group.front()]); });
    if (partners == groups.end())
      groups.push_back({a});
    else
      partners->push_back(a);
  }
  return groups;
}

/// All index tuples of the product.
std::vector<std::vector<int>> points(const std::vector<Axis>& axes) {
  std::vector<std::vector<int>> all{std::vector<int>(axes.size(), 0)};
  for (const std::vector<std::size_t>& group : independent(axes)) {
    std::vector<std::vector<int>> longer;
    for (const std::vector<int>& point : all) {
      for (std::size_t value = 0; value < axes[group.front()].values.size(); ++value) {
        longer.push_back(point);
        for (const std::size_t axis : group) longer.back()[axis] = static_cast<int>(value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

/// What a run's configuration has to complain of, each once, where the study says it.
class RunMistakes {
 public:
  explicit RunMistakes(Diagnostics& errors) : errors_(errors) {}

  /// @param message    one mistake per line: "--set key=value: ...", or of the base configuration itself
  /// @param elsewhere  of what makes the run
  void add(const std::string& message, const std::vector<Setting>& settings, const Location& elsewhere) {
    std::istringstream lines(message);
    for (std::string line; std::getline(lines, line);) {
      Location where = elsewhere;
      bool of_setting = false;
      for (const Setting& setting : settings) {
        const std::string begin = std::string(override_prefix) + setting.override_text() + ": ";
        if (!line.starts_with(begin)) continue;
        line.erase(0, begin.size());
        // A wrong key is wrong with all its values: it is named once, and itself.
        where = is_about_the_key(line) ? setting.key_location : setting.value.location;
        of_setting = true;
        break;
      }
      if (seen_.insert((of_setting ? where.prefix() : "") + line).second) errors_.add(where, line);
    }
  }

 private:
  static bool is_about_the_key(const std::string& line) {
    const auto has = [&](std::string_view text) { return line.find(text) != std::string::npos; };
    return has("unknown key") || (has(absent_feature) && !has("unknown "));
  }

  Diagnostics& errors_;
  std::set<std::string> seen_;
};

std::vector<std::vector<double>> sampled_values(const Random& random) {
  const std::vector<double> scores = scores_of(random);
  std::vector<std::vector<double>> all(random.n_samples());
  auto score = scores.begin();
  for (std::vector<double>& sample : all)
    for (const RandomKey& key : random.keys) sample.push_back(sampled_value(key, *score++));
  return all;
}

/// One run per combination of the axes; of very many combinations those in which one axis alone leaves its first value,
/// so that every value is among them, and some of the others.
std::vector<const PlannedRun*> runs_to_check(const std::vector<PlannedRun>& runs) {
  constexpr std::size_t most = 1000;
  std::vector<const PlannedRun*> combinations, chosen;
  for (const PlannedRun& run : runs)
    if (run.sample == 0) combinations.push_back(&run);
  if (combinations.size() <= most) return combinations;
  const std::size_t every = combinations.size() / most + 1;
  for (std::size_t i = 0; i < combinations.size(); ++i) {
    const std::vector<int>& point = combinations[i]->point;
    const bool is_of_one_axis = std::ranges::count_if(point, [](int value) { return value > 0; }) <= 1;
    if (is_of_one_axis || i % every == 0) chosen.push_back(combinations[i]);
  }
  return chosen;
}

}  // namespace

double n_runs(const Product& product) {
  double runs = 1;
  for (const std::vector<std::size_t>& group : independent(product.axes))
    runs *= static_cast<double>(product.axes[group.front()].values.size());
  return runs;
}

std::vector<PlannedRun> plan(const Study& study) {
  std::vector<PlannedRun> runs;
  const std::vector<Product> all = products(study);
  const std::size_t samples = study.random ? study.random->n_samples() : 1;
  const std::vector<std::vector<double>> sampled =
      study.random ? sampled_values(*study.random) : std::vector<std::vector<double>>(1);
  std::size_t combination = 0;
  for (std::size_t p = 0; p < all.size(); ++p)
    for (const std::vector<int>& point : points(all[p].axes)) {
      std::vector<Setting> settings = all[p].settings;
      for (std::size_t a = 0; a < point.size(); ++a) {
        const Axis& axis = all[p].axes[a];
        settings.push_back({axis.key.name, axis.key.location, axis.values[point[a]]});
      }
      for (std::size_t s = 0; s < samples; ++s)
        runs.push_back(PlannedRun{"", settings, p, point, s, combination, sampled[s]});
      ++combination;
    }
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i].name = fmt::format("run_{:03}", i + 1);
  return runs;
}

std::optional<PlannedRun> reference_run(const Study& study) {
  if (!study.reference || !study.reference->is_run()) return std::nullopt;
  return PlannedRun{"reference", study.reference->settings, 0, {}};
}

std::vector<Setting> settings_of(const Study& study, const PlannedRun& run) {
  std::vector<Setting> settings = run.settings;
  for (std::size_t k = 0; k < run.sampled.size(); ++k)
    settings.push_back(sampled_setting(study.random->keys[k], run.sampled[k]));
  return settings;
}

std::vector<std::string> overrides(const Study& study, const std::vector<Setting>& own) {
  std::vector<std::string> all;
  for (const Setting& setting : study.settings) all.push_back(setting.override_text());
  for (const Setting& setting : own) all.push_back(setting.override_text());
  return all;
}

std::vector<std::string> overrides(const Study& study, const PlannedRun& run) {
  return overrides(study, settings_of(study, run));
}

void check_runs(const Study& study, const std::vector<PlannedRun>& runs, const Vocabulary& vocabulary) {
  Diagnostics errors;
  RunMistakes mistakes(errors);
  std::set<std::string> missing;
  try {
    read_text(study.base);
  } catch (const ConfigError& error) {
    errors.add(study.base_location, error.what());
    errors.throw_if_any();
  }
  const auto check = [&](const std::vector<Setting>& own, const Location& where) {
    std::vector<Setting> settings = study.settings;
    settings.insert(settings.end(), own.begin(), own.end());
    try {
      const Config config = read(study.base, vocabulary, overrides(study, own));
      std::vector<std::string> probes;
      for (const Probe& probe : config.probes) probes.push_back(probe.name);
      for (const Reference& quantity : study.compare.quantities)
        if (std::find(probes.begin(), probes.end(), quantity.name) == probes.end() &&
            missing.insert(quantity.name).second)
          errors.add_unknown(quantity.location,
                             fmt::format("'{}' is not a probe of {}", quantity.name, study.base.string()),
                             quantity.name, probes);
    } catch (const ConfigError& error) {
      mistakes.add(error.what(), settings, where);
    }
  };
  if (study.reference && study.reference->is_run()) check(study.reference->settings, study.reference->location);
  const std::vector<Product> all = products(study);
  for (const PlannedRun* run : runs_to_check(runs)) check(run->settings, all[run->product].location);
  if (study.random && errors.empty()) check_random_keys(study, runs.front().settings, vocabulary, errors);
  errors.throw_if_any();
}

std::vector<Reference> compared_probes(const Study& study, const Vocabulary& vocabulary) {
  if (!study.compare.quantities.empty() || !study.random) return study.compare.quantities;
  std::vector<Reference> probes;
  for (const Probe& probe : read(study.base, vocabulary, overrides(study, std::vector<Setting>())).probes)
    probes.push_back({probe.name, {}});
  return probes;
}

}  // namespace creepcontact::config
