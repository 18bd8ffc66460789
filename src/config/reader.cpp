#include "creepcontact/config/reader.hpp"

#include <toml++/toml.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "creepcontact/base/error.hpp"
#include "cross_checks.hpp"
#include "overrides.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

toml::table parse_toml(const std::string& text, const std::filesystem::path& file) {
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw ConfigError(locate(error.source(), "", {.file = file.string()}).prefix() + std::string(error.description()));
  }
}

}  // namespace

Config parse(const std::string& text, const std::filesystem::path& file, const Vocabulary& vocabulary,
             const std::vector<std::string>& overrides) {
  toml::table document = parse_toml(text, file);
  Context context{file.parent_path(), {}};
  for (const std::string& one : overrides) apply_override(one, document, context.errors);
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
  if (std::filesystem::is_directory(file)) throw ConfigError(file.string() + ": is a directory; expected a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw ConfigError(file.string() + ": cannot be read: " + std::generic_category().message(errno));
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse(text, file, vocabulary, overrides);
}

}  // namespace creepcontact::config
