#include "sensitivity_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engineering.hpp"

namespace creepcontact::report {
namespace {

using Sensitivity = io::Summary::Sensitivity;

/// Change of a result in per cent of itself for an input that grows by one per cent; nullopt: the result is zero.
std::optional<double> percent(double derivative, const Sensitivity& input, double result) {
  const double effect = derivative * input.change / std::abs(result);
  return std::isfinite(effect) ? std::optional(effect) : std::nullopt;
}

struct Row {
  std::string name;
  std::vector<std::optional<double>> effects;  // by input

  double largest() const {
    double most = 0;
    for (const std::optional<double>& effect : effects) most = std::max(most, std::abs(effect.value_or(0)));
    return most;
  }
};

std::vector<Row> rows_of(const io::Summary& summary) {
  std::vector<Row> rows;
  for (const auto& [name, probe] : summary.probes) {
    if (!probe.course) continue;
    Row row{name, {}};
    for (const Sensitivity& input : summary.sensitivities) {
      const auto found = input.probes.find(name);
      row.effects.push_back(found == input.probes.end() ? std::nullopt
                                                        : percent(found->second, input, probe.course->end));
    }
    rows.push_back(std::move(row));
  }
  for (const auto& [name, time] : summary.events) {
    if (!time) continue;
    Row row{fmt::format("time of the event '{}'", name), {}};
    for (const Sensitivity& input : summary.sensitivities) {
      const auto found = input.events.find(name);
      row.effects.push_back(found == input.events.end() ? std::nullopt : percent(found->second, input, *time));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The number of the input that moves a result most.
std::string strongest(const Row& row) {
  const double most = row.largest();
  for (std::size_t k = 0; k < row.effects.size(); ++k)
    if (most > 0 && row.effects[k] && std::abs(*row.effects[k]) == most) return std::to_string(k + 1);
  return "-";
}

}  // namespace

void add_sensitivities(const RunData& run, Html& page) {
  if (!run.summary || run.summary->sensitivities.empty()) return;
  const std::vector<Sensitivity>& inputs = run.summary->sensitivities;
  page.open("section", "id=\"sensitivities\"");
  page.element("h2", "Which input moves the answer most");
  page.element(
      "p",
      "Change of each result at the end, in per cent of its value, if an input grows by one per cent: of its "
      "magnitude, or of the typical change given for it. These are derivatives, which hold for small changes.");
  std::vector<std::vector<std::string>> list;
  std::vector<std::string> head{"result"};
  for (const Sensitivity& input : inputs) {
    head.push_back(std::to_string(head.size()));
    list.push_back({head.back(), input.key, readable(fmt::format("{}", input.value)),
                    readable(fmt::format("{:.4g}", input.change / 100))});
  }
  head.emplace_back("most");
  page.table({"", "input", "value", "one per cent"}, list, "Inputs");
  std::vector<std::vector<std::string>> cells;
  for (const Row& row : rows_of(*run.summary)) {
    std::vector<std::string>& line = cells.emplace_back(std::vector<std::string>{row.name});
    for (const std::optional<double>& effect : row.effects)
      line.push_back(effect ? fmt::format("{:.3g}", *effect) : "-");
    line.push_back(strongest(row));
  }
  page.table(head, cells, "Change in per cent for one per cent of each input");
  page.close("section");
}

}  // namespace creepcontact::report
