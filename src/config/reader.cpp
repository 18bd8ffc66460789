#include "creepcontact/config/reader.hpp"

#include "cross_checks.hpp"
#include "overrides.hpp"
#include "tables.hpp"
#include "toml_document.hpp"

namespace creepcontact::config {

Config parse(const std::string& text, const std::filesystem::path& file, const Vocabulary& vocabulary,
             const std::vector<std::string>& overrides) {
  toml::table document = parse_toml(text, file);
  Context context{file.parent_path(), {}};
  for (const std::string& one : overrides) apply_override(one, document, context.errors);
  context.end = document["time"]["end"].value<double>().value_or(0.0);
  const Item root{&document, {.file = file.string(), .line = 1, .column = 1}};
  Config config = config_table(vocabulary).read(root, context).value();
  cross_check(config, root, context.errors);
  context.errors.throw_if_any();
  config.file = file;
  if (config.output.directory.empty()) config.output.directory = file.parent_path() / "results" / file.stem();
  return config;
}

Config read(const std::filesystem::path& file, const Vocabulary& vocabulary,
            const std::vector<std::string>& overrides) {
  return parse(read_text(file), file, vocabulary, overrides);
}

}  // namespace creepcontact::config
