#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/config/dotted_key.hpp"
#include "creepcontact/config/study.hpp"
#include "random_table.hpp"
#include "study_tables.hpp"
#include "toml_document.hpp"

namespace creepcontact::config {
namespace {

void check_axes(const Product& product, Diagnostics& errors) {
  for (auto axis = product.axes.begin(); axis != product.axes.end(); ++axis) {
    for (auto other = product.axes.begin(); other != axis; ++other) {
      if (axis->key.given() && parts_of(axis->key.name) == parts_of(other->key.name))
        errors.add(axis->key.location,
                   fmt::format("'{}' already has an axis, in line {}", axis->key.name, other->key.location.line));
      if (axis->zip.empty() || axis->zip != other->zip || axis->values.empty() || other->values.empty()) continue;
      if (axis->values.size() != other->values.size())
        errors.add(axis->location,
                   fmt::format("{} values of '{}' and {} of '{}', which vary together (zip = \"{}\")",
                               axis->values.size(), axis->key.name, other->values.size(), other->key.name, axis->zip),
                   "equally many values on all axes with the same zip");
      break;
    }
  }
}

void check_size(const Study& study, Diagnostics& errors) {
  constexpr double most = 100'000;
  const double samples = study.random ? std::max(1, study.random->samples) : 1;
  double runs = 0;
  for (const Product& product : products(study)) {
    runs += samples * n_runs(product);
    if (runs <= most) continue;
    const std::string found = samples > 1 ? fmt::format("{:.6g} combinations of {:.0f} samples each are {:.6g} runs",
                                                        runs / samples, samples, runs)
                                          : fmt::format("the combinations of these axes are {:.6g} runs", runs);
    errors.add(
        product.location, found,
        fmt::format("at most {:.0f} runs in a study; axes with the same zip vary together, which gives fewer runs",
                    most));
    return;
  }
  constexpr double most_values = 1e7;  // some hundred megabytes
  const double keys = study.random ? static_cast<double>(study.random->keys.size()) : 0;
  if (runs * keys > most_values)
    errors.add(study.random->location, fmt::format("{:.6g} runs with {:.0f} random keys each", runs, keys),
               fmt::format("at most {:.0f} values of random keys in all", most_values));
}

void check_plot(const Study& study, Diagnostics& errors) {
  std::vector<std::string> keys, numeric;
  for (const Product& product : products(study))
    for (const Axis& axis : product.axes) {
      keys.push_back(axis.key.name);
      if (!numbers(axis).empty()) numeric.push_back(axis.key.name);
    }
  for (const Reference& key : study.plot.over) {
    if (std::find(keys.begin(), keys.end(), key.name) == keys.end())
      errors.add_unknown(key.location, fmt::format("'{}' is not a key of an axis", key.name), key.name, keys);
    else if (std::find(numeric.begin(), numeric.end(), key.name) == numeric.end())
      errors.add(key.location, fmt::format("the values of '{}' are not numbers", key.name), "axes of numbers");
  }
}

void check_comparison(const Study& study, const Item& root, Diagnostics& errors) {
  const bool reference = root.has("reference"), compare = root.has("compare");
  if (reference && !compare)
    errors.add(root.child("reference").location, "nothing is compared with it", "[reference] and [compare] together");
  if (!reference && root.child("compare").has("norm"))
    errors.add(root.child("compare").child("norm").location, "a norm of errors, but nothing to compare with",
               "'norm' together with [reference]");
  if (root.child("compare").has("quantities") && study.compare.quantities.empty() && errors.empty())
    errors.add(root.child("compare").child("quantities").location, "an empty list", "at least one probe");
  if (!study.reference || study.reference->expressions.empty()) return;
  std::vector<std::string> names;
  for (const auto& [name, expression] : study.reference->expressions) names.push_back(name);
  for (const Reference& quantity : study.compare.quantities)
    if (!study.reference->expressions.contains(quantity.name))
      errors.add_unknown(quantity.location, fmt::format("'{}' has no expression in [reference]", quantity.name),
                         quantity.name, names);
}

std::string text_of(const toml::table& document) {
  std::ostringstream text;
  text << document << '\n';
  return text.str();
}

toml::table as_table(const RandomKey& key) {
  toml::table table{{"key", key.key.name}, {"distribution", key.kind}};
  if (const auto* normal = std::get_if<statistics::Normal>(&key.distribution)) {
    table.insert("mean", normal->mean);
    table.insert("deviation", normal->deviation);
  } else if (const auto* lognormal = std::get_if<statistics::Lognormal>(&key.distribution)) {
    table.insert("median", lognormal->median);
    table.insert("factor", lognormal->factor);
  }
  return table;
}

/// Writes distributions for the files of fits: the runs depend on what these hold, wherever they are.
void replace_fits(const Study& study, toml::table& document) {
  if (!study.random) return;
  toml::array* const entries = document["random"]["keys"].as_array();
  if (entries == nullptr) return;
  if (std::ranges::none_of(study.random->keys, [](const RandomKey& key) { return key.fitted.has_value(); })) return;
  toml::array keys, correlations;
  auto next = study.random->keys.begin();
  for (const toml::node& entry : *entries) {
    if (!entry.as_table()->contains("fit")) {
      keys.push_back(*entry.as_table());
      ++next;
      continue;
    }
    const int line = next->location.line;
    for (; next != study.random->keys.end() && next->fitted && next->location.line == line; ++next)
      keys.push_back(as_table(*next));
  }
  for (const RandomCorrelation& one : study.random->correlations)
    correlations.push_back(
        toml::table{{"keys", toml::array{one.keys[0].name, one.keys[1].name}}, {"value", one.value}});
  document["random"].as_table()->insert_or_assign("keys", std::move(keys));
  document["random"].as_table()->insert_or_assign("correlations", std::move(correlations));
}

/// Names and pictures may change without another run.
std::string what_is_run(toml::table document) {
  document.erase("title");
  document.erase("plot");
  document.erase("keep");
  if (auto* random = document["random"].as_table()) random->erase("quantiles");
  if (auto* runs = document["runs"].as_array())
    for (toml::node& one : *runs)
      if (auto* table = one.as_table()) table->erase("label");
  return text_of(document);
}

/// With more samples the runs that there are stay the same, if the method draws the same first ones.
std::string what_is_run_apart_from_size(toml::table document, const Study& study) {
  if (study.random && study.random->method != statistics::SamplingMethod::latin_hypercube)
    document["random"].as_table()->erase("samples");
  return what_is_run(std::move(document));
}

void require_no_run(const toml::table& document, const std::filesystem::path& file) {
  if (document.contains("base") || !(document.contains("mesh") || document.contains("bodies"))) return;
  throw ConfigError(fmt::format(
      "{0}: this file describes a single run, not a study; compute it with: creepcontact run {0}", file.string()));
}

}  // namespace

Study parse_study(const std::string& text, const std::filesystem::path& file) {
  toml::table document = parse_toml(text, file, study_schema);
  require_no_run(document, file);
  Context context{file.parent_path(), {}};
  const Item root{&document, {.file = file.string(), .line = 1, .column = 1}};
  Study study = study_table().read(root, context).value();
  for (const Product& product : products(study)) check_axes(product, context.errors);
  check_size(study, context.errors);
  check_plot(study, context.errors);
  check_comparison(study, root, context.errors);
  check_random(study, context.errors);
  if (!root.has("axes") && !root.has("runs") && !root.has("random"))
    context.errors.add(root.location, "no runs", "[[axes]], [[runs]] or [random]");
  context.errors.throw_if_any();
  study.file = file;
  study.base_location = root.child("base").location;
  replace_fits(study, document);
  study.normalized = what_is_run(document);
  study.without_size = what_is_run_apart_from_size(document, study);
  return study;
}

Study read_study(const std::filesystem::path& file) {
  return parse_study(read_text(file), file);
}

}  // namespace creepcontact::config
