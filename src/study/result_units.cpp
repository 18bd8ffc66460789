#include "result_units.hpp"

#include <fmt/format.h>

#include "creepcontact/base/units.hpp"
#include "creepcontact/config/reader.hpp"

namespace creepcontact::study {

std::string ResultUnits::labelled(const std::string& probe, const std::string& more) const {
  const auto unit = probes.find(probe);
  if (unit == probes.end() || unit->second.empty()) return probe + more;
  return fmt::format("{}{} ({})", probe, more, unit->second);
}

ResultUnits result_units(const config::Study& study, const config::Vocabulary& vocabulary,
                         const StudyOptions& options) {
  if (!options.unit_of_probe) return {};
  const config::Config base =
      config::read(study.base, vocabulary, config::overrides(study, std::vector<config::Setting>()));
  ResultUnits units{.time = unit_of(Dimension::time, base.units), .probes = {}};
  for (const config::Probe& probe : base.probes) units.probes[probe.name] = options.unit_of_probe(probe, base.units);
  return units;
}

}  // namespace creepcontact::study
