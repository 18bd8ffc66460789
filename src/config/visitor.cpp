#include "visitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

namespace creepcontact::config {

std::string toml_of(double number) {
  const std::string text = fmt::format("{}", number);
  return text == "-0" ? "-0.0" : text;  // an integer has no sign of zero
}

std::string toml_of(const Function& function) {
  const std::string& text = function.text();
  if (text.starts_with('{')) return text;  // a table
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number && fmt::format("{}", number) == text ? toml_of(number) : toml_of(text);
}

std::string toml_key(const std::string& name) {
  const bool is_bare = !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
  return is_bare ? name : toml_of(name);
}

void InlineText::separate() {
  if (!is_first_) text += ", ";
  is_first_ = false;
}

void InlineText::key(const Key& key, Walk value) {
  if (!key.is_meaningful || key.is_default()) return;
  separate();
  text += toml_key(key.name) + " = ";
  value(*this);
}

void InlineText::element(std::size_t /*index*/, Walk value) {
  separate();
  value(*this);
}

void InlineText::table(Call<void> keys) {
  const bool is_first = std::exchange(is_first_, true);
  text += "{ ";
  keys();
  text += is_first_ ? "}" : " }";
  is_first_ = is_first;
}

void InlineText::list(Call<void> elements) {
  const bool is_first = std::exchange(is_first_, true);
  text += '[';
  elements();
  text += ']';
  is_first_ = is_first;
}

void InlineText::function(const Function& value, const std::vector<std::string>& /*variables*/) {
  text += toml_of(value);
}

void InlineText::path(const std::filesystem::path& file) {
  if (file.empty()) {  // lexically_relative would make it "."
    text += no_text;
    return;
  }
  const std::filesystem::path relative = file.lexically_relative(directory_.lexically_normal());
  const std::filesystem::path written =
      relative.empty() && !file.is_absolute() ? std::filesystem::absolute(file).lexically_normal() : relative;
  text += toml_of(written.empty() ? file.string() : written.string());
}

}  // namespace creepcontact::config
