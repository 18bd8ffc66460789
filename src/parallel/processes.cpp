#include "creepcontact/cli/processes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <iostream>
#include <optional>
#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/mpi/mpi_team.hpp"
#include "creepcontact/mpi/multigrid_stiffness.hpp"
#include "creepcontact/mpi/mumps_cholesky.hpp"
#include "creepcontact/mpi/partition.hpp"
#include "creepcontact/mpi/work_counters.hpp"

namespace creepcontact::cli {
namespace {

const mpi::MpiTeam* all = nullptr;  // while the object lives

/// For processes that have failed: others may need as long to come to an end.
constexpr std::chrono::seconds longest_wait{10};

}  // namespace

struct Processes::Impl {
  Impl(int& argc, char**& argv) : library(argc, argv) {}
  mpi::Library library;
  mpi::MpiTeam team;
};

Processes::Processes(int& argc, char**& argv) : impl_(std::make_unique<Impl>(argc, argv)) {
  all = &impl_->team;
  if (is_first()) return;
  log::set_level(log::Level::off);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);  // one process says that it ends
}

Processes::~Processes() {
  all = nullptr;
}

const char* Processes::program() {
  return "creepcontact-mpi";
}

bool Processes::is_first() {
  return all == nullptr || all->rank() == 0;
}

run::Processes Processes::of_run() {
  return {.team = all,
          .on_this_machine = all->size_on_machine(),
          .stiffness_solver = mpi::mumps_cholesky,
          .multigrid = mpi::multigrid_stiffness,
          .partition =
              [](const std::vector<mechanics::Body>& bodies) {
                std::vector<const mesh::Mesh*> meshes;
                meshes.reserve(bodies.size());
                for (const mechanics::Body& body : bodies) meshes.push_back(&body.mesh());
                return mpi::partition(meshes, *all);
              },
          .work =
              [] {
                const mpi::WorkCounters of = mpi::work_counters();
                constexpr double mega = 1e6, giga = 1e9;
                return std::vector<std::pair<std::string, double>>{
                    {"factors [MB]", of.factor_bytes / mega},
                    {"factorisations [Gflop]", of.factorization_flops / giga},
                    {"messages", static_cast<double>(of.messages)},
                    {"  their content [MB]", of.bytes / mega},
                    {"collective operations", static_cast<double>(of.collectives)},
                    {"  own contributions [MB]", of.collective_bytes / mega}};
              }};
}

run::Processes Processes::of_one() {
  return all->size() == 1 ? of_run() : run::Processes{};
}

bool Processes::share(const std::string& command) {
  if (command == "study")
    throw ConfigError(
        "creepcontact-mpi makes no studies, whose runs are processes of their own; use creepcontact study");
  return command == "run" || command == "heat";
}

int Processes::threads(int cores) {
  return std::max(1, cores / all->size_on_machine());
}

Ending Processes::end(const Ending& own) {
  const mpi::MpiTeam& team = impl_->team;
  if (!mpi::all_arrive(own.status != 0 ? std::optional(longest_wait) : std::nullopt)) {
    // Others wait in an operation that this process will never join.
    std::cerr << fmt::format("error: process {}: {}\n", team.rank(), own.message) << std::flush;
    mpi::abort_all(own.status);
  }
  std::signal(SIGTERM, SIG_IGN);  // which mpirun sends to those that end a moment later than the first
  const int of = team.rank_of_max(own.status + (own.message.empty() ? 0 : 0.5));
  Ending result = own;
  std::array<double, 1> status{static_cast<double>(own.status)};
  team.broadcast(status, of);
  result.status = static_cast<int>(status[0]);
  broadcast(team, result.message, of);
  return result;
}

}  // namespace creepcontact::cli
