#include "creepcontact/plot/solid_picture.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace creepcontact::plot {
namespace {

using Json = nlohmann::json;

/// A square and an edge of each of two bodies; the square of the second one is marked.
SolidPicture two_plates() {
  SolidPicture picture{.title = "it's", .flat = true, .length_unit = "mm", .bodies = {"left", "right"}};
  picture.marks = {{"fixed", SolidMark::Kind::support}, {"pushed", SolidMark::Kind::load}};
  for (const int body : {0, 1}) {
    const double x = 3.0 * body;
    picture.facets.push_back({{{x, 0, 0}, {x + 2, 0, 0}, {x + 2, 1, 0}, {x, 1, 0}}, body, body == 1 ? 1 : -1});
    picture.lines.push_back({{{x, 0, 0}, {x, 1, 0}}, body, 0});
  }
  return picture;
}

Json job_of(const SolidPicture& picture) {
  return Json::parse(picture_job(picture, "/place/model.png")).at(0);
}

TEST(SolidPicture, CellsReferToTheirPointsBodiesAndMarks) {
  const Json job = job_of(two_plates());
  EXPECT_EQ(job["output"], "/place/model.png");
  EXPECT_EQ(job["title"], "it's");
  ASSERT_EQ(job["facets"].size(), 2U);
  const Json& facet = job["facets"][1];
  EXPECT_EQ(facet[0], 1);
  EXPECT_EQ(facet[1], 1);
  ASSERT_EQ(facet.size(), 6U);
  EXPECT_EQ(job["points"].at(facet[4].get<std::size_t>()), Json({5.0, 1.0, 0.0}));
  ASSERT_EQ(job["lines"].size(), 2U);
  EXPECT_EQ(job["lines"][0].size(), 4U);
  EXPECT_EQ(job["points"].at(job["lines"][1][3].get<std::size_t>()), Json({3.0, 1.0, 0.0}));
  EXPECT_EQ(job["ticks"][0], Json({0.0, 1.0, 2.0, 3.0, 4.0, 5.0}));
}

TEST(SolidPicture, SupportsAreBlueLoadsRedAndFurtherOnesDiffer) {
  SolidPicture picture = two_plates();
  picture.marks.push_back({"pulled", SolidMark::Kind::load});
  const Json marks = job_of(picture)["marks"];
  const auto colour = [&](int mark) { return marks.at(mark).at(1).get<std::vector<double>>(); };
  EXPECT_GT(colour(0)[2], 1.5 * colour(0)[0]);
  EXPECT_GT(colour(1)[0], 1.5 * colour(1)[2]);
  EXPECT_NE(colour(1), colour(2));
}

TEST(SolidPicture, TheSecondSurfaceOfAContactIsDrawnWithinTheFirst) {
  SolidPicture picture;
  picture.marks = {{"slave", SolidMark::Kind::contact}, {"master", SolidMark::Kind::contact}};
  const Json job = job_of(picture);
  EXPECT_GT(job["marks"][0][2], job["marks"][1][2]);
}

TEST(SolidPicture, LongNamesAndBytesThatAreNoTextDoNotStopIt) {
  SolidPicture picture = two_plates();
  picture.title = std::string(500, 'x');
  picture.bodies[0] = "\xff";
  EXPECT_LT(job_of(picture)["title"].get<std::string>().size(), 100U);
}

}  // namespace
}  // namespace creepcontact::plot
