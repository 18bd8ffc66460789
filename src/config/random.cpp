#include "creepcontact/config/random.hpp"

#include <fmt/format.h>

#include <charconv>

#include "creepcontact/base/overload.hpp"

namespace creepcontact::config {

std::vector<double> scores_of(const Random& random) {
  std::vector<double> scores = statistics::normal_points(random.method, static_cast<std::uint64_t>(random.seed),
                                                         random.n_samples(), random.keys.size());
  if (!random.factor.empty()) statistics::correlate(scores, random.factor, random.keys.size());
  return scores;
}

double sampled_value(const RandomKey& key, double score) {
  const std::string text = fmt::format("{:.12g}", statistics::value_at(key.distribution, score));
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string description_of(const RandomKey& key) {
  return std::visit(
      Overload{[](const statistics::Normal& one) {
                 return fmt::format("normal, mean {}, standard deviation {}", one.mean, one.deviation);
               },
               [](const statistics::Lognormal& one) {
                 return fmt::format("lognormal, median {}, factor {:.4g}", one.median, one.factor);
               },
               [](const statistics::Uniform& one) { return fmt::format("uniform, {} to {}", one.min, one.max); },
               [](const statistics::Triangular& one) {
                 return fmt::format("triangular, {} to {}, most frequent {}", one.min, one.max, one.mode);
               },
               [](const statistics::Table& one) {
                 return fmt::format("table of {} values, {} to {}", one.values.size(), one.values.front(),
                                    one.values.back());
               }},
      key.distribution);
}

}  // namespace creepcontact::config
