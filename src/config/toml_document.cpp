#include "toml_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "item.hpp"
#include "key_length.hpp"
#include "syntax_mistakes.hpp"

namespace creepcontact::config {
namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 26;

}  // namespace

std::string read_text(const std::filesystem::path& file) {
  auto [text, failure] = read_file(file, max_bytes);
  if (failure.starts_with("longer")) failure += "; is that a configuration?";
  if (!failure.empty()) throw ConfigError(fmt::format("{}: cannot be read: {}", file.string(), failure));
  return text;
}

toml::table parse_toml(const std::string& text, const std::filesystem::path& file,
                       const std::function<std::vector<KeyInfo>()>& schema) {
  if (const auto long_key = find_long_key(text)) {
    const auto before = text.begin() + static_cast<std::ptrdiff_t>(*long_key);
    const auto line = std::count(text.begin(), before, '\n');
    const auto column = before - std::find(std::make_reverse_iterator(before), text.rend(), '\n').base();
    const Location where{
        .file = file.string(), .line = static_cast<int>(line) + 1, .column = static_cast<int>(column) + 1};
    throw ConfigError(where.prefix() + long_key_mistake);
  }
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    const Location where = locate(error.source(), "", {.file = file.string()});
    throw ConfigError(where.prefix() + explain_syntax(text, where, error.description(), schema()));
  }
}

}  // namespace creepcontact::config
