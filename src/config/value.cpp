#include "value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace creepcontact::config {

bool Range::contains(double value) const {
  const bool above = open_min ? value > min : value >= min;
  return above && (open_max ? value < max : value <= max);
}

std::string Range::describe(const std::string& what) const {
  const bool bounded_below = std::isfinite(min), bounded_above = std::isfinite(max);
  if (bounded_below && bounded_above) {
    return fmt::format("{} in {}{}, {}{}", what, open_min ? '(' : '[', min, max, open_max ? ')' : ']');
  }
  if (bounded_below) return fmt::format("{} {} {}", what, open_min ? ">" : ">=", min);
  if (bounded_above) return fmt::format("{} {} {}", what, open_max ? "<" : "<=", max);
  return what;
}

Json Range::json() const {
  Json schema{{"type", "number"}};
  if (std::isfinite(min)) schema[open_min ? "exclusiveMinimum" : "minimum"] = min;
  if (std::isfinite(max)) schema[open_max ? "exclusiveMaximum" : "maximum"] = max;
  return schema;
}

Json schema_of_words(const std::vector<std::string>& words) {
  return {{"type", "string"}, {"enum", words}};
}

Json schema_of_any(std::vector<Json> alternatives) {
  return {{"anyOf", std::move(alternatives)}};
}

std::vector<Word> words_of(const std::vector<std::string>& texts) {
  std::vector<Word> words;
  words.reserve(texts.size());
  for (const std::string& text : texts) words.push_back({text});
  return words;
}

std::string quoted(const std::vector<std::string>& words) {
  return words.empty() ? std::string() : fmt::format("`\"{}\"`", fmt::join(words, "\"`, `\""));
}

Value<std::string> text() {
  Value<std::string> value{.type = "a string", .read = {}, .json = [] { return Json{{"type", "string"}}; }};
  value.read = [type = value.type](const Item& item, Context& context) -> std::optional<std::string> {
    if (const auto* string = item.node->as_string()) return string->get();
    context.errors.add(item.location, describe(*item.node), type);
    return std::nullopt;
  };
  value.visit = [](const std::string& string, Visitor& to) { to.leaf([&] { return toml_of(string); }); };
  return value;
}

Value<std::string> name(const std::string& what) {
  Value<std::string> value = text();
  value.type = what;
  value.json = reference(what).json;
  value.read = [what](const Item& item, Context& context) -> std::optional<std::string> {
    const auto found = reference(what).read(item, context);
    if (!found) return std::nullopt;
    return found->name;
  };
  return value;
}

Value<Reference> reference(const std::string& what) {
  Value<Reference> value{.type = what, .read = {}, .json = [] { return Json{{"type", "string"}, {"minLength", 1}}; }};
  value.read = [what](const Item& item, Context& context) -> std::optional<Reference> {
    const auto* string = item.node->as_string();
    if (string && !string->get().empty()) return Reference{string->get(), item.location};
    context.errors.add(item.location, string ? "an empty string" : describe(*item.node), what);
    return std::nullopt;
  };
  value.visit = [](const Reference& one, Visitor& to) { to.leaf([&] { return toml_of(one.name); }); };
  return value;
}

Value<double> number(Range range, const std::string& type) {
  Value<double> value{.type = type.empty() ? range.describe() : type,
                      .read = {},
                      .brief = range.describe("number"),
                      .plural = range.describe("numbers"),
                      .json = [range] { return range.json(); }};
  value.read = [range, type = value.type](const Item& item, Context& context) -> std::optional<double> {
    const auto found = item.node->is_number() ? item.node->value<double>() : std::nullopt;
    if (found && std::isfinite(*found) && range.contains(*found)) return found;
    context.errors.add(item.location, describe(*item.node), type);
    return std::nullopt;
  };
  value.visit = [](const double& one, Visitor& to) { to.leaf([&] { return toml_of(one); }); };
  return value;
}

Value<int> integer(int min, int max) {
  Range range = at_least(min);
  if (max < std::numeric_limits<int>::max()) range.max = max;
  Value<int> value{.type = range.describe("an integer"), .read = {}, .json = [range] {
                     Json schema = range.json();
                     schema["type"] = "integer";
                     return schema;
                   }};
  value.read = [=, type = value.type](const Item& item, Context& context) -> std::optional<int> {
    const auto* found = item.node->as_integer();
    if (found && found->get() >= min && found->get() <= max) return static_cast<int>(found->get());
    const bool is_too_large = found && found->get() > max && std::isinf(range.max);
    context.errors.add(item.location, describe(*item.node),
                       is_too_large ? fmt::format("{}, at most {}", type, max) : type);
    return std::nullopt;
  };
  value.visit = [](const int& one, Visitor& to) { to.leaf([&] { return fmt::format("{}", one); }); };
  return value;
}

Value<bool> boolean() {
  Value<bool> value{.type = "true or false",
                    .read = {},
                    .brief = "`true`, `false`",
                    .words = words_of({"true", "false"}),
                    .json = [] {
                      return Json{{"type", "boolean"}};
                    }};
  value.read = [type = value.type](const Item& item, Context& context) -> std::optional<bool> {
    if (const auto* found = item.node->as_boolean()) return found->get();
    context.errors.add(item.location, describe(*item.node), type);
    return std::nullopt;
  };
  value.visit = [](const bool& one, Visitor& to) { to.leaf([&] { return fmt::format("{}", one); }); };
  return value;
}

Value<std::filesystem::path> path() {
  Value<std::filesystem::path> value{
      .type = "a path, relative to the configuration file", .read = {}, .brief = "path", .json = [] {
        return Json{{"type", "string"}, {"minLength", 1}};
      }};
  value.read = [type = value.type](const Item& item, Context& context) -> std::optional<std::filesystem::path> {
    const auto name = reference(type).read(item, context);
    if (!name) return std::nullopt;
    return (context.directory / name->name).lexically_normal();
  };
  value.visit = [](const std::filesystem::path& one, Visitor& to) { to.path(one); };
  return value;
}

std::optional<std::size_t> read_choice(const Item& item, Context& context, const std::string& what,
                                       const std::vector<std::string>& names) {
  const auto* word = item.node->as_string();
  const auto found = word ? std::find(names.begin(), names.end(), word->get()) : names.end();
  if (found != names.end()) return found - names.begin();
  if (word) {
    context.errors.add_unknown(item.location, fmt::format("unknown {} '{}'", what, word->get()), word->get(), names);
  } else {
    context.errors.add(item.location, describe(*item.node), choice(what, names).type);
  }
  return std::nullopt;
}

Value<std::string> choice(const std::string& what, const std::vector<std::string>& names) {
  Value<std::string> value = text();
  value.type = fmt::format("\"{}\"", fmt::join(names, "\", \""));
  value.brief = value.plural = quoted(names);
  value.words = words_of(names);
  value.json = [names] { return schema_of_words(names); };
  value.read = [=](const Item& item, Context& context) -> std::optional<std::string> {
    const auto index = read_choice(item, context, what, names);
    if (!index) return std::nullopt;
    return names[*index];
  };
  return value;
}

Value<WordOrNumber> words_or_number(const std::vector<std::string>& words, Range range) {
  const Value<double> given =
      number(range, fmt::format("{} or \"{}\"", range.describe(), fmt::join(words, "\" or \"")));
  Value<WordOrNumber> value{.type = given.type,
                            .read = {},
                            .brief = fmt::format("{}, {}", range.describe("number"), quoted(words)),
                            .words = words_of(words),
                            .json = [=] {
                              return schema_of_any({schema_of_words(words), range.json()});
                            }};
  value.read = [=, type = value.type](const Item& item, Context& context) -> std::optional<WordOrNumber> {
    const auto* text = item.node->as_string();
    if (!text) {
      const auto found = given.read(item, context);
      return found ? std::optional(WordOrNumber{{}, *found}) : std::nullopt;
    }
    if (std::find(words.begin(), words.end(), text->get()) != words.end()) return WordOrNumber{text->get(), 0};
    context.errors.add_unknown(item.location, fmt::format("unknown value '{}'", text->get()), text->get(), words, type);
    return std::nullopt;
  };
  value.visit = [](const WordOrNumber& one, Visitor& to) {
    to.leaf([&] { return one.word.empty() ? toml_of(one.number) : toml_of(one.word); });
  };
  return value;
}

Value<std::optional<double>> word_or_number(const std::string& word, Range range) {
  const Value<WordOrNumber> either = words_or_number({word}, range);
  Value<std::optional<double>> value{
      .type = either.type, .read = {}, .brief = either.brief, .words = either.words, .json = either.json};
  value.read = [=](const Item& item, Context& context) -> std::optional<std::optional<double>> {
    const auto found = either.read(item, context);
    if (!found) return std::nullopt;
    return found->word.empty() ? std::optional(found->number) : std::optional<double>();
  };
  value.visit = [=](const std::optional<double>& one, Visitor& to) {
    either.visit(one ? WordOrNumber{{}, *one} : WordOrNumber{word, 0}, to);
  };
  return value;
}

}  // namespace creepcontact::config
