#include "engineering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace creepcontact::report {
namespace {

constexpr double roundoff = 1e-9;             // of the largest value of a column
constexpr std::string_view group = "\u202F";  // narrow no-break space
constexpr std::string_view space = "\u00A0";  // no-break space

/// Units that take prefixes, from the smallest to the largest, each 1000 times the one before.
constexpr std::array<std::array<std::string_view, 6>, 5> ladders{{{"µN", "mN", "N", "kN", "MN", "GN"},
                                                                  {"mPa", "Pa", "kPa", "MPa", "GPa", "TPa"},
                                                                  {"µW", "mW", "W", "kW", "MW", "GW"},
                                                                  {"µJ", "mJ", "J", "kJ", "MJ", "GJ"},
                                                                  {"pm", "nm", "µm", "mm", "m", "km"}}};
constexpr std::size_t lengths = 4;

/// The unit of a column whose largest value is `largest`, and the factor to it. What is between 0.01 and 10000 stays
/// as it is: nobody writes 0.35 GPa.
std::pair<std::string, double> prefixed(const std::string& unit, double largest) {
  constexpr double small = 0.01, large = 1e4, step = 1e3;
  // "N·mm": a product takes the prefix at its first factor.
  const std::size_t end = std::min(unit.find("·"), unit.size());
  const std::string first = unit.substr(0, end), rest = unit.substr(end);
  for (std::size_t l = 0; l < ladders.size(); ++l) {
    if (l == lengths && !rest.empty()) continue;
    const auto& ladder = ladders[l];
    const auto found = std::ranges::find(ladder, first == "uN" ? "µN" : first == "um" ? "µm" : first);
    if (found == ladder.end() || !(largest > 0) || !std::isfinite(largest)) continue;
    auto at = static_cast<std::size_t>(found - ladder.begin());
    double factor = 1;
    while (largest * factor >= large && at + 1 < ladder.size()) {
      ++at;
      factor /= step;
    }
    while (largest * factor < small && at > 0) {
      --at;
      factor *= step;
    }
    return {std::string(ladder[at]) + rest, factor};
  }
  return {unit, 1};
}

std::string superscript(int exponent) {
  constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent))) text += digits[static_cast<std::size_t>(digit - '0')];
  return text;
}

std::string grouped(const std::string& whole) {
  if (whole.size() <= 3) return whole;
  std::string text;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (i > 0 && (whole.size() - i) % 3 == 0) text += group;
    text += whole[i];
  }
  return text;
}

std::string without_end_zeros(std::string digits) {
  while (digits.ends_with('0')) digits.pop_back();
  return digits;
}

}  // namespace

std::string engineering(double value, int figures) {
  constexpr int largest_plain = 9, smallest_plain = -4;  // powers of ten
  if (!std::isfinite(value)) return std::isnan(value) ? "-" : value > 0 ? "∞" : "-∞";
  if (value == 0) return "0";
  // Rounded once, by the library: the digits, and the power of ten of the first.
  const std::string scientific = fmt::format("{:.{}e}", std::abs(value), figures - 1);
  const std::size_t e = scientific.find('e');
  const int power = std::atoi(scientific.c_str() + e + 1);
  std::string digits = scientific.substr(0, e);
  std::erase(digits, '.');
  const std::string sign = value < 0 ? "-" : "";
  if (power > largest_plain || power < smallest_plain) {
    const std::string fraction = without_end_zeros(digits.substr(1));
    return fmt::format("{}{}{}{}·10{}", sign, digits[0], fraction.empty() ? "" : ".", fraction, superscript(power));
  }
  if (power < 0)
    return fmt::format("{}0.{}{}", sign, std::string(static_cast<std::size_t>(-power - 1), '0'),
                       without_end_zeros(digits));
  const auto n_whole = static_cast<std::size_t>(power) + 1;
  if (digits.size() <= n_whole) return sign + grouped(digits + std::string(n_whole - digits.size(), '0'));
  const std::string fraction = without_end_zeros(digits.substr(n_whole));
  return fmt::format("{}{}{}{}", sign, grouped(digits.substr(0, n_whole)), fraction.empty() ? "" : ".", fraction);
}

Scale::Scale(const std::string& unit, std::span<const double> values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  std::tie(unit_, factor_) = prefixed(unit, largest);
  smallest_ = roundoff * largest;
}

std::string Scale::text(double value) const {
  return std::abs(value) < smallest_ ? "0" : engineering(factor_ * value);
}

std::string Scale::with_unit(double value) const {
  return unit_.empty() ? text(value) : fmt::format("{}{}{}", text(value), space, unit_);
}

std::string quantity(double value, const std::string& unit) {
  return Scale(unit, std::array{value}).with_unit(value);
}

std::string time_text(double value, const std::string& unit) {
  constexpr int figures = 5;
  const std::string text = engineering(value, figures);
  return unit.empty() ? text : fmt::format("{}{}{}", text, space, unit);
}

std::string percent(double share) {
  if (!std::isfinite(share)) return "-";
  constexpr double few = 10;
  const double value = 100 * share, rounded = std::abs(value) < few ? value : std::round(value);
  const double shown = std::abs(share) < roundoff ? 0 : rounded;
  return fmt::format("{}{}%", engineering(shown, std::abs(value) < few ? 2 : 6), space);
}

std::string labelled(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::string place_text(std::span<const double, 3> position, const std::string& unit) {
  constexpr int figures = 4;
  double largest = 0;
  for (const double x : position) largest = std::max(largest, std::abs(x));
  const auto text = [&](double x) {
    return std::abs(x) < roundoff * largest ? std::string("0") : engineering(x, figures);
  };
  return fmt::format("({}, {}, {}){}{}", text(position[0]), text(position[1]), text(position[2]),
                     unit.empty() ? "" : space, unit);
}

namespace {

/// A number as readers have it; other text as it is.
std::string readable_number(std::string_view number) {
  const std::size_t first = number.starts_with('-') ? 1 : 0;
  if (first == number.size() || number[first] < '0' || number[first] > '9') return std::string(number);
  double value = 0;
  const auto [after, failure] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (failure != std::errc() || after != number.data() + number.size()) return std::string(number);
  constexpr std::ptrdiff_t most_figures = 9, enough = 6;  // of what has been computed by a computer
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::ptrdiff_t figures = std::ranges::count_if(number.substr(0, e), is_digit);
  if (e < number.size()) return engineering(value, static_cast<int>(std::min(figures, enough)));
  const std::size_t whole = std::min(number.find('.'), number.size()) - first;
  if (figures > most_figures && first + whole < number.size()) return engineering(value, static_cast<int>(enough));
  // Small numbers may be of a name or a year.
  constexpr std::size_t large = 5;
  if (whole < large) return std::string(number);
  return fmt::format("{}{}{}", number.substr(0, first), grouped(std::string(number.substr(first, whole))),
                     number.substr(first + whole));
}

/// The numbers of "20, 500]...", up to the bracket, which is removed with them.
std::vector<std::string> numbers_before_bracket(std::string_view& text) {
  std::vector<std::string> all;
  const std::size_t end = text.find(']');
  if (end == std::string_view::npos) return all;
  std::string_view list = text.substr(0, end);
  text.remove_prefix(end + 1);
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(", "), list.size());
    all.push_back(readable_number(list.substr(0, comma)));
    list.remove_prefix(std::min(comma + 2, list.size()));
  }
  return all;
}

/// "211 000 at T = 20, 175 000 at 500" of "{ T = [20, 500], values = [211000, 175000] }"; empty for any other text.
std::string readable_table(std::string_view text) {
  if (!text.starts_with("{ ") || !text.ends_with(" }")) return "";
  text = text.substr(2, text.size() - 4);
  const std::size_t begin = text.find(" = [");
  if (begin == std::string_view::npos) return "";
  const std::string_view variable = text.substr(0, begin);
  text.remove_prefix(begin + 4);
  const std::vector<std::string> places = numbers_before_bracket(text);
  constexpr std::string_view second = ", values = [", period = ", period = ";
  if (!text.starts_with(second)) return "";
  text.remove_prefix(second.size());
  const std::vector<std::string> values = numbers_before_bracket(text);
  if (places.empty() || places.size() != values.size()) return "";
  std::string result;
  for (std::size_t i = 0; i < places.size(); ++i)
    result += i == 0 ? fmt::format("{} at {} = {}", values[i], variable, places[i])
                     : fmt::format(", {} at {}", values[i], places[i]);
  if (text.starts_with(period))
    return fmt::format("{}; again every {}", result, readable_number(text.substr(period.size())));
  return text.empty() ? result : "";
}

}  // namespace

std::string readable(const std::string& cell) {
  if (std::string table = readable_table(cell); !table.empty()) return table;
  std::string result;
  for (std::size_t begin = 0; begin < cell.size();) {
    const std::size_t end = std::min(cell.find(' ', begin), cell.size());
    const std::string word = cell.substr(begin, end - begin);
    constexpr std::string_view opening = "([", closing = ")],;";
    const std::size_t first = std::min(word.find_first_not_of(opening), word.size());
    const std::size_t last = std::max(word.find_last_not_of(closing) + 1, first);
    result += word.substr(0, first);
    result += readable_number(word.substr(first, last - first));
    result += word.substr(last);
    if (end < cell.size()) result += ' ';
    begin = end + 1;
  }
  return result;
}

bool is_number_text(std::string_view cell) {
  if (cell.empty() || cell == "-" || cell == "∞") return true;
  std::string_view rest = cell;
  if (rest.starts_with('-')) rest.remove_prefix(1);
  if (rest.empty() || rest.front() < '0' || rest.front() > '9') return false;
  const auto skip = [&](std::string_view part) {
    if (!rest.starts_with(part)) return false;
    rest.remove_prefix(part.size());
    return true;
  };
  while (!rest.empty() &&
         ((rest.front() >= '0' && rest.front() <= '9') || rest.front() == '.' || rest.starts_with(group)))
    rest.remove_prefix(rest.starts_with(group) ? group.size() : 1);
  if (skip("e")) {
    if (!skip("-")) skip("+");
    while (!rest.empty() && rest.front() >= '0' && rest.front() <= '9') rest.remove_prefix(1);
  }
  if (skip("·10")) {
    // The superscripts that follow are of two or three bytes each.
    while (!rest.empty() && static_cast<unsigned char>(rest.front()) >= 0x80 && !rest.starts_with(space))
      rest.remove_prefix(1);
  }
  if (rest.empty()) return true;
  if (!skip(space) && !skip(" ")) return false;
  return !rest.empty() && rest.find(' ') == std::string_view::npos && (rest.front() < '0' || rest.front() > '9') &&
         rest.size() < 8;
}

}  // namespace creepcontact::report
