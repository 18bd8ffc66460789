#include "unit_conversion.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <optional>
#include <vector>

namespace creepcontact::config {
namespace {

/// Number in the text of an expression.
std::string in_expression(double number) {
  return number < 0 ? fmt::format("({})", number) : fmt::format("{}", number);
}

std::optional<double> number_in(const toml::node& value) {
  return value.is_number() ? value.value<double>() : std::nullopt;
}

std::vector<double> numbers_in(const toml::node* list) {
  std::vector<double> numbers;
  if (list != nullptr && list->is_array())
    for (const toml::node& one : *list->as_array()) numbers.push_back(one.value<double>().value_or(NAN));
  return numbers;
}

/// A table in T as an expression that is linear between its points and constant outside.
std::string piecewise(const std::vector<double>& T, const std::vector<double>& values) {
  std::string text = in_expression(values.back());
  for (std::size_t i = T.size() - 1; i-- > 0;) {
    const double slope = (values[i + 1] - values[i]) / (T[i + 1] - T[i]);
    text = fmt::format("(T < {} ? {} + (T - {})*{} : {})", in_expression(T[i + 1]), in_expression(values[i]),
                       in_expression(T[i]), in_expression(slope), text);
  }
  return fmt::format("(T < {} ? {} : {})", in_expression(T.front()), in_expression(values.front()), text);
}

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Where a number ends that begins at this place: 1.5e-3.
std::size_t end_of_number(const std::string& text, std::size_t at) {
  while (at < text.size() && (is_digit(text[at]) || text[at] == '.')) ++at;
  if (at == text.size() || (text[at] != 'e' && text[at] != 'E')) return at;
  std::size_t exponent = at + 1;
  if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
  if (exponent == text.size() || !is_digit(text[exponent])) return at;
  while (exponent < text.size() && is_digit(text[exponent])) ++exponent;
  return exponent;
}

}  // namespace

std::string UnitConversion::expression(const std::string& text) const {
  const auto old_value = [&](const std::string& name) {
    const auto scaled = [&](double by) { return by == 1 ? name : fmt::format("({}*{})", name, in_expression(1 / by)); };
    if (name == "q" || name == "U") return scaled(change_.stress);  // U: a strength
    if (name == "t") return scaled(change_.time);
    if (name != "T") return name;
    if (change_.degree == 1 && change_.zero == 0) return name;
    const std::string difference = change_.zero == 0 ? name : fmt::format("(T - {})", in_expression(change_.zero));
    return change_.degree == 1 ? difference : fmt::format("({}/{})", difference, in_expression(change_.degree));
  };
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at + 1;
    if (is_letter(text[at])) {
      while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
      result += old_value(text.substr(at, end - at));
    } else {
      if (is_digit(text[at]) || text[at] == '.') end = end_of_number(text, at);
      result += text.substr(at, end - at);
    }
    at = end;
  }
  return result;
}

std::string UnitConversion::text_of(const toml::node& value) const {
  if (const auto number = number_in(value)) return in_expression(*number);
  if (const auto* text = value.as_string()) return '(' + expression(text->get()) + ')';
  if (const auto* table = value.as_table()) {
    std::vector<double> T = numbers_in(table->get("T"));
    const std::vector<double> values = numbers_in(table->get("values"));
    for (double& one : T) one = change_.degree * one + change_.zero;
    if (!T.empty() && T.size() == values.size()) return piecewise(T, values);
  }
  return "0";  // the value is wrong, as the reader of the law will say
}

UnitConversion::Factor UnitConversion::factor(const UnitPowers& dimension, const Constants& constants,
                                              std::size_t element) const {
  const auto constant = [&](std::size_t place) -> const toml::node* {
    const toml::node* found = constants ? constants(place) : nullptr;
    const toml::array* list = found != nullptr ? found->as_array() : nullptr;
    if (list == nullptr) return found;
    return list->empty() ? nullptr : list->get(std::min(element, list->size() - 1));
  };
  Factor result;
  for (const UnitPower& power : dimension.powers()) {
    const double scale = change_.of(power.unit);
    if (scale == 1) continue;
    const UnitExponent& exponent = power.exponent;
    if (exponent.exclusive) {
      const toml::node* other = constant(*exponent.exclusive);
      if (other != nullptr && number_in(*other) != 0.0) continue;
    }
    const toml::node* other = exponent.constant ? constant(*exponent.constant) : nullptr;
    const std::optional<double> number = other == nullptr ? 1.0 : number_in(*other);
    if (number) {
      result.number *= std::pow(scale, exponent.number * (exponent.is_reciprocal ? 1 / *number : *number));
    } else {
      if (!result.text.empty()) result.text += '*';
      result.text += fmt::format("{}^({}{}{})", in_expression(scale), in_expression(exponent.number),
                                 exponent.is_reciprocal ? "/" : "*", text_of(*other));
    }
  }
  return result;
}

double UnitConversion::number(double value, const UnitPowers& dimension, const Factor& by) const {
  return dimension.is_temperature() ? change_.degree * value + change_.zero : by.number * value;
}

void UnitConversion::append(const toml::node& value, const UnitPowers& dimension, const Constants& constants,
                            std::size_t element, toml::array& into) const {
  if (const auto* list = value.as_array()) {
    toml::array all;
    for (std::size_t i = 0; i < list->size(); ++i) append(*list->get(i), dimension, constants, i, all);
    into.push_back(std::move(all));
    return;
  }
  const Factor by = factor(dimension, constants, element);
  if (const auto given = number_in(value)) {
    if (by.text.empty())
      into.push_back(number(*given, dimension, by));
    else
      into.push_back(fmt::format("{}*{}", in_expression(by.number * *given), by.text));
    return;
  }
  if (const auto* text = value.as_string()) {
    std::string made = expression(text->get());
    if (dimension.is_temperature() && !(change_.degree == 1 && change_.zero == 0))
      made = fmt::format("({})*{} + {}", made, in_expression(change_.degree), in_expression(change_.zero));
    else if (!by.is_one())
      made = fmt::format("({})*{}{}{}", made, in_expression(by.number), by.text.empty() ? "" : "*", by.text);
    into.push_back(std::move(made));
    return;
  }
  const toml::table* table = value.as_table();
  if (table == nullptr || !table->contains("T") || !table->contains("values")) {
    into.push_back(value);
    return;
  }
  if (!by.text.empty()) {
    into.push_back(fmt::format("{}*{}*{}", text_of(value), in_expression(by.number), by.text));
    return;
  }
  toml::array T, values;
  for (const double one : numbers_in(table->get("T"))) T.push_back(change_.degree * one + change_.zero);
  for (const double one : numbers_in(table->get("values"))) values.push_back(number(one, dimension, by));
  toml::table made;
  made.insert("T", std::move(T));
  made.insert("values", std::move(values));
  into.push_back(std::move(made));
}

void UnitConversion::append(const toml::node& value, const UnitPowers& dimension, const Constants& constants,
                            toml::array& into) const {
  append(value, dimension, constants, 0, into);
}

void UnitConversion::replace(toml::table& table, std::string_view key, const UnitPowers& dimension,
                             const Constants& constants) const {
  const toml::node* value = table.get(key);
  if (value == nullptr) return;
  toml::array box;
  append(*value, dimension, constants, box);
  table.insert_or_assign(key, std::move(*box.get(0)));
}

}  // namespace creepcontact::config
