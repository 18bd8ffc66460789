#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "creepcontact/settings/enum_names.hpp"
#include "scatter_tables.hpp"

namespace creepcontact::study {
namespace {

constexpr std::size_t most_groups = 12;  // that are told of in words

std::string row_text(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string head_text(const std::vector<std::string>& cells) {
  std::string text = row_text(cells) + "|";
  for (std::size_t i = 0; i < cells.size(); ++i) text += "---|";
  return text + "\n";
}

std::string short_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : "?";
}

std::string probability_text(double probability) {
  return fmt::format("{:.3g} %", 100 * probability);
}

std::string in_code(const std::string& text) {
  return '`' + text + '`';
}

std::string counted_runs(const ScatterGroup& group) {
  std::string text = fmt::format("{} of {} samples were computed", group.succeeded, group.planned);
  if (group.failed > 0) text += fmt::format("; {} failed and are not counted", group.failed);
  if (group.missing > 0) text += fmt::format("; {} are missing", group.missing);
  if (group.ruptured > 0)
    text += fmt::format(
        "; {} ruptured: after its rupture a run has no values, so later quantiles are those of the runs that last (the "
        "column `samples`)",
        group.ruptured);
  return text + ".\n\n";
}

std::string ends_text(const Scatter& scatter, const ScatterGroup& group) {
  if (group.times.empty()) return "No run has come to its end.\n\n";
  std::vector<std::string> heads{fmt::format("at t = {:.6g}", group.times.back())};
  for (const double quantile : scatter.quantiles) heads.push_back(probability_text(quantile));
  std::string text = head_text(heads);
  bool is_unbounded = false;
  for (std::size_t p = 0; p < scatter.probes.size(); ++p) {
    std::vector<std::string> cells{in_code(scatter.probes[p])};
    for (const QuantileEstimate& one : group.probes[p].at.back()) {
      is_unbounded |= std::isnan(one.low) || std::isnan(one.high);
      cells.push_back(
          fmt::format("{} ({} to {})", short_number(one.value), short_number(one.low), short_number(one.high)));
    }
    text += row_text(cells);
  }
  text += fmt::format(
      "\nIn parentheses are bounds that hold the true quantile with a probability of {:.0f} %, as if the samples were "
      "independent; with `sobol` and `latin_hypercube` the quantiles are mostly closer.{}\n\n",
      100 * statistics::confidence, is_unbounded ? " ?: so few samples do not bound this quantile on this side." : "");
  return text;
}

std::string happenings_text(const ScatterGroup& group) {
  if (group.happenings.empty() || group.times.empty() || group.succeeded == 0) return "";
  std::string text = head_text({"what happens", "runs", "probability until the end", "bounds"});
  for (const Happening& one : group.happenings) {
    const statistics::Proportion p = probability_at(one, group.times.back());
    const std::string name =
        one.is_at_end ? fmt::format("criterion `{}` is not met", one.name.substr(8)) : in_code(one.name);
    text += row_text(
        {name, fmt::format("{:.0f} of {}", p.value * static_cast<double>(one.times.size()), one.times.size()),
         probability_text(p.value), fmt::format("{} to {}", probability_text(p.low), probability_text(p.high))});
  }
  return text + "\n";
}

/// One result: which key it goes with, and what share of its variance comes from it.
std::string influence_text(const Scatter& scatter, const ScatterGroup& group) {
  std::vector<std::string> heads{"result"};
  for (const std::string& key : scatter.keys) heads.push_back(in_code(key));
  if (!scatter.is_correlated) heads.emplace_back("quality");
  std::string text = head_text(heads);
  bool any = false;
  std::string partial;
  for (std::size_t r = 0; r < group.results.size(); ++r) {
    const bool is_constant = leading_key(group, r) == scatter.keys.size();
    if (is_constant) continue;
    any = true;
    const std::vector<double>& values = group.results[r].values;
    const auto known = std::ranges::count_if(values, [](double value) { return std::isfinite(value); });
    if (known < std::ssize(values))
      partial += fmt::format("`{}`: of the {} of {} runs that have it.\n", group.results[r].name, known, values.size());
    const bool has_shares = !scatter.is_correlated && !group.shares[r].first_order.empty();
    const bool is_good = has_shares && group.shares[r].quality >= min_quality;
    std::vector<std::string> cells{in_code(group.results[r].name)};
    for (std::size_t k = 0; k < scatter.keys.size(); ++k) {
      const double rank = group.rank_correlations[r][k];
      std::string cell = std::isnan(rank) ? "" : fmt::format("{:+.2f}", rank);
      if (is_good) cell += fmt::format(", {:.0f} %", 100 * group.shares[r].first_order[k]);
      cells.push_back(cell);
    }
    if (!scatter.is_correlated) cells.push_back(has_shares ? fmt::format("{:.2f}", group.shares[r].quality) : "");
    text += row_text(cells);
  }
  if (!any) return "";
  text = "Spearman's rank correlation with each key" +
         std::string(scatter.is_correlated ? "" : ", and the share of the variance that comes from it alone") +
         ":\n\n" + text + "\n" + partial + (partial.empty() ? "" : "\n");
  if (scatter.is_correlated) return text + "The keys are correlated, so the variance cannot be divided among them.\n\n";
  return text +
         "The shares are those of a polynomial of degree 2 or less, fitted to the results; `quality` says how well it "
         "predicts runs that are left out (1: exactly). Below " +
         fmt::format(
             "{} no shares are given; what is missing to 100 % are interactions and errors of the polynomial.\n\n",
             min_quality);
}

}  // namespace

std::string scatter_markdown(const config::Study& study, const Scatter& scatter) {
  const config::Random& random = *study.random;
  std::string text =
      fmt::format("## Scatter\n\n{} samples ({}, seed {}){}.\n\n", random.samples, settings::name_of(random.method),
                  random.seed, scatter.groups.size() > 1 ? " for each combination of the axes, the same ones" : "");
  text += head_text({"random key", "distribution"});
  for (const config::RandomKey& key : random.keys)
    text += row_text({in_code(key.key.name), config::description_of(key)});
  text += "\n";
  for (const config::RandomCorrelation& one : random.correlations)
    text += fmt::format("`{}` and `{}` have the correlation {:.3g}.\n", one.keys[0].name, one.keys[1].name, one.value);
  if (!random.correlations.empty()) text += "\n";
  if (scatter.is_thinned)
    text += "There are so many runs and output times that quantiles are given at some of these times only.\n\n";
  for (std::size_t g = 0; g < std::min(most_groups, scatter.groups.size()); ++g) {
    const ScatterGroup& group = scatter.groups[g];
    if (!group.label.empty()) text += fmt::format("### {}\n\n", group.label);
    text += counted_runs(group) + ends_text(scatter, group) + happenings_text(group) + influence_text(scatter, group);
  }
  if (scatter.groups.size() > most_groups)
    text +=
        fmt::format("The first {} of {} combinations; the tables have all.\n\n", most_groups, scatter.groups.size());
  return text + "Tables: `samples.csv`, `quantiles.csv`, `probabilities.csv`, `correlation.csv`, `convergence.csv`" +
         (scatter.is_correlated ? "" : ", `sobol_indices.csv`") + ".\n\n";
}

}  // namespace creepcontact::study
