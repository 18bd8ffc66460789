#pragma once
/// Values of probes in an elastic state of the two blocks.

#include <map>
#include <string>
#include <vector>

#include "creepcontact/results/probes.hpp"
#include "support/run/blocks.hpp"

namespace creepcontact::run::test {

struct ProbeTable {
  std::string name, quantity, position;  ///< place: the keys on, at, body as TOML, separated by commas
  std::string reduce = {};
};

std::string probe_tables(const std::vector<ProbeTable>& probes);

/// The elastic state of the case at time t, and the probes' values in it by name.
std::map<std::string, double> probe(const Case& blocks, const std::vector<ProbeTable>& probes,
                                    const std::vector<std::string>& overrides = {}, const std::string& more = "",
                                    double t = 0);

void expect_values(const std::map<std::string, double>& found, const std::map<std::string, double>& expected,
                   double tolerance);

}  // namespace creepcontact::run::test
