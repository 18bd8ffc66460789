#include "creepcontact/fit/law_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/base/units.hpp"
#include "unit_expression.hpp"

namespace creepcontact::fit {
namespace {

using material::ParameterInfo;

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string range_of(const ParameterInfo& key) {
  std::string text;
  if (std::isfinite(key.minimum)) text = fmt::format(" {} {}", key.strict ? ">" : ">=", key.minimum);
  if (std::isfinite(key.maximum)) text += fmt::format("{} <= {}", text.empty() ? "" : ",", key.maximum);
  return "numbers" + text;
}

std::string without_blank_ends(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\"'"), end = text.find_last_not_of(" \t\"'");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

/// One value of --set, of a list or alone.
Function value_in(const ParameterInfo& key, const std::string& text) {
  const auto refuse = [&](const std::string& allowed) -> Function {
    throw ConfigError(fmt::format("--set {}: '{}'; allowed: {}", key.key, text, allowed));
  };
  if (!key.words.empty()) {
    const auto word = std::ranges::find(key.words, text);
    if (word == key.words.end()) return refuse(fmt::format("{}", fmt::join(key.words, ", ")));
    return static_cast<double>(word - key.words.begin());
  }
  if (const auto number = number_in(text)) {
    if ((key.strict ? !(*number > key.minimum) : *number < key.minimum) || *number > key.maximum)
      return refuse(range_of(key));
    return *number;
  }
  if (key.variables.empty()) return refuse(range_of(key));
  try {
    return Function::expression(text, key.variables);
  } catch (const std::invalid_argument& error) {
    return refuse(
        fmt::format("{}, or an expression in {} ({})", range_of(key), fmt::join(key.variables, ", "), error.what()));
  }
}

std::vector<Function> values_in(const ParameterInfo& key, std::string text) {
  text = without_blank_ends(text);
  if (!key.list) return {value_in(key, text)};
  if (text.starts_with('[') && text.ends_with(']')) text = text.substr(1, text.size() - 2);
  std::vector<Function> values;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    values.push_back(value_in(key, without_blank_ends(text.substr(begin, end - begin))));
    begin = end + 1;
  }
  return values;
}

/// The values as a configuration writes them.
std::string toml(const ParameterInfo& key, const std::vector<Function>& values) {
  std::vector<std::string> texts;
  for (const Function& value : values)
    if (!key.words.empty())
      texts.push_back(fmt::format("\"{}\"", key.words[static_cast<std::size_t>(value({}))]));
    else
      texts.push_back(value.is_constant() && number_in(value.text()) ? value.text()
                                                                     : fmt::format("\"{}\"", value.text()));
  return key.list ? fmt::format("[{}]", fmt::join(texts, ", ")) : texts.front();
}

/// Puts a choice together.
class Chooser {
 public:
  Chooser(const LawWishes& wishes, const TestData& data) : wishes_(wishes), data_(data) {
    choice_.info = material::find_creep_law(wishes.law);
    if (choice_.info == nullptr) {
      std::vector<std::string> names;
      for (const material::LawInfo& law : material::creep_laws()) names.push_back(law.name);
      throw ConfigError(fmt::format("--law: unknown law '{}'{} (allowed: {})", wishes.law,
                                    did_you_mean(wishes.law, names), fmt::join(names, ", ")));
    }
    for (const ParameterInfo& key : choice_.info->parameters)
      choice_.held.push_back(key.fallback.value_or(std::vector<Function>{0.0}));
    is_held_.assign(keys().size(), false);
  }

  LawChoice choose() {
    for (const std::string& assignment : wishes_.set) set(assignment);
    set_absolute_zero();
    for (std::size_t i = 0; i < keys().size(); ++i) {
      const ParameterInfo& key = keys()[i];
      if (is_held_[i] || !is_wanted(i)) continue;
      if (key.list || !key.words.empty())
        throw ConfigError(fmt::format("law '{}': '{}' is a list or a word, which is not fitted; give it: --set '{}={}'",
                                      name(), key.key, key.key,
                                      key.list ? "[...]" : fmt::format("{}", fmt::join(key.words, "|"))));
      choice_.fitted.push_back(i);
    }
    require_free_keys();
    require_something_fitted();
    require_temperature_dependence();
    require_stresses();
    return std::move(choice_);
  }

 private:
  const std::vector<ParameterInfo>& keys() const { return choice_.info->parameters; }
  const std::string& name() const { return choice_.info->name; }

  std::vector<std::string> key_names() const {
    std::vector<std::string> names;
    for (const ParameterInfo& key : keys()) names.push_back(key.key);
    return names;
  }

  std::size_t position(const std::string& option, const std::string& key) const {
    const std::vector<std::string> names = key_names();
    const auto found = std::ranges::find(names, key);
    if (found == names.end())
      throw ConfigError(fmt::format("--{}: law '{}' has no key '{}'{} (it has: {})", option, name(), key,
                                    did_you_mean(key, names), fmt::join(names, ", ")));
    return static_cast<std::size_t>(found - names.begin());
  }

  void hold(std::size_t i, std::vector<Function> values) {
    choice_.set[keys()[i].key] = toml(keys()[i], values);
    choice_.held[i] = std::move(values);
    is_held_[i] = true;
  }

  void set(const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0)
      throw ConfigError(fmt::format("--set '{}'; expected key=value", assignment));
    const std::size_t i = position("set", without_blank_ends(assignment.substr(0, equals)));
    hold(i, values_in(keys()[i], assignment.substr(equals + 1)));
  }

  bool is_energy(std::size_t key) const { return choice_.info->is_activation_energy(key); }

  bool is_wanted(std::size_t key) const {
    if (std::ranges::count(wishes_.free, keys()[key].key) > 0) return true;
    if (!keys()[key].fallback) return true;
    return is_energy(key) && data_.temperatures().size() > 1;
  }

  bool fits_energy() const {
    return std::ranges::any_of(choice_.fitted, [&](std::size_t i) { return is_energy(i); });
  }

  /// A temperature in another unit than the fallback expects.
  void set_absolute_zero() {
    const auto zero = std::ranges::find(keys(), "absolute_zero", &ParameterInfo::key);
    if (zero == keys().end() || !data_.has_temperature) return;
    const auto i = static_cast<std::size_t>(zero - keys().begin());
    if (is_held_[i]) {
      choice_.temperature_at_zero = choice_.held[i].front()({});
      return;
    }
    if (const auto scale = unit_scale(Dimension::temperature, data_.units.temperature)) {
      const double value = -scale->offset / scale->factor;
      if (std::abs(value - choice_.held[i].front()({})) > 1e-9)
        hold(i, {value == 0 ? 0.0 : std::round(100 * value) / 100});
    } else if (data_.temperatures().size() > 1) {
      choice_.notes.push_back(
          fmt::format("the column of the temperature has no unit: absolute zero is at {}, as for degrees Celsius; for "
                      "kelvin name it "
                      "'temperature [K]'",
                      choice_.held[i].front().text()));
    }
    choice_.temperature_at_zero = choice_.held[i].front()({});
  }

  void require_free_keys() const {
    for (const std::string& key : wishes_.free) {
      const std::size_t i = position("free", key);
      if (is_held_[i]) throw ConfigError(fmt::format("--free {0}: --set holds '{0}'", key));
      if (is_energy(i) && data_.temperatures().size() < 2)
        throw ConfigError(fmt::format("--free {}: {}; it takes tests at two temperatures at least", key,
                                      data_.has_temperature
                                          ? fmt::format("all tests are at {:g}", data_.temperatures().front())
                                          : "the data have no column 'temperature'"));
    }
  }

  void require_something_fitted() const {
    if (!choice_.fitted.empty()) return;
    throw ConfigError(
        fmt::format("law '{}' has nothing to be fitted: --set holds all its keys, or they are lists", name()));
  }

  void require_temperature_dependence() {
    const std::vector<double> temperatures = data_.temperatures();
    if (temperatures.size() < 2) return;
    if (fits_energy()) {
      std::vector<std::string> energies;
      for (const std::size_t i : choice_.fitted)
        if (is_energy(i)) energies.push_back(keys()[i].key);
      choice_.notes.push_back(
          fmt::format("{} temperatures: {} is fitted too", temperatures.size(), fmt::join(energies, ", ")));
      return;
    }
    const bool depends = std::ranges::any_of(choice_.held, [](const auto& values) {
      return std::ranges::any_of(values, &Function::depends_on_temperature);
    });
    for (std::size_t i = 0; i < keys().size(); ++i)
      if (is_energy(i) && is_held_[i]) return;
    if (depends) return;
    throw ConfigError(fmt::format(
        "{}: tests at {} temperatures ({:g} to {:g}), but the law '{}' has no activation energy; fit one "
        "temperature after the other (--temperature {:g}), or give a parameter as a function of T (--set)",
        data_.file, temperatures.size(), temperatures.front(), temperatures.back(), name(), temperatures.front()));
  }

  /// With one stress, an amplitude and the exponent of the stress in its unit are one number.
  void require_stresses() const {
    const std::vector<double> stresses = data_.stresses();
    if (stresses.size() > 1) return;
    std::vector<std::string> together;
    for (const std::size_t i : choice_.fitted)
      if (unit_uses(unit_in(keys()[i].description), "stress")) {
        for (const std::size_t other : choice_.fitted)
          if (unit_uses(unit_in(keys()[i].description), keys()[other].key) && other != i &&
              unit_uses(unit_in(keys()[i].description), "stress^" + keys()[other].key))
            together.push_back(fmt::format("{} and {}", keys()[i].key, keys()[other].key));
      }
    if (together.empty()) return;
    const std::string exponent = together.front().substr(together.front().rfind(' ') + 1);
    throw ConfigError(
        fmt::format("{}: all tests are at the stress {:g}: they cannot tell {} apart; add tests at other stresses, or "
                    "hold the exponent (--set {}=5)",
                    data_.file, stresses.front(), fmt::join(together, ", "), exponent));
  }

  const LawWishes& wishes_;
  const TestData& data_;
  LawChoice choice_;
  std::vector<bool> is_held_;
};

}  // namespace

LawChoice choose_law(const LawWishes& wishes, const TestData& data) {
  return Chooser(wishes, data).choose();
}

}  // namespace creepcontact::fit
