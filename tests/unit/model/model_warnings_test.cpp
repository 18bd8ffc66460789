/// Remarks on what is allowed and seldom meant.

#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/model/model.hpp"
#include "support/run/blocks.hpp"

namespace creepcontact::model::test {
namespace {

using creepcontact::test::says;
using run::test::Case;

std::vector<std::string> remarks(const Case& model, const std::vector<std::string>& overrides) {
  const config::Config config = model.config("", overrides);
  return model_warnings(config, build_model(config));
}

std::string only(const std::vector<std::string>& found) {
  EXPECT_EQ(found.size(), 1U);
  return found.empty() ? "" : found.front();
}

TEST(ModelWarnings, NoneOfTheUsualModel) {
  EXPECT_TRUE(remarks(Case(), {}).empty());
}

TEST(ModelWarnings, ModuliInUnlikeUnits) {
  const Case blocks;
  const auto of = [&](double soft, double hard) {
    return remarks(blocks, {fmt::format("materials.soft.young_modulus={}", soft),
                            fmt::format("materials.hard.young_modulus={}", hard)});
  };
  EXPECT_TRUE(says(only(of(210, 2.1e5)), {"'lower'", "'soft'", "210", "'upper'", "'hard'", "210000", "GPa and MPa"}));
  EXPECT_TRUE(says(only(of(2.1e11, 1.9e5)), {" MPa and Pa"}));
  EXPECT_TRUE(says(only(of(70, 2e11)), {"GPa and Pa"}));
  // steel beside aluminium, polymer, rubber, a stiff tool; in MPa and in Pa
  for (const auto& [soft, hard] :
       {std::pair(7e4, 2.1e5), {500.0, 2.1e5}, {5.0, 2.1e5}, {2.1e5, 2.1e8}, {5e8, 2.1e11}, {1.0, 1000.0}})
    EXPECT_TRUE(of(soft, hard).empty()) << soft << " " << hard;
}

TEST(ModelWarnings, FrictionThatIsNoRatio) {
  const Case blocks;
  EXPECT_TRUE(remarks(blocks, {"contacts.0.friction=1.4"}).empty());
  EXPECT_TRUE(
      says(only(remarks(blocks, {"contacts.0.friction=15"})), {"'lower_top-upper_bottom'", "friction", " 15;"}));
  EXPECT_TRUE(says(only(remarks(blocks, {"contacts.0.friction=0.2 + 2*t/4"})), {"friction", " 2.2;"}));
}

/// A punch of `n` elements across, on a block that goes on beyond it on the sides that the punch does not share.
std::string punch(int n, bool to_the_edges) {
  return fmt::format(R"(SetFactory("OpenCASCADE");
e = 1e-3;
Box(1) = {{0, 0, -2, 2, 1, 2}};
Box(2) = {{{}, 0, 0, {}, 1, 1}};
Transfinite Curve{{1:24}} = 3;
Transfinite Curve{{9:12}} = 13;
Transfinite Curve{{21:24}} = {};
Transfinite Surface{{1:12}};
Recombine Surface{{1:12}};
Transfinite Volume{{1:2}};
Physical Surface("lower_top") = {{6}};
Physical Surface("upper_bottom") = {{11}};
)",
                     to_the_edges ? 0.0 : 0.5, to_the_edges ? 2.0 : 1.0, n + 1) +
         run::test::groups;
}

TEST(ModelWarnings, SurfacesOfFewElements) {
  const auto of = [](int n, bool to_the_edges, const char* slave) {
    const Case model(punch(n, to_the_edges));
    return remarks(model, {std::string("contacts.0.slave='") + slave + "'"});
  };
  for (const char* slave : {"upper_bottom", "lower_top"}) {
    EXPECT_TRUE(says(only(of(1, false, slave)), {"'upper_bottom'", "one element", "'lower_top'"}));
    EXPECT_TRUE(says(only(of(3, false, slave)), {"'upper_bottom'", "three elements", "'lower_top'"}));
    EXPECT_TRUE(of(4, false, slave).empty());
    EXPECT_TRUE(of(1, true, slave).empty()) << "both surfaces end there";
  }
}

/// A quarter of a disc, and a ring around it that covers `part` of the circle.
std::string sectors(const std::string& part) {
  return "SetFactory(\"OpenCASCADE\");\npart = " + part + R"(;
e = 1e-3;
Cylinder(1) = {0, 0, 0, 0, 0, 5, 20, Pi/2};
Cylinder(2) = {0, 0, 0, 0, 0, 5, 10, Pi/2};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {0, 0, 0, 0, 0, 5, 25, part};
Cylinder(5) = {0, 0, 0, 0, 0, 5, 21, part};
BooleanDifference(6) = { Volume{4}; Delete; }{ Volume{5}; Delete; };
MeshSize{:} = 6;
Physical Volume("disc") = {3};
Physical Volume("ring") = {6};
Physical Surface("disc_low") = Surface In BoundingBox{9, -e, -e, 20 + e, e, 5 + e};
Physical Surface("disc_high") = Surface In BoundingBox{-e, 9, -e, e, 20 + e, 5 + e};
Physical Surface("ring_low") = Surface In BoundingBox{20, -e, -e, 26, e, 5 + e};
Physical Surface("ring_high") = Surface In BoundingBox{-e, 20, -e, e, 26, 5 + e};
)";
}

TEST(ModelWarnings, ABodyWithoutTheSymmetryOfAnother) {
  const auto of = [](const std::string& part, bool joined) {
    const Case model(sectors(part));
    std::string text = R"([mesh]
file = "blocks.geo"
[bodies.disc]
region = "disc"
material = "steel"
[bodies.ring]
region = "ring"
material = "steel"
[materials.steel]
young_modulus = 2e5
poisson_ratio = 0.3
[time]
end = 1
[[cyclic]]
between = ["disc_low", "disc_high"]
angle = 90
)";
    if (joined) text += "[[cyclic]]\nbetween = [\"ring_low\", \"ring_high\"]\nangle = 90\n";
    const config::Config config = model.parse(text);
    return model_warnings(config, build_model(config));
  };
  EXPECT_TRUE(says(only(of("Pi/2", false)), {"body 'ring'", "90 degrees", "[[cyclic]]"}));
  EXPECT_TRUE(says(only(of("2*Pi/3", false)), {"body 'ring'", "120 degrees", "[[cyclic]]"}));
  EXPECT_TRUE(of("Pi/2", true).empty());
  EXPECT_TRUE(of("Pi/3", false).empty()) << "a part within the sector";
}

}  // namespace
}  // namespace creepcontact::model::test
