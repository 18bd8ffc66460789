#include "creepcontact/plot/overlay_plots.hpp"

#include <gtest/gtest.h>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"

namespace creepcontact::plot {
namespace {

RunTables run_with(const std::vector<std::string>& probes, double end = 4) {
  RunTables run{"somewhere", {{"time"}, {{0, 1, end}}}, {}, {}};
  for (const std::string& probe : probes) {
    run.history.names.push_back(probe);
    run.history.columns.push_back({3, 2, 1});
  }
  run.heading.units = "mm, MPa, h";
  run.heading.probes["p"] = {.quantity = "contact_pressure",
                             .label = "contact pressure",
                             .dimension = Dimension::stress,
                             .integrated_over = ""};
  return run;
}

std::vector<std::string> labels_of(const std::vector<std::filesystem::path>& directories) {
  std::vector<std::string> labels;
  for (const LabelledRun& run : labelled_by_directory(directories)) labels.push_back(run.label);
  return labels;
}

TEST(Overlay, OnePicturePerProbeWithACurvePerRun) {
  const auto all = overlaid({run_with({"p", "q"}), run_with({"q", "r"})}, {"one", "two"}, "fits", {});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].name, "history_p");
  EXPECT_EQ(all[0].curves.title, "fits: p");
  EXPECT_EQ(all[0].curves.y.label, "contact pressure (MPa)");
  EXPECT_EQ(all[0].curves.x.label, "time (h)");
  EXPECT_FALSE(all[0].curves.x.logarithmic);
  ASSERT_EQ(all[0].curves.series.size(), 1u);
  ASSERT_EQ(all[1].curves.series.size(), 2u);
  EXPECT_EQ(all[1].curves.series[1].name, "two");
  EXPECT_EQ(all[1].curves.series[1].y, (std::vector<double>{3, 2, 1}));
  EXPECT_EQ(all[2].curves.series.front().name, "two");
}

TEST(Overlay, ChosenProbesInTheirOrder) {
  const std::vector<RunTables> runs{run_with({"p", "q"}), run_with({"p"}, 1e5)};
  const auto all = overlaid(runs, {"one", "two"}, "", {.probes = {"q", "p"}});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "history_q");
  EXPECT_EQ(all[1].curves.title, "p");
  EXPECT_TRUE(all[1].curves.x.logarithmic) << "for the times of all runs together";
  const std::string said = test::message_of<ConfigError>([&] {
    overlaid(runs, {"one", "two"}, "", {.probes = {"pp"}});
  });
  EXPECT_TRUE(test::says(said, {"--probes: ", "'pp'", "p, q"}));
}

TEST(Overlay, DirectoriesAreNamedByWhatTellsThemApart) {
  EXPECT_EQ(labels_of({"results/a", "results/b/"}), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(labels_of({"x/results", "y/results"}), (std::vector<std::string>{"x/results", "y/results"}));
}

}  // namespace
}  // namespace creepcontact::plot
