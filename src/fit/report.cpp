#include "creepcontact/fit/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "creepcontact/base/one_line.hpp"
#include "creepcontact/base/toml_string.hpp"

namespace creepcontact::fit {
namespace {

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}

std::string span_of(const Interval& range, const std::string& unit) {
  return with_unit(fmt::format("{:.5g} .. {:.5g}", range.low, range.high), unit);
}

std::string percent(double logarithm) {
  return fmt::format("{:.1f} %", 100 * std::expm1(logarithm));
}

std::string correlation_table(const FitResult& result) {
  std::string text = "correlation of the parameters\n  ";
  std::size_t width = 9;
  for (const FittedParameter& parameter : result.parameters) width = std::max(width, parameter.key.size() + 2);
  text += fmt::format("{:<{}}", "", width);
  for (const FittedParameter& parameter : result.parameters) text += fmt::format("{:>{}}", parameter.key, width);
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    text += fmt::format("\n  {:<{}}", result.parameters[i].key, width);
    for (std::size_t j = 0; j <= i; ++j) {
      const double value = result.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      text += std::isnan(value) ? fmt::format("{:>{}}", "-", width) : fmt::format("{:>{}.3f}", value, width);
    }
  }
  return text + "\n";
}

std::string batches_table(const BatchScatter& scatter) {
  std::string text = fmt::format("factor on {} of each batch\n", scatter.key);
  std::size_t width = 12;
  for (const BatchScatter::Batch& batch : scatter.batches) width = std::max(width, batch.name.size() + 2);
  for (const BatchScatter::Batch& batch : scatter.batches)
    text += fmt::format("  {:<{}}{:>9.3g}   determined within a factor of {:.3g}; {} test{}\n", one_line(batch.name),
                        width, std::exp(batch.difference), std::exp(batch.deviation), batch.n_tests,
                        batch.n_tests == 1 ? "" : "s");
  return text + fmt::format("  from batch to batch: a factor of {:.3g} for one standard deviation\n",
                            std::exp(scatter.deviation));
}

std::string counted(int n, const std::string& what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::string basis(const TestData& data, const FitResult& result) {
  return fmt::format("{} of {}; root mean square of the residuals {}", counted(result.n_readings, "reading"),
                     counted(data.n_specimens(), "test"), percent(result.deviation));
}

std::string units_line(const TestUnits& units) {
  std::vector<std::string> words;
  if (!units.stress.empty()) words.push_back("stress " + units.stress);
  if (!units.time.empty()) words.push_back("time " + units.time);
  if (!units.temperature.empty()) words.push_back("temperature " + units.temperature);
  return words.empty() ? "those of the data, which name none" : fmt::format("{}", fmt::join(words, ", "));
}

/// What lets a model convert the numbers; empty if the data do not name the units of stress and time.
std::string units_key(const TestUnits& units) {
  if (units.stress.empty() || units.time.empty()) return "";
  return fmt::format("units = {}\n",
                     toml_string(fmt::format("{}, {}{}{}", units.stress, units.time,
                                             units.temperature.empty() ? "" : ", ", units.temperature)));
}

}  // namespace

std::string report(const TestData& data, const LawChoice& choice, const FitResult& result) {
  std::string text = fmt::format("law {}: {} ({})\ndata {}: {}\nunits: {}\n\n", choice.info->name, choice.info->formula,
                                 choice.info->source, one_line(data.file), basis(data, result), units_line(data.units));
  text += fmt::format("{:<20}{:>14}   {:<30}unit\n", "parameter", "value", "95 % confidence interval");
  for (const FittedParameter& parameter : result.parameters)
    text += fmt::format(
        "{:<20}{:>14.6g}   {:<30}{}\n", parameter.key, parameter.value,
        parameter.at_bound ? "at the end of its range" : fmt::format("{:.6g} .. {:.6g}", parameter.low, parameter.high),
        parameter.unit);
  for (const auto& [key, value] : choice.set) text += fmt::format("{:<20}{:>14}   held\n", key, value);
  text += '\n';
  if (result.parameters.size() > 1) text += correlation_table(result) + '\n';
  if (result.batches) text += batches_table(*result.batches) + '\n';
  text += "residuals, measured against fitted values (root mean square)\n";
  for (int k = 0; k < n_test_kinds; ++k) {
    const KindResiduals& kind = result.kinds[static_cast<std::size_t>(k)];
    if (kind.n > 0)
      text += fmt::format("  {:<12}{:<18}{:>9}   {}\n", name_of(static_cast<TestKind>(k)),
                          value_of(static_cast<TestKind>(k)), percent(kind.deviation), counted(kind.n, "reading"));
  }
  text += fmt::format("range of the data\n  stress      {}\n", span_of(result.range.stress, data.units.stress));
  if (data.has_temperature)
    text += fmt::format("  temperature {}\n", span_of(result.range.temperature, data.units.temperature));
  if (result.range.time.high > 0)
    text += fmt::format("  time        {}\n", span_of(result.range.time, data.units.time));
  return text + fmt::format("{} of {} searches from different starting points ended in this minimum\n",
                            result.n_agreeing, result.n_starts);
}

std::string why_useless(const LawChoice& choice, const FitResult& result) {
  constexpr double useless = std::numbers::ln2;  // logarithm of a factor of two
  if (!(result.deviation > useless)) return "";
  std::string text = fmt::format(
      "the root mean square of the residuals is {}: the law '{}' in this form does not describe the data, and its "
      "constants mean nothing; no material block is written",
      percent(result.deviation), choice.info->name);
  std::vector<std::string> keys, remedies;
  for (std::size_t i = 0; i < choice.fitted.size(); ++i) {
    const material::ParameterInfo& key = choice.parameter(i);
    if (std::ranges::count(key.variables, "q") == 0) continue;
    keys.push_back(key.key);
    remedies.push_back(fmt::format("--set '{}=EXPRESSION in {}'", key.key, fmt::join(key.variables, ", ")));
  }
  if (keys.empty()) return text + "; take another law";
  return text +
         fmt::format(". {} fitted as a number, the same at all stresses: give {} as a function of the stress q, {}",
                     keys.size() > 1 ? fmt::format("{} are each", fmt::join(keys, ", ")) : keys.front() + " is",
                     keys.size() > 1 ? "one of them" : "it", fmt::join(remedies, " or "));
}

std::string material_block(const TestData& data, const LawChoice& choice, const FitResult& result,
                           const BlockOptions& options) {
  const std::string& name = options.material;
  std::string text = fmt::format("{} to {}: {}.\n# Units: {}.\n", block_heading, one_line(data.file),
                                 basis(data, result), units_line(data.units));
  const bool elastic = options.young_modulus.has_value();
  if (!elastic)
    text +=
        "# The elastic constants are not part of the fit: the material needs this table too, once, before this "
        "block.\n";
  const char* const comment = elastic ? "" : "# ";
  const std::string modulus = !elastic ? "..."
                              : options.young_modulus->is_constant()
                                  ? fmt::format("{}", (*options.young_modulus)({}))
                                  : fmt::format("\"{}\"", options.young_modulus->text());
  const std::string units = units_key(data.units);
  text += fmt::format("{0}[materials.{1}]\n{2}{0}young_modulus = {3}\n{0}poisson_ratio = {4}   # not fitted\n", comment,
                      name, elastic ? units : "", modulus, options.poisson_ratio);
  if (elastic)
    text += fmt::format("sources = {}\n", toml_string(fmt::format("fitted to {}: {}", data.file, basis(data, result))));
  text += fmt::format("\n[[materials.{}.creep]]\nlaw = \"{}\"\n{}", name, choice.info->name, units);
  for (const FittedParameter& parameter : result.parameters)
    text += fmt::format("{} = {:.8g}   # {}\n", parameter.key, parameter.value,
                        parameter.at_bound
                            ? "at the end of its range"
                            : fmt::format("{:.4g} .. {:.4g} with 95 % confidence", parameter.low, parameter.high));
  for (const auto& [key, value] : choice.set) text += fmt::format("{} = {}   # held\n", key, value);
  text += "# `run` warns where a body leaves the range of the tests.\n";
  const auto interval = [&](const char* key, const Interval& range) {
    text += fmt::format("{} = [{:.6g}, {:.6g}]\n", key, range.low, range.high);
  };
  interval("stress_range", result.range.stress);
  if (data.has_temperature) interval("temperature_range", result.range.temperature);
  if (result.range.time.high > 0) interval("time_range", result.range.time);
  return text;
}

std::string scatter_block(const TestData& data, const LawChoice& choice, const FitResult& result) {
  std::vector<std::string> keys, values, logarithmic, deviations, rows;
  std::vector<Eigen::Index> known;
  for (std::size_t i = 0; i < result.parameters.size(); ++i)
    if (const FittedParameter& parameter = result.parameters[i]; !parameter.at_bound && parameter.deviation > 0) {
      known.push_back(static_cast<Eigen::Index>(i));
      keys.push_back(toml_string(parameter.key));
      values.push_back(fmt::format("{:.8g}", parameter.value));  // as in the block
      logarithmic.emplace_back(parameter.is_logarithmic ? "true" : "false");
      deviations.push_back(fmt::format("{}", parameter.deviation));
    }
  if (known.empty()) return "";
  for (const Eigen::Index i : known) {
    std::vector<std::string> row;
    for (const Eigen::Index j : known) row.push_back(i == j ? "1.0" : fmt::format("{}", result.correlation(i, j)));
    rows.push_back(fmt::format("  [{}]", fmt::join(row, ", ")));
  }
  std::string batches;
  if (result.batches) {
    std::vector<std::string> names, factors;
    for (const BatchScatter::Batch& batch : result.batches->batches) {
      names.push_back(toml_string(batch.name));
      factors.push_back(fmt::format("{:.6g}", std::exp(batch.difference)));
    }
    batches = fmt::format(
        "\n# How batches differ: the standard deviation of the logarithm of one constant from batch to batch. The "
        "constants\n# above are those of the mean batch.\n[batches]\nkey = {}\ndeviation = {}\nnames = [{}]\nfactors = "
        "[{}]\n",
        toml_string(result.batches->key), result.batches->deviation, fmt::join(names, ", "), fmt::join(factors, ", "));
  }
  return fmt::format(
      "{} to {}: {}.\n# How well the readings determine the constants, for `fit` in a study's [[random.keys]]. Units: "
      "{}.\nlaw = {}\nkeys = [{}]\nvalues = [{}]\n# Standard deviations, of the logarithm where `logarithmic` says "
      "so.\n"
      "logarithmic = [{}]\ndeviations = [{}]\ncorrelation = [\n{}\n]\n{}",
      block_heading, one_line(data.file), basis(data, result), units_line(data.units), toml_string(choice.info->name),
      fmt::join(keys, ", "), fmt::join(values, ", "), fmt::join(logarithmic, ", "), fmt::join(deviations, ", "),
      fmt::join(rows, ",\n"), batches);
}

}  // namespace creepcontact::fit
