#include "support/run/probing.hpp"

namespace creepcontact::run::test {

std::string probe_tables(const std::vector<ProbeTable>& probes) {
  std::string text = "probes = [\n";
  for (const ProbeTable& probe : probes) {
    text += "  { name = '" + probe.name + "', quantity = '" + probe.quantity + "', " + probe.position;
    text += (probe.reduce.empty() ? "" : ", reduce = '" + probe.reduce + "'") + " },\n";
  }
  return text + "]\n";
}

std::map<std::string, double> probe(const Case& blocks, const std::vector<ProbeTable>& probes,
                                    const std::vector<std::string>& overrides, const std::string& more, double t) {
  const config::Config config = blocks.parse(probe_tables(probes) + case_text + more, overrides);
  System system(config);
  const auto made = make_probes(config, system.model);
  const std::vector<double> y(system.rate.size());
  Snapshot snapshot(system.rate, t, system.rate.evaluate_output(t, y));
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < made.size(); ++i) values[config.probes[i].name] = made[i]->value(snapshot);
  return values;
}

void expect_values(const std::map<std::string, double>& found, const std::map<std::string, double>& expected,
                   double tolerance) {
  EXPECT_EQ(found.size(), expected.size());
  for (const auto& [name, value] : expected) {
    ASSERT_TRUE(found.contains(name)) << name;
    EXPECT_NEAR(found.at(name), value, tolerance) << name;
  }
}

}  // namespace creepcontact::run::test
