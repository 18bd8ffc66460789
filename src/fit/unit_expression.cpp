#include "unit_expression.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

namespace creepcontact::fit {
namespace {

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Recursive descent; any failure leaves `right` false.
class UnitParser {
 public:
  UnitParser(std::string_view text, const std::function<std::optional<double>(const std::string&)>& value)
      : rest_(text), value_(value) {}

  std::optional<double> whole() {
    const double result = product();
    return right_ && rest_.empty() && std::isfinite(result) && result > 0 ? std::optional(result) : std::nullopt;
  }

 private:
  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '*')) rest_.remove_prefix(1);
  }
  bool take(char c) {
    skip_blanks();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  double product() {
    double result = power();
    for (skip_blanks(); right_ && !rest_.empty() && rest_.front() != ')'; skip_blanks())
      result = take('/') ? result / power() : result * power();
    return result;
  }

  double power() {
    const double base = factor();
    return take('^') ? std::pow(base, factor()) : base;
  }

  double factor() {
    if (take('(')) {
      const double inner = product();
      right_ = right_ && take(')');
      return inner;
    }
    if (take('-')) return rest_.empty() ? 1 : -factor();
    skip_blanks();
    std::size_t length = 0;
    while (length < rest_.size() && (is_letter(rest_[length]) || rest_[length] == '.')) ++length;
    const std::string word(rest_.substr(0, length));
    rest_.remove_prefix(length);
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (!word.empty() && error == std::errc() && end == word.data() + word.size()) return number;
    const auto known = word.empty() ? std::nullopt : value_(word);
    right_ = right_ && known.has_value();
    return known.value_or(1);
  }

  std::string_view rest_;
  const std::function<std::optional<double>(const std::string&)>& value_;
  bool right_ = true;
};

}  // namespace

std::string unit_in(const std::string& description) {
  const std::size_t begin = description.find('['), end = description.find(']', begin);
  return begin == std::string::npos || end == std::string::npos ? "" : description.substr(begin + 1, end - begin - 1);
}

bool unit_uses(const std::string& unit, std::string_view word) {
  for (std::size_t at = unit.find(word); at != std::string::npos; at = unit.find(word, at + 1)) {
    const bool begins = at == 0 || !is_letter(unit[at - 1]);
    const std::size_t end = at + word.size();
    if (begins && (end == unit.size() || !is_letter(unit[end]))) return true;
  }
  return false;
}

std::optional<double> unit_value(const std::string& unit,
                                 const std::function<std::optional<double>(const std::string&)>& value) {
  return UnitParser(unit, value).whole();
}

}  // namespace creepcontact::fit
