/// The diagram of creep and fatigue shows where a body is and how far the limit is.

#include "../../../src/report/interaction_diagram.hpp"

#include <gtest/gtest.h>

namespace creepcontact::report {
namespace {

using Values = std::vector<double>;

io::CsvTable cycles(const Values& fatigue, const Values& creep) {
  io::CsvTable table;
  table.names = {"time", "disc.fatigue_fraction", "disc.life_fraction"};
  table.columns = {Values(fatigue.size(), 1.0), fatigue, creep};
  return table;
}

TEST(InteractionDiagram, TheLimitIsInThePicture) {
  const auto figure = interaction_figure(
      {"shaft", "disc"}, cycles({0.001, 0.002}, {0.01, 0.02}),
      {{"materials.P91.fatigue.cycles", "[1]"}, {"materials.P91.fatigue.interaction", "[[0.01, 0.1]]"}});
  ASSERT_TRUE(figure);
  const std::vector<plot::Series>& series = figure->panels[0].series;
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].name, "disc");
  EXPECT_EQ(series[0].x, (Values{0, 0.001, 0.002}));
  EXPECT_EQ(series[0].y, (Values{0, 0.01, 0.02}));
  EXPECT_EQ(series[1].name, "limit of P91");
  // The window ends at 1.5 times the largest share and the inner point: fatigue 0.15, creep 0.03.
  const double into = (1 - 0.03) / 0.99 * 0.1, out = 0.01 * (1 - 0.05 / 0.9);
  const Values x{0.15, 0.1, 0.1, into}, y{out, 0.01, 0.01, 0.03};
  ASSERT_EQ(series[1].x.size(), x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(series[1].x[i], x[i], 1e-12);
    EXPECT_NEAR(series[1].y[i], y[i], 1e-12);
  }
}

TEST(InteractionDiagram, WithoutPointsSharesAddUp) {
  const auto figure = interaction_figure({"disc"}, cycles({0.1}, {0.2}), {{"materials.a.fatigue.cycles", "[1]"}});
  ASSERT_TRUE(figure);
  const plot::Series& limit = figure->panels[0].series.back();
  EXPECT_EQ(limit.x, (Values{1, 0}));
  EXPECT_EQ(limit.y, (Values{0, 1}));
}

TEST(InteractionDiagram, NoneWithoutShares) {
  EXPECT_FALSE(interaction_figure({"other"}, cycles({0.1}, {0.2}), {}));
  // A limit without data of it is not drawn.
  EXPECT_EQ(interaction_figure({"disc"}, cycles({0.1}, {0.2}), {})->panels[0].series.size(), 1U);
}

}  // namespace
}  // namespace creepcontact::report
