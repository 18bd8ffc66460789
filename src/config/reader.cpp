#include "creepcontact/config/reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "creepcontact/config/writer.hpp"
#include "cross_checks.hpp"
#include "library_use.hpp"
#include "overrides.hpp"
#include "section_checks.hpp"
#include "tables.hpp"
#include "toml_document.hpp"

namespace creepcontact::config {

namespace {

/// Refuses a study before dozens of keys are reported that are unknown or missing.
void require_no_study(const toml::table& document, const std::filesystem::path& file) {
  if (!document.contains("base") || document.contains("mesh") || document.contains("bodies")) return;
  throw ConfigError(
      fmt::format("{0}: this file describes a study, many runs of one configuration ('base'); compute it with: "
                  "creepcontact study {0}",
                  file.string()));
}

/// True for what the data of materials depend on: units, time.cycle, materials.<name>.use and .units and what is below
/// .override.
bool selects_library_data(const std::string& override_text) {
  std::string key = override_text.substr(0, override_text.find('='));
  std::erase(key, ' ');
  if (key == "units" || key == "time.cycle") return true;
  return key.starts_with("materials.") &&
         (key.ends_with(".use") || key.ends_with(".units") || key.find(".override") != std::string::npos);
}

/// As Config::is_heat_alone(), before the document has been read.
bool is_heat_alone(const toml::table& document) {
  if (!document["heat"].is_table()) return false;
  if (const auto given = document["heat"]["alone"].value<bool>()) return *given;
  const toml::table* materials = document["materials"].as_table();
  if (materials == nullptr) return false;
  return std::ranges::none_of(*materials, [](const auto& material) {
    const toml::table* keys = material.second.as_table();
    return keys != nullptr && (keys->contains("young_modulus") || keys->contains("orthotropic"));
  });
}

}  // namespace

Config parse(const std::string& text, const std::filesystem::path& file, const Vocabulary& vocabulary,
             const std::vector<std::string>& overrides) {
  toml::table document = parse_toml(text, file, [&] { return schema(vocabulary); });
  require_no_study(document, file);
  Context context{.directory = file.parent_path(), .errors = {}};
  // What the library gives is a part of the document, which overrides may change.
  for (const std::string& one : overrides)
    if (selects_library_data(one)) apply_override(one, document, context.errors);
  insert_library_data(document, file.string(), vocabulary, context);
  for (const std::string& one : overrides)
    if (!selects_library_data(one)) apply_override(one, document, context.errors);
  context.end = document["time"]["end"].value<double>().value_or(0.0);
  context.is_heat_alone = is_heat_alone(document);
  const Item root{&document, {.file = file.string(), .line = 1, .column = 1}};
  Config config = config_table(vocabulary).read(root, context).value();
  set_section_defaults(root, config);
  cross_check(config, root, context.errors);
  context.errors.throw_if_any();
  config.file = file;
  complete(config, vocabulary);
  return config;
}

Config read(const std::filesystem::path& file, const Vocabulary& vocabulary,
            const std::vector<std::string>& overrides) {
  return parse(read_text(file), file, vocabulary, overrides);
}

}  // namespace creepcontact::config
