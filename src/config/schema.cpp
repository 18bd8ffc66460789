#include "creepcontact/config/schema.hpp"

#include "study_tables.hpp"
#include "tables.hpp"

namespace creepcontact::config {

std::vector<KeyInfo> schema(const Vocabulary& vocabulary) {
  return config_table(vocabulary).keys;
}

std::vector<KeyInfo> study_schema() {
  return study_table().keys;
}

}  // namespace creepcontact::config
