#include "toml_document.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "creepcontact/base/error.hpp"
#include "item.hpp"
#include "syntax_mistakes.hpp"

namespace creepcontact::config {

std::string read_text(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) throw ConfigError(file.string() + ": is a directory; expected a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw ConfigError(file.string() + ": cannot be read: " + std::generic_category().message(errno));
  return {std::istreambuf_iterator<char>(stream), {}};
}

toml::table parse_toml(const std::string& text, const std::filesystem::path& file,
                       const std::function<std::vector<KeyInfo>()>& schema) {
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    const Location where = locate(error.source(), "", {.file = file.string()});
    throw ConfigError(where.prefix() + explain_syntax(text, where, error.description(), schema()));
  }
}

}  // namespace creepcontact::config
