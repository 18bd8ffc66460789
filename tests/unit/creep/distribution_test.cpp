/// A model whose elements are spread over threads that stand for processes.

#include "creepcontact/creep/distribution.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "creepcontact/base/error.hpp"
#include "support/run/blocks.hpp"
#include "unit/base/thread_team.hpp"

namespace creepcontact::run::test {
namespace {

/// Elements by turns; member 1 gets none.
creep::RankOfElement deal(const creep::Assembly& whole) {
  creep::RankOfElement ranks;
  for (const mechanics::Body& body : whole.bodies()) {
    std::vector<std::int32_t>& of_body = ranks.emplace_back();
    for (std::size_t e = 0; e < body.discretization().n_elements(); ++e) of_body.push_back(e % 2 == 0 ? 0 : 2);
  }
  return ranks;
}

TEST(Distribution, GathersWhatItDealsOut) {
  const Case blocks;
  const Model model = build_model(blocks.config("", {}));
  const std::size_t size = creep::StateLayout(model.assembly).size();
  std::vector<double> two_states(2 * size);
  std::iota(two_states.begin(), two_states.end(), 0.0);
  std::vector<std::vector<double>> gathered(3);
  std::vector<std::size_t> own_sizes(3), n_elements(3, 0);
  on_team(3, [&](const Team& team) {
    const creep::Distribution distribution(model.assembly, team, deal(model.assembly));
    for (const mechanics::Body& body : distribution.own().bodies())
      n_elements[team.rank()] += body.discretization().n_elements();
    const std::vector<double> own = distribution.own_states(two_states);
    own_sizes[team.rank()] = own.size();
    EXPECT_EQ(own.size(), 2 * creep::StateLayout(distribution.own()).size());
    gathered[team.rank()] = distribution.gather_states(own);
    EXPECT_TRUE(distribution.own_states({}).empty()) << "of a model without creep";
  });
  EXPECT_EQ(gathered[0], two_states);
  EXPECT_TRUE(gathered[1].empty() && gathered[2].empty());
  EXPECT_EQ(n_elements[1], 0u);
  EXPECT_GT(n_elements[0], 0u);
  EXPECT_EQ(own_sizes[0] + own_sizes[2], two_states.size());
}

TEST(Distribution, OfOneIsTheWhole) {
  const Case blocks;
  const Model model = build_model(blocks.config("", {}));
  const creep::Distribution distribution(model.assembly);
  EXPECT_EQ(&distribution.own(), &model.assembly);
  EXPECT_TRUE(distribution.is_root());
  const std::vector<double> some{1, 2, 3};
  EXPECT_EQ(distribution.gather_states(some), some);
  EXPECT_EQ(distribution.own_states(some), some);
}

/// Forces at a node are those of one member only: the resultants of the parts add up to that of the whole.
TEST(Distribution, CountsLoadsOnce) {
  const Case blocks;
  const Model model = build_model(blocks.config("", {}));
  std::vector<std::vector<double>> forces(3);
  on_team(3, [&](const Team& team) {
    const creep::Distribution distribution(model.assembly, team, deal(model.assembly));
    for (const mechanics::Body& body : distribution.own().bodies()) {
      const mechanics::BodyConditions at = body.at(0.5);
      const auto external = at.external_forces();
      forces[team.rank()].insert(forces[team.rank()].end(), external.begin(), external.end());
    }
  });
  std::size_t first = 0;
  for (const mechanics::Body& body : model.assembly.bodies()) {
    const mechanics::BodyConditions at = body.at(0.5);
    for (const double force : at.external_forces()) {
      EXPECT_NEAR(forces[0].at(first) + forces[1].at(first) + forces[2].at(first), force, 1e-12 * std::abs(force));
      ++first;
    }
  }
}

}  // namespace
}  // namespace creepcontact::run::test
