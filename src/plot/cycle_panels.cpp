#include <algorithm>
#include <cmath>

#include "creepcontact/plot/run_plots.hpp"

namespace creepcontact::plot {
namespace {

/// Columns `<body>.<one of some names>` as curves over the cycles; those that are zero throughout are left out.
class BodyCurves {
 public:
  explicit BodyCurves(const io::CsvTable& cycles) : cycles_(cycles), numbers_(*cycles.column("cycle")) {}

  /// Adds as many panels as the curves need, none if there are none.
  void add(const std::string& label, const std::vector<std::string>& names, std::vector<Panel>& panels) const {
    std::vector<Series> curves;
    for (std::size_t c = 0; c < cycles_.names.size(); ++c) {
      const std::string& column = cycles_.names[c];
      const std::size_t point = column.rfind('.');
      if (point == std::string::npos || std::ranges::find(names, column.substr(point + 1)) == names.end()) continue;
      const std::vector<double>& values = cycles_.columns[c];
      if (std::ranges::any_of(values, [](double value) { return std::isfinite(value) && value != 0; }))
        curves.push_back({column, numbers_, values});
    }
    auto next = curves.begin();
    for (std::size_t size : even_parts(curves.size(), max_colors)) {
      panels.push_back({{label}, {next, next + static_cast<long>(size)}});
      next += static_cast<long>(size);
    }
  }

 private:
  const io::CsvTable& cycles_;
  const std::vector<double>& numbers_;
};

}  // namespace

std::vector<Panel> cycle_panels(const io::CsvTable& cycles, const io::SummaryHeading& heading,
                                const std::vector<std::string>& probes) {
  const std::vector<double>& numbers = *cycles.column("cycle");
  io::CsvTable of_probes{{"cycle"}, {numbers}};
  io::SummaryHeading kinds = heading;
  for (const auto& [name, probe] : heading.probes) {
    if (!probes.empty() && std::ranges::find(probes, name) == probes.end()) continue;
    for (const char* extreme : {"_max", "_min"}) {
      const std::string column = name + extreme;
      const std::vector<double>* values = cycles.column(column);
      if (values == nullptr) continue;
      of_probes.names.push_back(column);
      of_probes.columns.push_back(*values);
      kinds.probes[column] = probe;
    }
  }
  std::vector<Panel> panels = history_panels(of_probes, kinds);
  const BodyCurves curves(cycles);
  curves.add("strain range per cycle", {"inelastic_strain_range", "strain_range"}, panels);
  curves.add("life used", {"damage", "life_fraction", "fatigue_fraction", "creep_fatigue"}, panels);
  return panels;
}

}  // namespace creepcontact::plot
