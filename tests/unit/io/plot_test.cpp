#include "creepcontact/io/plot.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/io/error_plots.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

using test::contains;

Figure one_curve(const std::string& name) {
  Figure figure{"title", {"time"}, {}};
  figure.panels.push_back({{"value"}, {{name, {0, 1, 10}, {1, 2, 4}}}});
  return figure;
}

TEST(Plot, NamesAreTextToGnuplotAndNothingElse) {
  const std::string script = gnuplot_script(one_curve("it's `rm -r x`\n\"$(y)\" a_b @c \xff"), "plot");
  EXPECT_TRUE(contains(script, "title 'it''s `rm -r x` \"$(y)\" a_b @c ?'\n")) << script;
  EXPECT_TRUE(contains(script, "noenhanced"));
}

TEST(Plot, HostileNamesRunNothingAndStandInThePicture) {
  const test::TemporaryDirectory directory;
  draw(one_curve("it's_<b> & `touch a` \\\nsystem('touch b')\n!touch c"), directory.path(), "plot");
  EXPECT_TRUE(contains(test::read_text(directory / "plot.svg"), "it's_&lt;b> &amp; `touch a`"));
  for (const char* name : {"a", "b", "c"}) EXPECT_FALSE(std::filesystem::exists(directory / name)) << name;
  EXPECT_EQ(test::read_text(directory / "plot.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
}

TEST(Plot, EverySeriesHasColourAndMarkerOfItsOwn) {
  Figure figure = one_curve("a");
  for (std::size_t k = 1; k < max_series; ++k) figure.panels[0].series.push_back(figure.panels[0].series[0]);
  const std::string script = gnuplot_script(figure, "plot");
  for (const char* look :
       {"'#0072B2' pointtype 7", "'#D55E00' pointtype 5", "'#009E73' pointtype 9", "'#CC79A7' pointtype 11",
        "'#E69F00' pointtype 13", "'#56B4E9' pointtype 6", "'#000000' pointtype 4"})
    EXPECT_TRUE(contains(script, look)) << look;
  figure.panels[0].series.push_back(figure.panels[0].series[0]);
  EXPECT_TRUE(contains(test::message_of<ConfigError>([&] { gnuplot_script(figure, "plot"); }), "allowed: 1 to 7"));
}

TEST(Plot, RoundingIsNotMagnified) {
  Figure figure = one_curve("force");
  figure.panels[0].series[0].y = {-100, -100 - 1e-12, -100 + 1e-12};
  EXPECT_TRUE(contains(gnuplot_script(figure, "plot"), "set yrange [-110:-90]"));
}

TEST(Plot, ZeroStandsLeftOfALogarithmicTime) {
  Figure figure = one_curve("a");
  figure.x.logarithmic = figure.x.zero_at_left = true;
  EXPECT_TRUE(contains(gnuplot_script(figure, "plot"), "set xtics add ('0' zero)"));
  figure.x.zero_at_left = false;
  EXPECT_FALSE(contains(gnuplot_script(figure, "plot"), "zero"));
}

TEST(Plot, AFigureWithoutAPointIsDrawnAllTheSame) {
  const test::TemporaryDirectory directory;
  Figure figure = one_curve("nothing");
  figure.panels[0].series[0].y = {NAN, INFINITY, NAN};
  draw(figure, directory.path(), "plot");
  EXPECT_TRUE(contains(test::read_text(directory / "plot.svg"), "nothing"));
}

TEST(Plot, PartsAreEven) {
  EXPECT_EQ(even_parts(8, 7), (std::vector<std::size_t>{4, 4}));
  EXPECT_EQ(even_parts(7, 7), (std::vector<std::size_t>{7}));
  EXPECT_TRUE(even_parts(0, 7).empty());
}

TEST(ErrorPlots, OnePictureASettingAndOneOfEachCost) {
  const test::TemporaryDirectory directory;
  const std::vector<MethodErrors> methods{{"explicit_euler", "time.step", {1, 0.1}, {10, 100}, {1, 9}, {1e-2, 1e-3}},
                                          {"cvode_bdf", "time.tolerance", {1e-2, 1e-4}, {20, 60}, {2, 4}, {1e-3, 1e-5}},
                                          {"the reference itself", "time.tolerance", {1e-8}, {900}, {50}, {0}}};
  const auto pictures = plot_errors(directory.path(), "Errors", "error, relative", methods);
  std::vector<std::string> names;
  for (const auto& picture : pictures) names.push_back(picture.filename().string());
  EXPECT_EQ(names, (std::vector<std::string>{"error_over_time_step.svg", "error_over_time_tolerance.svg",
                                             "error_over_solves.svg", "error_over_seconds.svg"}));
  const std::string solves = test::read_text(pictures[2]);
  EXPECT_TRUE(contains(solves, "explicit_euler") && contains(solves, "cvode_bdf"));
  EXPECT_FALSE(contains(solves, "the reference"));  // an error of zero has no logarithm
  for (const char* name : {"error_over_solves.gp", "error_over_time_tolerance.gp"})
    EXPECT_TRUE(contains(test::read_text(directory / name), "rgb '#D55E00' pointtype 5")) << name;
  EXPECT_FALSE(contains(test::read_text(directory / "error_over_time_tolerance.gp"), "#0072B2"));
  EXPECT_TRUE(contains(test::read_text(directory / "error_over_solves.dat"), "10 0.01\n100 0.001\n"));
}

TEST(ErrorPlots, ListsOfDifferentLengthAreAnError) {
  const std::string message = test::message_of<ConfigError>([] {
    plot_errors("unused", "", "", {{"rkc2", "time.step", {1}, {1}, {1, 2}, {1}}});
  });
  EXPECT_TRUE(contains(message, "'rkc2': 1 errors, 1 settings, 1 numbers of solves and 2 times")) << message;
}

}  // namespace
}  // namespace creepcontact::io
