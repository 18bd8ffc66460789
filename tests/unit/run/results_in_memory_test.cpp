/// Runs without files: the results in memory are those of the files, and what is kept changes none of them.

#include "creepcontact/run/results_in_memory.hpp"

#include <filesystem>

#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

const std::vector<std::string> four_outputs{"time.output=[0.5, 1, 1.6, 3]", "output.fields=[0, 1]"};

TEST(ResultsInMemory, AreThoseOfTheFiles) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe, four_outputs);
  ASSERT_EQ(run(config, {.output = (blocks / "out").string()}).exit_status, 0);
  ResultsInMemory memory(config);
  const Summary summary =
      run(config, {.output = (blocks / "none").string(), .writes_files = false, .observers = {&memory}});
  EXPECT_EQ(summary.exit_status, 0) << summary.message;
  EXPECT_EQ(summary.directory, "");
  EXPECT_FALSE(std::filesystem::exists(blocks / "none"));

  const Table history(blocks / "out/history.csv"), steps(blocks / "out/steps.csv");
  EXPECT_EQ(memory.times(), history.times());
  EXPECT_EQ(memory.probe_values(), history.column("pressure"));
  ASSERT_EQ(memory.steps().size(), steps.times().size());
  for (std::size_t i = 0; i < memory.steps().size(); ++i) EXPECT_EQ(memory.steps()[i].time, steps.times()[i]);
  ASSERT_EQ(memory.fields().size(), 2U);
  for (const io::FieldData& field : memory.fields().at(1).at_points)
    EXPECT_EQ(field.values.size(), field.components * memory.mesh().points.size()) << field.name;
  EXPECT_FALSE(memory.fields().at(1).on_contacts.empty());
  EXPECT_GT(memory.groups().at("bottom").size(), 0U);
  for (const std::int64_t node : memory.groups().at("bottom"))
    EXPECT_NEAR(memory.mesh().points[static_cast<std::size_t>(node)][2], -2, 1e-12);
}

TEST(ResultsInMemory, OfCyclesThatAreJumpedOver) {
  const Case blocks;
  const std::vector<std::string> cycles{"time.end=40", "time.cycle=1", "time.jump_cycles=true", "time.output=[10, 40]",
                                        "supports.3.displacement={z=\"-0.025*(1 + 0.1*sin(2*_pi*t))\"}"};
  const config::Config config = blocks.config(pressure_probe, cycles);
  ASSERT_EQ(run(config, {.output = (blocks / "out").string()}).exit_status, 0);
  ResultsInMemory memory(config);
  ASSERT_EQ(run(config, {.output = "", .writes_files = false, .observers = {&memory}}).exit_status, 0);
  const Table steps(blocks / "out/steps.csv");
  ASSERT_EQ(memory.steps().size(), steps.times().size());
  for (std::size_t i = 0; i < memory.steps().size(); ++i) EXPECT_EQ(memory.steps()[i].time, steps.times()[i]);
}

TEST(Kept, MeshesAndFactorsAreUsedAgain) {
  const Case blocks;
  Kept kept;
  const auto results = [&](const std::vector<std::string>& more, Kept* with) {
    std::vector<std::string> all = four_outputs;
    all.insert(all.end(), more.begin(), more.end());
    const config::Config config = blocks.config(pressure_probe, all);
    ResultsInMemory memory(config);
    const Summary summary = run(config, {.output = "", .writes_files = false, .kept = with, .observers = {&memory}});
    EXPECT_EQ(summary.exit_status, 0) << summary.message;
    return std::pair(memory.probe_values(), summary.results.factorizations);
  };
  const std::string creep = "materials.soft.creep.0.A=2e-3", stiff = "materials.soft.young_modulus=110";
  const auto [first, n_first] = results({}, &kept);
  const auto [second, n_second] = results({creep}, &kept);
  const auto [third, n_third] = results({stiff}, &kept);
  EXPECT_EQ(first, results({}, nullptr).first);
  EXPECT_EQ(second, results({creep}, nullptr).first);
  EXPECT_EQ(third, results({stiff}, nullptr).first);
  EXPECT_EQ(std::tuple(n_first, n_second, n_third), std::tuple(2, 0, 1));
  EXPECT_EQ(kept.meshes.n_read(), 1);
  EXPECT_EQ(kept.meshes.n_coupled(), 1);
  results({"mesh.order=2"}, &kept);
  EXPECT_EQ(kept.meshes.n_read(), 2);
  results({"bodies.lower.region=\"lower\""}, &kept);  // the mesh of before is still there
  EXPECT_EQ(kept.meshes.n_read(), 2);
  EXPECT_EQ(kept.meshes.n_coupled(), 2);
}

TEST(Kept, CouplingsAreUsedAgainWhereNothingOfThemHasChanged) {
  const Case blocks;
  Kept kept;
  const auto results = [&](const std::string& change, Kept* with) {
    std::vector<std::string> all = four_outputs;
    all.push_back(change);
    const config::Config config = blocks.config(pressure_probe, all);
    ResultsInMemory memory(config);
    const Summary summary = run(config, {.output = "", .writes_files = false, .kept = with, .observers = {&memory}});
    EXPECT_EQ(summary.exit_status, 0) << change << ": " << summary.message;
    return memory.probe_values();
  };
  for (const auto& [change, n_coupled] : {std::pair{"title=\"first\"", 1},
                                          {"contacts.0.gap=1e-4", 1},
                                          {"materials.soft.poisson_ratio=0.25", 1},
                                          {"contacts.0.friction=0.2", 2},
                                          {"contacts.0.slave=\"upper_bottom\"", 3},
                                          {"title=\"second\"", 3},
                                          {"supports.3.displacement={x=0, z=-0.02}", 4}}) {
    EXPECT_EQ(results(change, &kept), results(change, nullptr)) << change;
    EXPECT_EQ(kept.meshes.n_coupled(), n_coupled) << change;
  }
}

}  // namespace
}  // namespace creepcontact::run::test
