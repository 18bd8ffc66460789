#include "fitted_scatter.hpp"

#include <fmt/format.h>

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "toml_document.hpp"

namespace creepcontact::config {
namespace {

/// A list of n values of one type; empty: there is none.
template <class T>
std::vector<T> list_of(const toml::node_view<const toml::node>& node, std::size_t n) {
  std::vector<T> all;
  const toml::array* const found = node.as_array();
  if (found == nullptr || found->size() != n) return {};
  for (const toml::node& one : *found) {
    const auto value = one.value<T>();
    if (!value) return {};
    all.push_back(*value);
  }
  return all;
}

/// What differs from batch to batch adds to how well the readings determine a constant: samples are of new batches.
/// @returns false if [batches] is not as it should be
bool add_batches(const toml::table& content, FittedScatter& scatter) {
  if (!content.contains("batches")) return true;
  const auto key = content["batches"]["key"].value<std::string>();
  const auto deviation = content["batches"]["deviation"].value<double>();
  const toml::array* const names = content["batches"]["names"].as_array();
  for (std::size_t i = 0; key && deviation && names != nullptr && i < scatter.constants.size(); ++i) {
    FittedConstant& constant = scatter.constants[i];
    if (constant.key != *key || !constant.is_logarithmic || !(*deviation >= 0) || names->size() < 2) continue;
    const double of_mean = *deviation / std::sqrt(static_cast<double>(names->size()));
    const double all = std::hypot(constant.deviation, *deviation, of_mean), share = constant.deviation / all;
    constant.deviation = all;
    for (std::size_t j = 0; j < scatter.constants.size(); ++j)
      if (j != i) {
        scatter.correlation[i][j] *= share;
        scatter.correlation[j][i] *= share;
      }
    return true;
  }
  return false;
}

}  // namespace

std::optional<FittedScatter> read_fitted_scatter(const std::filesystem::path& file, const Location& place,
                                                 Diagnostics& errors) {
  toml::table document;
  try {
    document = parse_toml(read_text(file), file, [] { return std::vector<KeyInfo>(); });
  } catch (const ConfigError& error) {
    errors.add(place, error.what());
    return std::nullopt;
  }
  const toml::table& content = document;
  const toml::array* const names = content["keys"].as_array();
  const std::size_t n = names != nullptr ? names->size() : 0;
  const auto keys = list_of<std::string>(content["keys"], n);
  const auto values = list_of<double>(content["values"], n), deviations = list_of<double>(content["deviations"], n);
  const auto logarithmic = list_of<bool>(content["logarithmic"], n);
  FittedScatter scatter;
  for (std::size_t i = 0; i < n; ++i) scatter.correlation.push_back(list_of<double>(content["correlation"][i], n));
  const auto is_whole = [&] {
    if (n == 0 || keys.empty() || values.empty() || deviations.empty() || logarithmic.empty()) return false;
    for (std::size_t i = 0; i < n; ++i)
      if (!(deviations[i] > 0) || scatter.correlation[i].empty() || (logarithmic[i] && !(values[i] > 0))) return false;
    return true;
  };
  if (!is_whole()) {
    errors.add(place, fmt::format("'{}' does not hold the scatter of a fit", file.string()),
               "the file <name>_scatter.toml that `creepcontact fit --output <name>.toml` writes");
    return std::nullopt;
  }
  for (std::size_t i = 0; i < n; ++i) scatter.constants.push_back({keys[i], values[i], logarithmic[i], deviations[i]});
  const bool is_added = add_batches(content, scatter);
  if (!is_added)
    errors.add(place, fmt::format("[batches] of '{}' does not hold the scatter of one of its constants", file.string()),
               "the file that `creepcontact fit` writes");
  return is_added ? std::optional(scatter) : std::nullopt;
}

}  // namespace creepcontact::config
