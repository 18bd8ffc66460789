#include "creepcontact/plot/figure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/plot/curves.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::plot {
namespace {

using io::test::contains;

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
  const io::test::TemporaryDirectory directory;
  draw(one_curve("it''s_<b> & `touch a` \\\nsystem('touch b')\n!touch c"), directory.path(), "plot");
  EXPECT_TRUE(contains(io::test::read_text(directory / "plot.svg"), "it'\u2019s_&lt;b> &amp; `touch a`"));
  for (const char* name : {"a", "b", "c"}) EXPECT_FALSE(std::filesystem::exists(directory / name)) << name;
  EXPECT_EQ(io::test::read_text(directory / "plot.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
}

/// Wherever they are: in a picture's title, at its axes, in its legend.
TEST(Plot, CharactersOfAnyKindAreDrawn) {
  const io::test::TemporaryDirectory directory;
  for (const std::string text :
       {"'a",  "'",   "''",  "'''a'''", "a'",   "a''b'", "\n'a", "`a`", "%d %s %%", "{a",  "a}",    "a@b", "a^{b",
        "a_b", "\"a", "a\"", "$a",      "$(a)", "a\\",   "\\",   "#a",  "a;b",      "&<>", "\xff'", ""}) {
    Figure figure = one_curve(text);
    figure.title = text + "2";
    figure.x.label = text + "3";
    figure.panels[0].y.label = text + "4";
    EXPECT_NO_THROW(draw(figure, directory.path(), "plot")) << text;
    const std::string picture = io::test::read_text(directory / "plot.svg");
    for (const char* mark : {"2<", "3<", "4<"}) EXPECT_TRUE(contains(picture, mark)) << text << mark;
  }
}

TEST(Plot, MarksAreLinesWithNamesWithinTheAxis) {
  Figure figure = one_curve("a");
  figure.x.logarithmic = figure.x.zero_at_left = true;
  figure.marks = {{0, "start"}, {5, "it's"}, {500, "late"}};
  const std::string script = gnuplot_script(figure, "plot");
  EXPECT_TRUE(contains(script, "set arrow 11 from first 5, graph 0 to first 5, graph 1 nohead")) << script;
  EXPECT_TRUE(contains(script, "set label 11 'it''s' noenhanced at first 5,"));
  EXPECT_TRUE(contains(script, "set label 10 'start'"));  // at the left end of the axis
  EXPECT_FALSE(contains(script, "late"));
  const io::test::TemporaryDirectory directory;
  draw(figure, directory.path(), "plot");
  EXPECT_TRUE(contains(io::test::read_text(directory / "plot.svg"), ">start<"));
}

TEST(Plot, EverySeriesHasALookOfItsOwn) {
  Figure figure = one_curve("a");
  for (std::size_t k = 1; k < max_series; ++k) figure.panels[0].series.push_back(figure.panels[0].series[0]);
  const std::string script = gnuplot_script(figure, "plot");
  std::set<std::string> looks, markers;
  const std::regex of_series(R"(dashtype (\d) linecolor rgb '(#\w+)' pointtype (\d+))");
  for (std::sregex_iterator one(script.begin(), script.end(), of_series), end; one != end; ++one) {
    looks.insert((*one)[1].str() + (*one)[2].str());
    markers.insert((*one)[3]);
  }
  EXPECT_EQ(looks.size(), max_series);
  EXPECT_EQ(markers.size(), max_series);
  figure.panels[0].series.push_back(figure.panels[0].series[0]);
  EXPECT_TRUE(contains(io::test::message_of<ConfigError>([&] { gnuplot_script(figure, "plot"); }), "allowed: 1 to 14"));
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

TEST(Plot, NumbersBeyondAllDecadesAreLeftOut) {
  Figure figure = one_curve("a");
  figure.x.logarithmic = true;
  figure.panels[0].series[0].x = {5e-324, 1e-323, 1.5e-323};
  EXPECT_TRUE(contains(gnuplot_script(figure, "plot"), "set xrange [0.1:1]"));
  figure.x.zero_at_left = true;
  figure.panels[0].series[0] = {"a", {0, 1e-250, 1e250, 1.7e308}, {-1e250, 1e250, 1.7e308, -1.7e308}};
  const std::string script = gnuplot_script(figure, "plot");
  EXPECT_FALSE(contains(script, "inf")) << script;
  EXPECT_FALSE(contains(script, "range [0:")) << script;
}

TEST(Plot, AFigureWithoutAPointIsDrawnAllTheSame) {
  const io::test::TemporaryDirectory directory;
  Figure figure = one_curve("nothing");
  figure.panels[0].series[0].y = {NAN, INFINITY, NAN};
  draw(figure, directory.path(), "plot");
  EXPECT_TRUE(contains(io::test::read_text(directory / "plot.svg"), "nothing"));
}

TEST(Plot, PartsAreEven) {
  EXPECT_EQ(even_parts(8, 7), (std::vector<std::size_t>{4, 4}));
  EXPECT_EQ(even_parts(7, 7), (std::vector<std::size_t>{7}));
  EXPECT_TRUE(even_parts(0, 7).empty());
}

TEST(Curves, PointsInOrderThatTheAxesCanShow) {
  const io::test::TemporaryDirectory directory;
  const Axis log{.label = "error", .logarithmic = true};
  const Curves curves{"Errors", log, log, {{"method", {10, 1, 0.1, 5}, {1e-2, 1e-3, 0, NAN}}, {"exact", {1}, {0}}}};
  const auto pictures = draw_curves(curves, directory.path(), "error");
  EXPECT_EQ(pictures, (std::vector<std::filesystem::path>{directory / "error.svg"}));
  EXPECT_TRUE(contains(io::test::read_text(directory / "error.dat"), "1 0.001\n10 0.01\n# end"));
  const std::string picture = io::test::read_text(pictures[0]);
  EXPECT_TRUE(contains(picture, "method"));
  EXPECT_FALSE(contains(picture, "exact"));
}

TEST(Curves, ManyAreSpreadOverPictures) {
  const io::test::TemporaryDirectory directory;
  Curves curves{"Errors", {}, {}, {}};
  for (std::size_t i = 0; i <= max_series; ++i) curves.series.push_back({std::to_string(i), {0, 1}, {1, 2}});
  EXPECT_EQ(draw_curves(curves, directory.path(), "p").size(), 2u);
  EXPECT_TRUE(std::filesystem::exists(directory / "p_2.png"));
  curves.series.clear();
  EXPECT_TRUE(draw_curves(curves, directory.path(), "none").empty());
}

}  // namespace
}  // namespace creepcontact::plot
