#pragma once
/// Kinds of values: what is allowed, how it is read from a file, what it is made of. They combine into tables
/// (table.hpp).

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/config/schema.hpp"
#include "creepcontact/settings/enum_names.hpp"
#include "diagnostics.hpp"
#include "item.hpp"
#include "visitor.hpp"

namespace creepcontact::config {

using Json = nlohmann::ordered_json;

/// Made when it is asked for: reading a configuration needs no schema.
using MakeJson = std::function<Json()>;

struct Context {
  std::filesystem::path directory;  ///< of the configuration file
  Diagnostics errors;
  double end = 0;              ///< time.end, as far as it is a number: what repeats is bounded by it
  bool is_heat_alone = false;  ///< elastic constants are not needed
};

template <class T>
struct Value {
  std::string type;  ///< what is allowed, in words
  /// nullopt if it is wrong: the error is then in the context
  std::function<std::optional<T>(const Item&, Context&)> read;
  /// Tells what a value has, as `read` finds it in a file.
  std::function<void(const T&, Visitor&)> visit = {};
  std::vector<KeyInfo> keys = {};  ///< of a table
  std::string brief = {};          ///< KeyInfo::brief; empty: the type without its article
  std::string plural = {};         ///< brief of several: "numbers > 0"; may be empty
  Form form = Form::value;
  std::vector<Word> words = {};                   ///< that it may be
  MakeJson json = [] { return Json::object(); };  ///< JSON Schema of what is allowed; {}: anything
};

Json schema_of_words(const std::vector<std::string>& words);
Json schema_of_any(std::vector<Json> alternatives);

std::vector<Word> words_of(const std::vector<std::string>& texts);
/// `"a"`, `"b"`: as code
std::string quoted(const std::vector<std::string>& words);

/// Interval of numbers, closed unless said otherwise.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool open_min = false, open_max = false;
  bool contains(double value) const;
  /// "a number", "a number > 0", "a number in (0, 1]"
  std::string describe(const std::string& what = "a number") const;
  Json json() const;
};
inline Range greater(double min) {
  return {.min = min, .open_min = true};
}
inline Range at_least(double min) {
  return {.min = min};
}

Value<std::string> text();
/// A string that is not empty. @param what  it names, in messages
Value<std::string> name(const std::string& what);
/// A string that is not empty, with its place.
Value<Reference> reference(const std::string& what);
/// @param type  not given: from the range
Value<double> number(Range range = {}, const std::string& type = {});
Value<int> integer(int min, int max = std::numeric_limits<int>::max());
struct WordOrNumber {
  std::string word;  ///< empty: a number
  double number = 0;
};
Value<WordOrNumber> words_or_number(const std::vector<std::string>& words, Range range);
/// Reads a number, or a word that means "not given".
Value<std::optional<double>> word_or_number(const std::string& word, Range range);
Value<bool> boolean();
/// Reads a path and makes it relative to the working directory.
Value<std::filesystem::path> path();
/// @param variables  that an expression may use
/// @param range      of constants and of the values of tables
Value<Function> function(const std::vector<std::string>& variables, Range range = {});

/// Reads one of some words. @param what  in messages: "unknown <what> 'abc'"
std::optional<std::size_t> read_choice(const Item& item, Context& context, const std::string& what,
                                       const std::vector<std::string>& names);
Value<std::string> choice(const std::string& what, const std::vector<std::string>& names);

/// Reads one of the names that the enumeration declares (settings/enum_names.hpp).
template <class Enum>
Value<Enum> choice(const std::string& what) {
  std::vector<std::string> names;
  for (const auto& [name, value] : names_of(Enum{})) names.emplace_back(name);
  const Value<std::string> word = choice(what, names);
  Value<Enum> value{.type = word.type, .read = {}, .brief = word.brief, .words = word.words, .json = word.json};
  value.read = [=](const Item& item, Context& context) -> std::optional<Enum> {
    const auto index = read_choice(item, context, what, names);
    if (!index) return std::nullopt;
    return names_of(Enum{})[*index].value;
  };
  value.visit = [](const Enum& one, Visitor& to) {
    to.leaf([&] { return toml_of(std::string(settings::name_of(one))); });
  };
  return value;
}

}  // namespace creepcontact::config
