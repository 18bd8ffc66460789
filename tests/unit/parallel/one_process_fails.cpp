/// One process fails while the others wait for it in a collective operation: all of them end, with its status.

#include "creepcontact/base/team.hpp"
#include "creepcontact/cli/processes.hpp"

int main(int argc, char** argv) {
  using namespace creepcontact;
  cli::Processes processes(argc, argv);
  const Team& team = *cli::Processes::of_run().team;
  if (team.rank() == team.size() - 1) return processes.end({4, "of one alone"}).status;
  team.sum(1.0);
  return processes.end({}).status;
}
