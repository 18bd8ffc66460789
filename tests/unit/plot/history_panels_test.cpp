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

TEST(HistoryPanels, ProbesWithUnitsOfTheirOwn) {
  const io::CsvTable history{{"time", "force", "kilo", "torque", "sum", "share", "raw"},
                             {{0, 1}, {5, 6}, {5, 6}, {5, 6}, {5, 6}, {5, 6}, {5, 6}}};
  const auto with_unit = [](io::SummaryProbe of, const std::string& unit) {
    of.unit = unit;
    return of;
  };
  const auto expression = [](const std::string& label, const std::string& unit) {
    return io::SummaryProbe{.label = label, .unit = unit, .expression = "2*force"};
  };
  const io::SummaryHeading heading{"",
                                   "mm, N, MPa, h",
                                   "",
                                   {{"force", with_unit(probe("contact_force_x", "surface"), "N")},
                                    {"kilo", with_unit(probe("contact_force_x", "surface"), "kN")},
                                    {"torque", expression("torque", "N mm")},
                                    {"sum", expression("sum", "N")},
                                    {"share", expression("share", "")},
                                    {"raw", with_unit(probe("contact_force_x", "surface"), "")}}};
  EXPECT_EQ(names(history_panels(history, heading)), (Names{{"contact force, sum (N)", "force", "sum"},
                                                            {"contact force (kN)", "kilo"},
                                                            {"torque (N mm)", "torque"},
                                                            {"share", "share"},
                                                            {"contact force", "raw"}}));
}

TEST(HistoryPanels, EventsAreMarksOfAllFigures) {
  RunTables run{"run",
                {{"time", "a"}, {{0, 1, 2}, {1, 2, 3}}},
                {{"time", "step", "order", "elastic_solves", "schwarz_iterations", "active_contacts"},
                 {{1, 2}, {1, 1}, {1, 1}, {1, 1}, {0, 0}, {0, 0}}},
                {"", "", "", {}, {{"leak", 1.5}}}};
  const std::vector<NamedFigure> figures = run_figures(run, {});
  ASSERT_EQ(figures.size(), 2u);
  for (const NamedFigure& one : figures) {
    ASSERT_EQ(one.figure.marks.size(), 1u) << one.name;
    EXPECT_EQ(one.figure.marks[0].x, 1.5);
    EXPECT_EQ(one.figure.marks[0].name, "leak");
  }
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
