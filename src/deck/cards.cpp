#include "creepcontact/deck/cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <istream>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "text_encoding.hpp"

namespace creepcontact::deck {
namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20;
constexpr char end_of_dos_files = '\x1A';

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Upper case, with single blanks between words.
std::string card_name(std::string_view text) {
  std::string name;
  for (const char c : trimmed(text)) {
    const char next = is_blank(c) ? ' ' : c;
    if (next == ' ' && !name.empty() && name.back() == ' ') continue;
    name += next;
  }
  return upper_case(name);
}

std::string without_blanks(std::string_view text) {
  std::string result;
  std::ranges::copy_if(text, std::back_inserter(result), [](char c) { return !is_blank(c); });
  return result;
}

/// Whether a card has neither letter nor digit: "*" or "*-----", which divide decks.
bool is_ruler(std::string_view name) {
  return std::ranges::none_of(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; });
}

/// Splits a line at commas outside of quotes.
std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (line[i] != ',' || quoted)) continue;
    fields.push_back(trimmed(line.substr(begin, i - begin)));
    begin = i + 1;
  }
  return fields;
}

std::string unquoted(std::string_view text) {
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return std::string(trimmed(text));
}

class Reader {
 public:
  explicit Reader(const CardSink& sink) : sink_(sink) {}

  void read(const std::filesystem::path& path, const Card* including) {
    const auto at = [&](const std::string& what) { return including != nullptr ? including->message(what) : what; };
    if (const std::string reason = why_unreadable(path); !reason.empty())
      throw ConfigError(at(fmt::format("cannot read '{}': {}", path.string(), reason)));
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(path);
    if (std::ranges::find(open_, canonical) != open_.end())
      throw ConfigError(at(fmt::format("'{}' includes itself", path.string())));
    open_.push_back(canonical);
    std::ifstream file(path, std::ios::binary);
    read(file, path);
    open_.pop_back();
  }

  void read(std::istream& file, const std::filesystem::path& path) {
    Place place{printable(path.string()), 0};
    std::string line;
    while (next_line(file, line, place)) {
      if (line.starts_with("**")) continue;
      if (line.starts_with('*')) {
        const Place begin = place;
        read_keyword(file, line, place, begin, path);
        continue;
      }
      const std::string_view text = trimmed(line);
      if (text.empty()) continue;
      if (ruler_)
        throw ConfigError(
            fmt::format("{}: data below a line without a card ({}), which CalculiX does not read; remove that line, or "
                        "begin it with ** as a comment",
                        place.text(), ruler_->text()));
      if (!has_card_) continue;  // a title
      DataLine data{split(text), text.back() == ',', place};
      while (!data.fields.empty() && data.fields.back().empty()) data.fields.pop_back();
      sink_.data(data);
    }
  }

  void require_card(const std::filesystem::path& path) const {
    if (!has_card_)
      throw ConfigError(
          fmt::format("{}: no cards; a deck is a text file with lines such as *NODE and *ELEMENT", path.string()));
  }

 private:
  bool next_line(std::istream& file, std::string& line, Place& place) {
    if (ahead_) {
      line = *std::exchange(ahead_, std::nullopt);
      return true;
    }
    if (!std::getline(file, line)) return false;
    ++place.line;
    if (line.size() > longest_line || line.find('\0') != std::string::npos)
      throw ConfigError(
          fmt::format("{}: this is not text; a deck is a text file of cards such as *NODE", place.text()));
    if (place.line == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
    if (line.starts_with("**")) return true;  // a comment, in whatever encoding
    if (const std::size_t end = line.find(end_of_dos_files); end != std::string::npos) line.erase(end);
    const auto control = std::ranges::find_if(
        line, [](char c) { return (static_cast<unsigned char>(c) < ' ' && !is_blank(c)) || c == '\x7F'; });
    if (control != line.end())
      throw ConfigError(fmt::format("{}: a control character (0x{:02X}), which no name and no number has; remove it",
                                    place.text(), static_cast<unsigned char>(*control)));
    if (!is_utf8(line)) line = utf8_of_latin1(line);
    return true;
  }

  void read_keyword(std::istream& file, std::string& line, Place& place, const Place& begin,
                    const std::filesystem::path& path) {
    std::string text(trimmed(line));
    // Complete lines may also end in a comma: only a line with a parameter continues the keyword line.
    while (text.ends_with(',') && next_line(file, line, place)) {
      if (line.starts_with("**")) continue;
      if (line.starts_with('*') || line.find('=') == std::string::npos) {
        ahead_ = line;
        break;
      }
      text += trimmed(line);
    }
    const std::vector<std::string_view> fields = split(std::string_view{text}.substr(1));
    Card card{card_name(fields.front()), {}, begin};
    if (is_ruler(card.name)) {
      ruler_ = begin;
      return;
    }
    ruler_.reset();
    for (std::size_t i = 1; i < fields.size(); ++i) {
      const std::size_t equals = fields[i].find('=');
      const std::string key = upper_case(without_blanks(fields[i].substr(0, equals)));
      if (key.empty()) continue;
      card.parameters[key] = equals == std::string_view::npos ? "" : unquoted(trimmed(fields[i].substr(equals + 1)));
    }
    if (card.name == "INCLUDE") {
      if (card.value("INPUT").empty()) throw ConfigError(card.message("INPUT names the file; it is missing"));
      read(path.parent_path() / card.value("INPUT"), &card);
      return;
    }
    has_card_ = true;
    card.goes_on = text.ends_with(',');
    sink_.card(card);
  }

  const CardSink& sink_;
  bool has_card_ = false;
  std::optional<std::string> ahead_;  // a line that was read and is not the keyword's
  std::optional<Place> ruler_;        // the last card was none: its place
  std::vector<std::filesystem::path> open_;
};

}  // namespace

std::string Place::text() const {
  return fmt::format("{}:{}", file, line);
}

const std::string& Card::value(const std::string& parameter) const {
  static const std::string none;
  const auto found = parameters.find(parameter);
  return found == parameters.end() ? none : found->second;
}

std::string Card::message(const std::string& what) const {
  return fmt::format("{}: *{}: {}", place.text(), name, what);
}

void read_cards(const std::filesystem::path& path, const CardSink& sink) {
  Reader reader(sink);
  reader.read(path, nullptr);
  reader.require_card(path);
}

void read_cards(std::istream& text, const std::filesystem::path& name, const CardSink& sink) {
  Reader reader(sink);
  reader.read(text, name);
  reader.require_card(name);
}

std::string upper_case(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

std::optional<double> number(std::string_view field) {
  if (field.starts_with('+')) {
    field.remove_prefix(1);
    if (field.starts_with('-')) return std::nullopt;
  }
  if (field.empty() || field.front() == '+') return std::nullopt;
  std::string text(field);
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == 'd' || text[i] == 'D') text[i] = 'e';
    // An exponent without its letter.
    if ((text[i] == '+' || text[i] == '-') &&
        (std::isdigit(static_cast<unsigned char>(text[i - 1])) || text[i - 1] == '.'))
      text.insert(i, 1, 'e');
  }
  if (const std::size_t plus = text.find("e+"); plus != std::string::npos) text.erase(plus + 1, 1);
  if (const std::size_t plus = text.find("E+"); plus != std::string::npos) text.erase(plus + 1, 1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) value = std::strtod(text.c_str(), nullptr);  // small ones are 0
  if ((error != std::errc() && error != std::errc::result_out_of_range) || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::int64_t> whole_number(std::string_view field) {
  if (field.starts_with('+')) field.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  constexpr std::int64_t most = 1'000'000'000'000'000;  // sums with the numbers of other instances are numbers too
  if (error != std::errc() || end != field.data() + field.size() || value > most || value < -most) return std::nullopt;
  return value;
}

}  // namespace creepcontact::deck
