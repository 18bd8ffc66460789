#include "random_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <span>
#include <sstream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/config/reader.hpp"
#include "item.hpp"
#include "key_content.hpp"

namespace creepcontact::config {
namespace {

constexpr double rare = 1e-6;  // values beyond this probability may be impossible
constexpr double max_mismatch = 1e-6;

/// A number that TOML takes for a floating-point one.
std::string toml_number(double value) {
  const std::string text = fmt::format("{}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

bool is_bounded(const RandomKey& key) {
  return !std::holds_alternative<statistics::Normal>(key.distribution) &&
         !std::holds_alternative<statistics::Lognormal>(key.distribution);
}

double end_of(const RandomKey& key, int side) {
  const double score = is_bounded(key) ? std::numeric_limits<double>::infinity() : -statistics::normal_score(rare);
  return sampled_value(key, side * score);
}

std::string percent_text(double probability) {
  return probability < 1e-3 ? fmt::format("{:.1g}", probability) : fmt::format("{:.2g} %", 100 * probability);
}

/// How often the distribution has such values, and what to do.
std::string advice_for(const RandomKey& key, int side, double end) {
  const std::string range = fmt::format("the distribution ({}) reaches {}", description_of(key), end);
  if (is_bounded(key)) return range + "; give it values that the key may have";
  if (key.kind == "lognormal")
    return range + fmt::format(
                       " with a probability of {}; a smaller 'factor', or \"triangular\" or \"uniform\" with "
                       "ends that the key may have",
                       percent_text(rare));
  const double negative = statistics::probability_below(key.distribution, 0);
  const std::string how_often = side < 0 && end < 0
                                    ? fmt::format("is negative with a probability of {}", percent_text(negative))
                                    : fmt::format("reaches {} with a probability of {}", end, percent_text(rare));
  return fmt::format(
      "the distribution ({}) {}; take \"lognormal\", which has no negative values, or \"triangular\" or \"uniform\" "
      "with ends that the key may have",
      description_of(key), how_often);
}

/// Adds the lines of a message about one of these random keys, each at its key; the others at the first key.
/// @param settings  of the keys @param advice  to add
void add_lines(const std::string& message, std::span<const RandomKey> keys, std::span<const Setting> settings,
               const std::string& advice, Diagnostics& errors) {
  std::istringstream all(message);
  for (std::string line; std::getline(all, line);) {
    std::size_t key = 0;
    for (std::size_t k = 0; k < settings.size(); ++k) {
      const std::string begin = std::string(override_prefix) + settings[k].override_text() + ": ";
      if (!line.starts_with(begin)) continue;
      line.erase(0, begin.size());
      key = k;
      break;
    }
    errors.add(keys[key].key.location, line + advice);
  }
}

}  // namespace

Setting sampled_setting(const RandomKey& key, double value) {
  const std::string text = toml_number(value);
  return {key.key.name, key.key.location, {text, text, key.key.location}};
}

void check_random_keys(const Study& study, const std::vector<Setting>& settings, const Vocabulary& vocabulary,
                       Diagnostics& errors) {
  const Random& random = *study.random;
  std::vector<std::string> names;
  for (const RandomKey& key : random.keys) names.push_back(key.key.name);
  const std::vector<KeyContent> contents = contents_of(study.base, vocabulary, overrides(study, settings), names);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const RandomKey& key = random.keys[k];
    if (contents[k].kind == KeyContent::Kind::other)
      errors.add(key.key.location,
                 fmt::format("'{}' is {} in {}", key.key.name, contents[k].description, study.base.string()),
                 "keys whose value is a number; a function can be varied as a whole on an axis");
    if (key.fitted && contents[k].kind == KeyContent::Kind::number &&
        !(std::abs(contents[k].number - *key.fitted) <= max_mismatch * std::abs(*key.fitted)))
      errors.add(key.location,
                 fmt::format("the fit found {} = {:.8g}, but {} has {:.8g}", key.key.name, *key.fitted,
                             study.base.string(), contents[k].number),
                 "the constants of this fit in the base, in its units; take the block that it wrote, or fit again");
  }
  if (!errors.empty()) return;

  std::vector<Setting> medians;
  for (const RandomKey& key : random.keys) medians.push_back(sampled_setting(key, sampled_value(key, 0)));
  const auto complaint = [&](const std::vector<Setting>& sampled) -> std::string {
    std::vector<Setting> all = settings;
    all.insert(all.end(), sampled.begin(), sampled.end());
    try {
      read(study.base, vocabulary, overrides(study, all));
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    }
  };
  if (const std::string message = complaint(medians); !message.empty())
    return add_lines(message, random.keys, medians, "", errors);  // not the distribution is at fault, but the key
  for (std::size_t k = 0; k < names.size(); ++k)
    for (const int side : {-1, 1}) {
      const RandomKey& key = random.keys[k];
      const double end = end_of(key, side);
      std::vector<Setting> own = medians;
      own[k] = sampled_setting(key, end);
      const std::string message = complaint(own);
      if (message.empty()) continue;
      add_lines(message, std::span(random.keys).subspan(k, 1), std::span(own).subspan(k, 1),
                ". " + advice_for(key, side, end), errors);
      break;  // one side is enough to act on
    }
}

}  // namespace creepcontact::config
