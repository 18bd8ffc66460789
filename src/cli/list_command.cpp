#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/config/key_reference.hpp"
#include "creepcontact/config/material_library.hpp"
#include "creepcontact/run/lists.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "template_files.hpp"

namespace creepcontact::cli {
namespace {

const std::vector<std::string> key_lists{"keys", "study-keys"};
const std::vector<std::string> name_lists{"integrators", "laws", "elements", "quantities", "templates", "materials"};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string all_lists() {
  return fmt::format("{}, {}", fmt::join(key_lists, ", "), fmt::join(name_lists, ", "));
}

struct Output {
  bool markdown = false, names = false, values = false, json_schema = false;
};

/// @param wanted  which keys; not given: all
std::string keys(const std::string& what, const std::optional<std::string>& wanted, const Output& output) {
  if (output.json_schema) return what == "keys" ? config::json_schema(run::vocabulary()) : config::study_json_schema();
  auto sections = config::key_sections(what == "keys" ? config::schema(run::vocabulary()) : config::study_schema());
  if (wanted) sections = config::select_keys(sections, *wanted);
  if (output.names) return config::key_names(sections);
  if (output.values) return config::key_values(sections);
  if (output.markdown) return config::key_markdown(sections, !wanted || !wanted->starts_with('['));
  return config::key_listing(sections);
}

/// @param word  which materials; not given: all
std::string materials(const std::optional<std::string>& word, const Output& output) {
  auto library = config::material_library(run::vocabulary().materials);
  if (word) {
    const std::vector<std::string> names = config::names_of(library);
    library = config::matching(library, *word);
    if (library.empty())
      throw ConfigError(fmt::format("list materials: no steel is called '{}'{} (creepcontact list materials shows all)",
                                    *word, did_you_mean(*word, names)));
  }
  if (output.names) return fmt::format("{}\n", fmt::join(config::names_of(library), "\n"));
  return output.markdown ? config::library_markdown(library) : config::library_listing(library);
}

void require_valid(const std::string& what, const CommandLine& line, const Output& output) {
  if (!contains(key_lists, what) && !contains(name_lists, what)) {
    std::vector<std::string> lists = key_lists;
    lists.insert(lists.end(), name_lists.begin(), name_lists.end());
    throw ConfigError(
        fmt::format("list: unknown list '{}'{} (allowed: {})", what, did_you_mean(what, lists), all_lists()));
  }
  const bool selects = what == "materials";
  if (contains(name_lists, what) &&
      (((line.optional() || output.names) && !selects) || output.values || output.json_schema))
    throw ConfigError(fmt::format("list {}: {}--values and --json-schema are for {} only", what,
                                  selects ? "" : "KEY, --names, ", fmt::join(key_lists, " and ")));
  if (output.markdown + output.names + output.values + output.json_schema > 1)
    throw ConfigError("list: --markdown, --names, --values and --json-schema cannot be combined");
  if (output.json_schema && line.optional())
    throw ConfigError("list: --json-schema takes no KEY; it describes all keys");
}

}  // namespace

int list(const Command& self, const Arguments& arguments) {
  CommandLine line(self);
  Output output;
  const auto flag = [&](const char* name, bool& value, const char* meaning) {
    line.add_options()(name, boost::program_options::bool_switch(&value), meaning);
  };
  flag("markdown", output.markdown, "print Markdown tables, as in the documentation");
  flag("names", output.names, "keys, materials: only their names, one per line");
  flag("values", output.values, "keys: the words allowed as values, one per line");
  flag("json-schema", output.json_schema, "keys: as JSON Schema, for editors");
  if (!line.parse(arguments, "one of " + all_lists(), "KEY or WORD")) return 0;
  const std::string& what = line.positional();
  require_valid(what, line, output);
  if (contains(key_lists, what)) {
    std::cout << keys(what, line.optional(), output);
  } else if (what == "materials") {
    std::cout << materials(line.optional(), output);
  } else {
    std::cout << (what == "templates" ? list_templates(output.markdown)
                  : output.markdown   ? run::list_markdown(what)
                                      : run::list(what));
  }
  return 0;
}

}  // namespace creepcontact::cli
