#include "creepcontact/mpi/partition.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "creepcontact/mpi/mpi_team.hpp"

namespace creepcontact::mpi {
namespace {

/// nx x ny x nz cubes.
mesh::Mesh box(int nx, int ny, int nz) {
  mesh::Mesh result;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) result.nodes.emplace_back(i, j, k);
  mesh::CellBlock& cells =
      result.blocks.emplace_back(mesh::CellBlock{.type = mesh::CellType::hex8, .connectivity = {}});
  const auto node = [&](int i, int j, int k) { return static_cast<std::int64_t>(i + (nx + 1) * (j + (ny + 1) * k)); };
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        for (const int level : {k, k + 1})
          for (const auto& [x, y] :
               {std::pair(i, j), std::pair(i + 1, j), std::pair(i + 1, j + 1), std::pair(i, j + 1)})
            cells.connectivity.push_back(node(x, y, level));
  return result;
}

/// Largest number of elements of one process.
std::ptrdiff_t most(const std::vector<std::int32_t>& ranks, int n) {
  std::ptrdiff_t result = 0;
  for (int rank = 0; rank < n; ++rank) result = std::max(result, std::ranges::count(ranks, rank));
  return result;
}

TEST(Partition, DealsOutLargeBodiesEvenlyAndKeepsSmallOnesWhole) {
  const MpiTeam team;
  const int n = team.size();
  const mesh::Mesh large = box(8, 10, 12), small = box(2, 2, 1), other = box(3, 1, 1);
  const auto ranks = partition({&large, &small, &other}, team);
  ASSERT_EQ(ranks.size(), 3u);
  ASSERT_EQ(ranks[0].size(), 960u);
  EXPECT_LE(static_cast<double>(most(ranks[0], n)), 1.1 * 960 / n + 1);
  EXPECT_EQ(most(ranks[1], n), 4);
  EXPECT_EQ(most(ranks[2], n), 3);
  // All know the same.
  for (const std::vector<std::int32_t>& of_body : ranks) {
    std::vector<double> own(of_body.begin(), of_body.end()), of_root = own;
    team.broadcast(of_root, 0);
    EXPECT_EQ(own, of_root);
  }
}

/// Two processes with equal load take the small bodies in turn.
TEST(Partition, GivesSmallBodiesToThoseWithLeast) {
  const MpiTeam team;
  const mesh::Mesh small = box(2, 1, 1);
  const std::vector<const mesh::Mesh*> bodies(2 * static_cast<std::size_t>(team.size()), &small);
  std::vector<int> n_bodies(team.size(), 0);
  for (const std::vector<std::int32_t>& of_body : partition(bodies, team)) ++n_bodies[of_body.front()];
  for (const int n : n_bodies) EXPECT_EQ(n, 2);
}

}  // namespace
}  // namespace creepcontact::mpi
