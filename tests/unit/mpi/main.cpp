/// Tests on several processes: all of them run every test, and one that fails anywhere fails.

#include <gtest/gtest.h>

#include "creepcontact/mpi/mpi_team.hpp"

int main(int argc, char** argv) {
  const creepcontact::mpi::Library library(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  const int own = RUN_ALL_TESTS();
  return static_cast<int>(creepcontact::mpi::MpiTeam().max(own));
}
