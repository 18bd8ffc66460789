#include "creepcontact/config/schema.hpp"

#include <algorithm>

#include "creepcontact/config/material_library.hpp"
#include "study_tables.hpp"
#include "tables.hpp"

namespace creepcontact::config {

std::vector<KeyInfo> schema(const Vocabulary& vocabulary) {
  std::vector<KeyInfo> keys = config_table(vocabulary).keys;
  const auto use = std::ranges::find(keys, "materials.<name>.use", &KeyInfo::path);
  use->words = words_of(names_of(material_library(vocabulary.materials)));
  return keys;
}

std::vector<KeyInfo> study_schema() {
  return study_table().keys;
}

namespace {

std::string document(const std::string& title, const Json& table) {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  schema.update(table);
  return schema.dump(2) + '\n';
}

}  // namespace

std::string json_schema(const Vocabulary& vocabulary) {
  return document("configuration of creepcontact", config_table(vocabulary).json());
}

std::string study_json_schema() {
  return document("study of creepcontact", study_table().json());
}

}  // namespace creepcontact::config
