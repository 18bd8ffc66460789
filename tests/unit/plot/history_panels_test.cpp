#include <gtest/gtest.h>

#include "creepcontact/plot/run_plots.hpp"
#include "creepcontact/results/quantities.hpp"

namespace creepcontact::plot {
namespace {

std::vector<std::vector<std::string>> names(const std::vector<Panel>& panels) {
  std::vector<std::vector<std::string>> result;
  for (const Panel& panel : panels) {
    result.push_back({panel.y.label});
    for (const Series& series : panel.series) result.back().push_back(series.name);
  }
  return result;
}

io::SummaryProbe probe(const std::string& quantity, const std::string& integrated_over = "") {
  const results::OutputVariable& variable = *results::quantity(quantity).variable;
  return {quantity, variable.label, variable.dimension, integrated_over};
}

using Names = std::vector<std::vector<std::string>>;

TEST(HistoryPanels, OneADimensionWithItsUnit) {
  const io::CsvTable history{{"time", "p", "u", "hoop", "creep", "life"},
                             {{0, 1}, {60, 15}, {0.1, 0.2}, {-100, 80}, {0, 1e-3}, {0, 0.5}}};
  const io::SummaryHeading heading{"",
                                   "mm, N, MPa, h, degC",
                                   "",
                                   {{"p", probe("contact_pressure")},
                                    {"u", probe("displacement_x")},
                                    {"hoop", probe("stress_theta")},
                                    {"creep", probe("creep_strain_equivalent")},
                                    {"life", probe("life_fraction")}}};
  EXPECT_EQ(names(history_panels(history, heading)), (Names{{"stress (MPa)", "p", "hoop"},
                                                            {"displacement (mm)", "u"},
                                                            {"creep strain", "creep"},
                                                            {"life fraction", "life"}}));
}

TEST(HistoryPanels, SumsHaveTheUnitOfTheirIntegral) {
  const io::CsvTable history{{"time", "clamping", "area", "grown"}, {{0, 1}, {1, 2}, {1, 2}, {0, 1}}};
  const io::SummaryHeading heading{"",
                                   "mm, N, MPa, h",
                                   "",
                                   {{"clamping", probe("contact_pressure", "surface")},
                                    {"area", probe("contact_area", "surface")},
                                    {"grown", probe("creep_strain_equivalent", "body")}}};
  EXPECT_EQ(names(history_panels(history, heading)),
            (Names{{"force (N)", "clamping"}, {"contact area (mm²)", "area"}, {"creep strain, sum", "grown"}}));
}

TEST(HistoryPanels, EveryQuantityIsKnown) {
  for (const results::Quantity& info : results::quantities()) {
    const auto panels = history_panels({{"time", "a"}, {{0, 1}, {1, 2}}}, {"", "", "", {{"a", probe(info.name)}}});
    ASSERT_EQ(panels.size(), 1u);
    EXPECT_NE(panels[0].y.label, "value") << info.name;
  }
}

TEST(HistoryPanels, WithoutQuantitiesMagnitudesTell) {
  const io::CsvTable history{{"time", "big", "small", "near", "zero"}, {{0, 1}, {1, 200}, {1, 2}, {50, 60}, {0, 0}}};
  EXPECT_EQ(names(history_panels(history, {})), (Names{{"value", "big", "near"}, {"value", "small", "zero"}}));
}

TEST(HistoryPanels, APanelHoldsNoMoreThanItsColours) {
  io::CsvTable history{{"time"}, {{0, 1}}};
  for (int k = 0; k < 9; ++k) {
    history.names.push_back("p" + std::to_string(k));
    history.columns.push_back({1, 2});
  }
  const auto panels = history_panels(history, {});
  ASSERT_EQ(panels.size(), 2u);
  EXPECT_EQ(panels[0].series.size(), 5u);
  EXPECT_EQ(panels[1].series.front().name, "p5");
}

TEST(HistoryPanels, DecadesOfTime) {
  EXPECT_TRUE(spans_decades({0, 1, 1001}));
  EXPECT_FALSE(spans_decades({0, 1, 1000}));
  EXPECT_FALSE(spans_decades({0}));
}

}  // namespace
}  // namespace creepcontact::plot
