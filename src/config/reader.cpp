#include "creepcontact/config/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/config/dotted_key.hpp"
#include "creepcontact/config/writer.hpp"
#include "cross_checks.hpp"
#include "key_content.hpp"
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

/// The document with what the library gives, which is a part of it, and with the overrides, which may change both.
toml::table document_of(const std::string& text, const std::filesystem::path& file, const Vocabulary& vocabulary,
                        const std::vector<std::string>& overrides, Context& context) {
  toml::table document = parse_toml(text, file, [&] { return schema(vocabulary); });
  require_no_study(document, file);
  for (const std::string& one : overrides)
    if (selects_library_data(one)) apply_override(one, document, context.errors);
  insert_library_data(document, file.string(), vocabulary, context);
  for (const std::string& one : overrides)
    if (!selects_library_data(one)) apply_override(one, document, context.errors);
  return document;
}

KeyContent content_at(const toml::table& document, const std::string& key) {
  const toml::node* found = &document;
  for (const std::string& part : parts_of(key)) {
    if (const toml::table* table = found->as_table()) {
      found = table->get(part);
    } else if (const toml::array* list = found->as_array()) {
      std::size_t index = list->size();
      std::from_chars(part.data(), part.data() + part.size(), index);
      found = list->get(index);
    } else {
      found = nullptr;
    }
    if (found == nullptr) return {};
  }
  if (const auto number = found->is_number() ? found->value<double>() : std::nullopt)
    return {KeyContent::Kind::number, *number, describe(*found)};
  return {KeyContent::Kind::other, 0, describe(*found)};
}

}  // namespace

Config parse(const std::string& text, const std::filesystem::path& file, const Vocabulary& vocabulary,
             const std::vector<std::string>& overrides) {
  Context context{.directory = file.parent_path(), .errors = {}};
  toml::table document = document_of(text, file, vocabulary, overrides, context);
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

std::vector<KeyContent> contents_of(const std::filesystem::path& file, const Vocabulary& vocabulary,
                                    const std::vector<std::string>& overrides, const std::vector<std::string>& keys) {
  Context context{.directory = file.parent_path(), .errors = {}};
  const toml::table document = document_of(read_text(file), file, vocabulary, overrides, context);
  context.errors.throw_if_any();
  std::vector<KeyContent> contents;
  contents.reserve(keys.size());
  for (const std::string& key : keys) contents.push_back(content_at(document, key));
  return contents;
}

}  // namespace creepcontact::config
