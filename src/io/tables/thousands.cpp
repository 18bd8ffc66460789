#include "creepcontact/io/tables/thousands.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace creepcontact::io {
namespace {

using Named = std::pair<std::string_view, Thousands>;
constexpr std::array<Named, 4> names{
    {{".", Thousands::point}, {",", Thousands::comma}, {" ", Thousands::blank}, {"'", Thousands::apostrophe}}};

/// Length of the separator at the beginning of `text`; 0: there is none. Blanks and apostrophes have several forms.
std::size_t separator_length(std::string_view text, Thousands thousands) {
  const auto of = [&](std::initializer_list<std::string_view> forms) -> std::size_t {
    for (const std::string_view form : forms)
      if (text.starts_with(form)) return form.size();
    return 0;
  };
  switch (thousands) {
    case Thousands::none:
      return 0;
    case Thousands::point:
      return of({"."});
    case Thousands::comma:
      return of({","});
    case Thousands::blank:
      return of({" ", "\u00A0", "\u202F", "\u2009"});
    case Thousands::apostrophe:
      return of({"'", "\u2019"});
  }
  return 0;
}

}  // namespace

std::optional<Thousands> thousands_named(std::string_view name) {
  const auto found = std::ranges::find(names, name, &Named::first);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::string> without_thousands(std::string_view number, Thousands thousands) {
  std::string result;
  if (!number.empty() && (number.front() == '-' || number.front() == '+')) {
    if (number.front() == '-') result = "-";
    number.remove_prefix(1);
  }
  constexpr std::size_t in_group = 3;
  std::size_t digits = 0, groups = 0;
  while (!number.empty()) {
    if (std::isdigit(static_cast<unsigned char>(number.front())) != 0) {
      result += number.front();
      number.remove_prefix(1);
      ++digits;
      continue;
    }
    const std::size_t length = separator_length(number, thousands);
    if (length == 0) break;
    if (digits == 0 || digits > in_group || (groups > 0 && digits != in_group)) return std::nullopt;
    number.remove_prefix(length);
    ++groups;
    digits = 0;
  }
  if (groups > 0 && digits != in_group) return std::nullopt;
  // The comma and the point are decimal signs where they do not separate thousands.
  if (!number.empty() && ((number.front() == ',' && thousands != Thousands::comma) ||
                          (number.front() == '.' && thousands != Thousands::point))) {
    result += '.';
    number.remove_prefix(1);
  }
  return result + std::string(number);  // further digits, the exponent
}

}  // namespace creepcontact::io
