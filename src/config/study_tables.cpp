/// The keys of a study.

#include "study_tables.hpp"

#include <algorithm>
#include <vector>

#include "random_table.hpp"
#include "table.hpp"
#include "toml_text.hpp"

namespace creepcontact::config {
namespace {

/// Shortest text that reads back to the same number; toml++ writes 17 digits.
std::string number_text(double number) {
  const std::string text = fmt::format("{}", number);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string leaf_text(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return number_text(number->get());
  return printed(node);
}

StudyValue study_value(const Item& item) {
  const std::string text = toml_text(*item.node, leaf_text);
  const auto* word = item.node->as_string();
  return {text, word ? word->get() : text, item.location};
}

Value<StudyValue> any_value() {
  Value<StudyValue> value{.type = "a value of the configuration", .read = {}};
  value.read = [](const Item& item, Context&) { return std::optional(study_value(item)); };
  return value;
}

/// "time.step" = 1 and time.step = 1 mean the same.
void append_settings(const Item& item, const std::string& path, std::vector<Setting>& all) {
  for (const auto& [key, node] : *item.node->as_table()) {
    const Item child = item.child(key.str());
    const std::string below = join_key(path, path_part(key.str()));
    if (node.is_table() && !node.as_table()->is_inline())
      append_settings(child, below, all);
    else
      all.push_back({below, locate(key.source(), child.location.key, child.location), study_value(child)});
  }
}

Value<std::vector<Setting>> settings() {
  Value<std::vector<Setting>> value{.type = "a table of keys of the configuration and their values", .read = {}};
  value.read = [type = value.type](const Item& item, Context& context) -> std::optional<std::vector<Setting>> {
    if (!item.node->is_table()) {
      context.errors.add(item.location, describe(*item.node), type);
      return std::nullopt;
    }
    std::vector<Setting> all;
    append_settings(item, "", all);
    std::stable_sort(all.begin(), all.end(), [](const Setting& a, const Setting& b) {
      const Location &left = a.value.location, &right = b.value.location;
      return std::pair(left.line, left.column) < std::pair(right.line, right.column);
    });
    return all;
  };
  return value;
}

Value<Axis> axis_table() {
  const auto keys = table<Axis>({
      field<Axis>("key", &Axis::key, reference("a key of the configuration, \"time.step\""),
                  "key to vary, written as for `--set`", Presence::required),
      field<Axis>("values", &Axis::values, list(any_value()), "its values, of any type", Presence::required),
      field<Axis>("zip", &Axis::zip, name("a name that axes which vary together share"),
                  "axes with the same name vary together: their first values give a run, their second values the next, "
                  "...; they need equally many values"),
  });
  return converted<Axis>(keys, [](Axis axis, const Item& item, Context& context) -> std::optional<Axis> {
    axis.location = item.location;
    if (item.has("values") && axis.values.empty() && item.child("values").node->is_array())
      context.errors.add(item.child("values").location, "an empty list", "at least one value");
    return axis;
  });
}

Value<Product> runs_table() {
  const auto keys = table<Product>({
      field<Product>("label", &Product::label, text(), "name of these runs in the legends of the pictures")
          .otherwise("the settings"),
      field<Product>("set", &Product::settings, settings(), "the settings of these runs"),
      field<Product>("axes", &Product::axes, tables(axis_table()), "keys to vary in these runs; without axes: one run"),
  });
  return converted<Product>(keys, [](Product runs, const Item& item, Context& context) -> std::optional<Product> {
    runs.location = item.location;
    if (!item.has("set") && !item.has("axes"))
      context.errors.add(item.location, "a table of runs that sets nothing", "'set', 'axes' or both");
    return runs;
  });
}

Value<StudyPlot> plot_table() {
  return table<StudyPlot>({
      field<StudyPlot>("over", &StudyPlot::over, one_or_more("the key of an axis"),
                       "the axes drawn horizontally in the pictures")
          .otherwise("`time.step`, `time.tolerance`, or the last axis of numbers"),
      field<StudyPlot>("show", &StudyPlot::show, list(choice("column", study_counts())),
                       "columns of `study.csv` to plot against these axes, in addition to the errors"),
      field<StudyPlot>("histories", &StudyPlot::histories, boolean(),
                       "one picture per probe of `[compare]` with the histories of all runs"),
  });
}

Value<std::map<std::string, Function>> expressions() {
  using Map = std::map<std::string, Function>;
  Value<Map> value{.type = "a table with one function of t per probe", .read = {}};
  value.read = [type = value.type](const Item& item, Context& context) -> std::optional<Map> {
    const toml::table* found = item.node->as_table();
    if (!found || found->empty()) {
      context.errors.add(item.location, found ? "an empty table" : describe(*item.node), type);
      return std::nullopt;
    }
    Map all;
    for (const auto& [key, node] : *found) {
      if (const auto one = function({"t"}).read(item.child(key.str()), context)) all.emplace(key.str(), *one);
    }
    return all;
  };
  return value;
}

Value<StudyReference> reference_table() {
  const auto keys = table<StudyReference>({
      field<StudyReference>("set", &StudyReference::settings, settings(),
                            "a run with these settings (`{}`: the base unchanged), computed first; ..."),
      field<StudyReference>("csv", &StudyReference::csv, path(), "... or a file with the columns of `history.csv`"),
      field<StudyReference>("expressions", &StudyReference::expressions, expressions(),
                            "... or exact solutions: `{ force = \"100*exp(-t)\" }`"),
  });
  return converted<StudyReference>(
      keys, [](StudyReference read, const Item& item, Context& context) -> std::optional<StudyReference> {
        read.location = item.location;
        const int given = item.has("set") + item.has("csv") + item.has("expressions");
        if (given == 1) return read;
        context.errors.add(item.location, given == 0 ? "no reference" : "several references",
                           "one of 'set', 'csv', 'expressions'");
        return std::nullopt;
      });
}

Value<Compare> compare_table() {
  return table<Compare>({
      field<Compare>("quantities", &Compare::quantities, list(reference("the name of a probe")),
                     "probes whose values at the start and the end, least and largest values are given for each run, "
                     "and that are compared with the reference, if there is one",
                     Presence::required),
      field<Compare>("norm", &Compare::norm, choice<ErrorNorm>("norm"),
                     "with a reference: its errors over all output times, or at the last one"),
  });
}

}  // namespace

Value<Study> study_table() {
  return table<Study>({
      field<Study>("title", &Study::title, text(), "title of the study; heading of `study.md`"),
      field<Study>("base", &Study::base, path(),
                   "the configuration that all runs share; path relative to the study file", Presence::required),
      field<Study>("set", &Study::settings, settings(), "settings of all runs and of the reference"),
      field<Study>("axes", &Study::axes, tables(axis_table()), "keys to vary"),
      field<Study>("runs", &Study::runs, tables(runs_table()), "runs in addition to the combinations of the axes"),
      field<Study>("reference", &Study::reference, reference_table(),
                   "what the runs are compared with; `[compare]` says which probes"),
      field<Study>("compare", &Study::compare, compare_table(), "what is compared, and how"),
      field<Study>("plot", &Study::plot, plot_table(), "what the pictures show"),
      field<Study>("random", &Study::random, random_table(), "keys that are distributed, and how they are sampled"),
      field<Study>("keep", &Study::keep, choice<Keep>("word"),
                   "a directory per run, or, of runs made by `--shard`, one HDF5 file per shard with their histories "
                   "and what their summaries say"),
  });
}

}  // namespace creepcontact::config
