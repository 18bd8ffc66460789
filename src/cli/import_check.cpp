#include "import_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <fstream>
#include <sstream>
#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/run/check.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "thread_settings.hpp"

namespace creepcontact::cli {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// "deck.inp:33: *EQUATION" of "[[equations]]    # deck.inp:33: *EQUATION"; empty: no comment.
std::string comment_of(const std::string& header) {
  const std::size_t hash = header.find('#');
  if (hash == std::string::npos) return "";
  const std::size_t begin = header.find_first_not_of(' ', hash + 1);
  return begin == std::string::npos ? "" : header.substr(begin);
}

/// The comment of the table that contains a line (numbered from 1): the card that the table was made of.
std::string card_at(const std::vector<std::string>& toml, std::size_t line) {
  for (std::size_t i = std::min(line, toml.size()); i-- > 0;)
    if (toml[i].starts_with('[')) return comment_of(toml[i]);
  return "";
}

/// The comment of the table with this number (from 0) among the tables [[name]].
std::string card_of(const std::vector<std::string>& toml, const std::string& name, std::size_t number) {
  for (const std::string& line : toml)
    if (line.starts_with("[[" + name + "]]") && number-- == 0) return comment_of(line);
  return "";
}

/// A number of digits at a place, and where they end.
std::pair<std::size_t, std::size_t> digits(const std::string& text, std::size_t at) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), value);
  return {value, error == std::errc() ? static_cast<std::size_t>(end - text.data()) : at};
}

std::string card_of(const std::string& message, const std::vector<std::string>& toml, const std::string& file) {
  if (message.starts_with(file + ":"))
    if (const auto [line, end] = digits(message, file.size() + 1); end > file.size() + 1) return card_at(toml, line);
  for (std::size_t open = message.find('['); open != std::string::npos; open = message.find('[', open + 1)) {
    const auto [number, end] = digits(message, open + 1);
    if (end == open + 1 || end >= message.size() || message[end] != ']') continue;
    std::size_t begin = open;
    while (begin > 0 && ((message[begin - 1] >= 'a' && message[begin - 1] <= 'z') || message[begin - 1] == '_'))
      --begin;
    if (std::string card = card_of(toml, message.substr(begin, open - begin), number); !card.empty()) return card;
  }
  return "";
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

std::string with_cards(const std::string& message, const std::string& toml, const std::string& file) {
  const std::vector<std::string> lines = lines_of(toml);
  std::string result;
  for (const std::string& line : lines_of(message)) {
    const std::string card = card_of(line, lines, file);
    const bool has_place = line.starts_with(file);  // in a file that will be gone
    result += (result.empty() ? "" : "\n") +
              (has_place ? std::filesystem::path(file).filename().string() + line.substr(file.size()) : line) +
              (card.empty() ? "" : fmt::format(" (made of {})", card));
  }
  return result;
}

void check_import(const std::filesystem::path& configuration, const std::filesystem::path& deck) {
  const ThreadChoice one_thread(1);
  try {
    const config::Config config = config::read(configuration, run::vocabulary());
    run::CheckOptions options;
    options.output = (configuration.parent_path() / "results").string();  // those of another run are in no one's way
    std::ostringstream report;
    run::check(config, report, options);
  } catch (const std::exception& error) {
    throw ConfigError(
        fmt::format("{}: what it makes is refused:\n{}\nChange the deck, or write the configuration with --no-check "
                    "and change that",
                    deck.string(), with_cards(error.what(), text_of(configuration), configuration.string())));
  }
}

}  // namespace creepcontact::cli
