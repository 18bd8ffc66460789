#include "creepcontact/cli/processes.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "creepcontact/base/error.hpp"

namespace creepcontact::cli {
namespace {

int number_in(const char* variable) {
  const char* const text = std::getenv(variable);
  return text != nullptr ? std::atoi(text) : 0;
}

struct Launcher {
  const char *size, *rank;  // environment variables
};
/// Variables of Open MPI; of MPICH, Intel MPI and Slurm's PMI.
constexpr Launcher launchers[] = {{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"}, {"PMI_SIZE", "PMI_RANK"}};

}  // namespace

struct Processes::Impl {};

Processes::Processes(int& /*argc*/, char**& /*argv*/) {}
Processes::~Processes() = default;

const char* Processes::program() {
  return "creepcontact";
}

bool Processes::is_first() {
  for (const Launcher& launcher : launchers)
    if (number_in(launcher.rank) > 0) return false;
  return true;
}

run::Processes Processes::of_run() {
  return {};
}

run::Processes Processes::of_one() {
  return of_run();
}

bool Processes::share(const std::string& /*command*/) {
  for (const Launcher& launcher : launchers)
    if (const int n = number_in(launcher.size); n > 1)
      throw ConfigError(
          fmt::format("mpirun has started {} processes of creepcontact, which would all do the same work; start "
                      "creepcontact-mpi with mpirun, or creepcontact without it",
                      n));
  return true;
}

int Processes::threads(int cores) {
  return cores;
}

Ending Processes::end(const Ending& own) {
  return own;
}

}  // namespace creepcontact::cli
