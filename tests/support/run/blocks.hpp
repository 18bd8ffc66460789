#pragma once
/// Two blocks on top of each other, pressed and held: the model of most tests of this module. Section 2 x 1; the lower
/// one from z = -2 to 0 with E = 100, the upper one from 0 to 1 with E = 200; both creep by the same law. Pushing the
/// top down by 0.025 presses them with 1.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/creep/distribution.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/results/snapshot.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "support/says.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::run::test {

using namespace creep;    // NOLINT(google-build-using-namespace): tests of all modules of a run
using namespace model;    // NOLINT(google-build-using-namespace)
using namespace results;  // NOLINT(google-build-using-namespace)
using creepcontact::test::message_of;
using creepcontact::test::says;
using io::test::contains;
using io::test::read_text;

/// Groups: volumes "lower", "upper"; surfaces "bottom", "top", "symmetry_x|y" (x = 0, y = 0), "side_x|y" (opposite),
/// "lower_top", "upper_bottom" (z = 0); curve "top_edge" (y = 0, z = 1); point "corner" (2, 1, 1).
inline const std::string groups = R"(
Physical Volume("lower") = {1};
Physical Volume("upper") = {2};
Physical Surface("bottom") = Surface In BoundingBox{-e, -e, -2 - e, 9, 9, -2 + e};
Physical Surface("top") = Surface In BoundingBox{-e, -e, 1 - e, 9, 9, 1 + e};
Physical Surface("symmetry_x") = Surface In BoundingBox{-e, -e, -9, e, 9, 9};
Physical Surface("symmetry_y") = Surface In BoundingBox{-e, -e, -9, 9, e, 9};
Physical Surface("side_x") = Surface In BoundingBox{2 - e, -e, -9, 2 + e, 9, 9};
Physical Surface("side_y") = Surface In BoundingBox{-e, 1 - e, -9, 9, 1 + e, 9};
Physical Curve("top_edge") = Curve In BoundingBox{-e, -e, 1 - e, 9, e, 1 + e};
Physical Point("corner") = Point In BoundingBox{2 - e, 1 - e, 1 - e, 9, 9, 9};
)";

/// Hexahedra, 3 x 2 x 2 in the lower block and 4 x 2 x 2 in the upper one: the meshes of the joint do not match.
std::string separate_blocks();

/// The blocks share the nodes of the joint, one surface that two groups name.
std::string joined_blocks();

inline const std::string case_text = R"(title = "blocks"
units = "none"
[mesh]
file = "blocks.geo"
order = 1
[bodies.lower]
region = "lower"
material = "soft"
[bodies.upper]
region = "upper"
material = "hard"
[materials.soft]
young_modulus = 100
poisson_ratio = 0.3
creep = [{ law = "norton", A = 1e-3, n = 4 }]
[materials.hard]
young_modulus = 200
poisson_ratio = 0.3
creep = [{ law = "norton", A = 1e-3, n = 4 }]
[[supports]]
on = "symmetry_x"
displacement = { x = 0 }
[[supports]]
on = "symmetry_y"
displacement = { y = 0 }
[[supports]]
on = "bottom"
displacement = { z = 0 }
[[supports]]
on = "top"
displacement = { z = -0.025 }
[[contacts]]
between = ["lower_top", "upper_bottom"]
gap = 0
slave = "lower_top"
[time]
end = 4
[output]
directory = "results"
)";

/// A directory with the mesh of the case, and configurations for it.
class Case {
 public:
  explicit Case(const std::string& geometry = separate_blocks());

  /// @param more  tables to be appended to case_text
  config::Config config(const std::string& more = "", const std::vector<std::string>& overrides = {}) const;
  config::Config parse(const std::string& text, const std::vector<std::string>& overrides = {}) const;
  std::filesystem::path operator/(const std::string& name) const { return directory_ / name; }
  /// Begin of a message about what stands at the first occurrence of `text` in case_text + more.
  std::string position(const std::string& text, const std::string& more = "") const;

 private:
  io::test::TemporaryDirectory directory_;
};

/// A model with all that evaluates it.
struct System {
  explicit System(const config::Config& config);
  /// Of the last evaluation of the rate.
  const creep::Equilibrium& equilibrium() const { return rate.step_evaluation().equilibrium; }

  Stopwatch watch;
  Model model;
  creep::Distribution distribution{model.assembly};
  creep::EquilibriumSolver solver;
  creep::CreepSystem rate;
};

}  // namespace creepcontact::run::test
