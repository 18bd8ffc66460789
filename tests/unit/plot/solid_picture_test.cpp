#include "creepcontact/plot/solid_picture.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "unit/io/temporary_directory.hpp"

namespace creepcontact::plot {
namespace {

using io::test::contains;

/// The faces of a box from the origin to (1, 1, 1), moved along x, the face z = 1 marked.
void add_box(double x, int body, SolidPicture& picture) {
  const auto corner = [&](int i) { return Vector3(x + (i & 1), (i >> 1) & 1, (i >> 2) & 1); };
  const std::vector<std::array<int, 4>> faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                              {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Facet facet{{}, body, f == 1 ? 0 : -1};
    for (const int i : faces[f]) facet.corners.push_back(corner(i));
    picture.facets.push_back(facet);
  }
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

SolidPicture two_boxes() {
  SolidPicture picture{.title = "boxes", .bodies = {"left", "right"}, .marks = {{"top_face", SolidMark::Kind::load}}};
  add_box(0, 0, picture);
  add_box(1, 1, picture);
  return picture;
}

TEST(SolidPicture, FacesThatLookAwayAreLeftOut) {
  const std::string script = gnuplot_script(two_boxes(), "model");
  // Two views of both boxes and two of each alone, three of the six faces of a box in each.
  EXPECT_EQ(count(script, "set object polygon"), 2u * (6 + 3 + 3));
  EXPECT_EQ(count(script, "title 'top_face'"), 1u);
  EXPECT_EQ(count(script, "title 'left'"), 1u);
}

TEST(SolidPicture, WhatIsNearerIsPaintedLater) {
  SolidPicture picture{.bodies = {"far", "near"}};
  for (const int body : {1, 0})
    picture.facets.push_back({{{0, 2.0 - 2 * body, 0}, {1, 2.0 - 2 * body, 0}, {1, 2.0 - 2 * body, 1}}, body});
  const std::string script = gnuplot_script(picture, "model");
  const std::size_t far = script.find("fillcolor rgb"), near = script.find("fillcolor rgb", far + 1);
  EXPECT_NE(script.substr(far, 24), script.substr(near, 24));
  EXPECT_TRUE(std::regex_search(script.substr(far, 24), std::regex("#[89a-f].[89a-f].[a-f].")))
      << "the bluish first body";
}

TEST(SolidPicture, SectionsHaveAxesAndMarkedLines) {
  const io::test::TemporaryDirectory directory;
  SolidPicture picture{.title = "it's", .flat = true, .length_unit = "mm", .bodies = {"plate"}};
  picture.marks = {{"fixed", SolidMark::Kind::support}, {"point", SolidMark::Kind::load}};
  picture.facets.push_back({{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}});
  picture.lines = {{{{0, 0, 0}, {0, 1, 0}}, 0, 0}, {{{2, 1, 0}}, 0, 1}};
  const std::string script = gnuplot_script(picture, "model");
  EXPECT_TRUE(contains(script, "set xlabel 'x (mm)'")) << script;
  EXPECT_TRUE(contains(script, "$lines0 << EOD\n0 0\n0 1\n") && contains(script, "$points1 << EOD\n2 1\n")) << script;
  draw(picture, directory.path(), "model");
  EXPECT_TRUE(contains(io::test::read_text(directory / "model.svg"), "fixed"));
  EXPECT_EQ(io::test::read_text(directory / "model.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
}

}  // namespace
}  // namespace creepcontact::plot
