#include "creepcontact/mpi/mpi_team.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "creepcontact/base/error.hpp"

namespace creepcontact::mpi {
namespace {

TEST(MpiTeam, ReducesOverAllMembers) {
  const MpiTeam team;
  const int n = team.size();
  const double own = 1.0 + team.rank();
  EXPECT_EQ(team.sum(own), n * (n + 1) / 2.0);
  EXPECT_EQ(team.max(own), n);
  EXPECT_EQ(team.min(own), 1);
  EXPECT_EQ(team.rank_of_max(-own), 0);
  EXPECT_TRUE(team.any(team.rank() == n - 1));
  EXPECT_FALSE(team.any(false));
  EXPECT_EQ(team.size_on_machine(), n);
}

TEST(MpiTeam, GivesAllTheSameBits) {
  const MpiTeam team;
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(std::sin(i + 0.1 * team.rank()) * std::pow(10, i % 17));
  team.sum(values);
  std::vector<double> of_root = values;
  team.broadcast(of_root, 0);
  EXPECT_EQ(values, of_root);
}

TEST(MpiTeam, HandsValuesAround) {
  const MpiTeam team;
  const int last = team.size() - 1;
  std::vector<double> values{1.0 * team.rank(), 2.0};
  team.broadcast(values, last);
  EXPECT_EQ(values, (std::vector<double>{1.0 * last, 2}));
  std::vector<double> expected;
  for (int rank = 0; rank <= last && team.rank() == 0; ++rank) expected.insert(expected.end(), rank, rank);
  EXPECT_EQ(team.gather(std::vector<double>(team.rank(), team.rank())), expected);
  EXPECT_TRUE(team.gather({}).empty());
}

TEST(MpiTeam, AgreesOnAFailureOfEachMember) {
  const MpiTeam team;
  for (int failing = 0; failing < team.size(); ++failing) {
    std::string caught;
    try {
      together(team, [&] {
        if (team.rank() == failing) throw ModelError("of one");
      });
    } catch (const ModelError& error) {
      caught = error.what();
    }
    EXPECT_EQ(caught, "of one") << failing;
  }
}

}  // namespace
}  // namespace creepcontact::mpi
