#include "memory_need.hpp"

#include <fmt/ranges.h>
#include <omp.h>

#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/creep/state_layout.hpp"
#include "creepcontact/linalg/blas_address_space.hpp"
#include "creepcontact/platform/memory.hpp"
#include "creepcontact/run/threads.hpp"

namespace creepcontact::run {
namespace {

constexpr double state_vectors = 14;      // of CVODE BDF with its Krylov space
constexpr double numbers_at_points = 75;  // gradients, weights, coordinates, stress, moduli
constexpr double numbers_at_nodes = 100;  // vectors of the unknowns, smoothed fields and their text
constexpr double considerable = 0.2;      // part of what is missing
constexpr double small_things = 10e6;     // buffers of files, tables, stacks

std::string threads_text(int threads) {
  return threads == 1 ? "one thread" : fmt::format("{} threads", threads);
}

}  // namespace

MemoryNeed memory_need(const config::Config& config, const creep::Assembly& assembly, double contact_bytes,
                       const std::function<double(std::size_t body)>& of_factor) {
  const bool tangent = config.time.linear_solver == settings::LinearSolver::tangent;
  const creep::StateLayout layout(assembly);
  MemoryNeed need;
  need.contact = (tangent ? 2 : 1) * contact_bytes;
  need.state = 8 * state_vectors * static_cast<double>(layout.size());
  for (std::size_t b = 0; b < assembly.bodies().size(); ++b) {
    const mechanics::Body& body = assembly.bodies()[b];
    const bool has_tangent = tangent && body.material().creeps();
    need.factors += (has_tangent ? 2 : 1) * of_factor(b);
    // What a tangent eliminates at the points.
    const auto stride = static_cast<double>(layout.stride(b));
    const double numbers = numbers_at_points + (has_tangent ? 36 + stride * (stride + 6) : 0);
    need.points += 8 * (numbers * static_cast<double>(body.discretization().n_points()) +
                        numbers_at_nodes * static_cast<double>(body.mesh().nodes.size()));
  }
  // For each value the derivative of the state, and two models.
  need.derivatives = static_cast<double>(config.sensitivity.keys.size()) * (need.state + 2 * need.points);
  return need;
}

int affordable_threads(int wanted) {
  const double half = 0.5 * platform::address_space().bytes;
  int threads = 1;
  while (threads < wanted && linalg::blas_address_space(threads + 1) <= half) ++threads;
  return threads;
}

std::string memory_shortage(const MemoryNeed& of_one, int processes_here) {
  const auto text = [](const MemoryNeed& need, double more, int processes, const std::string& also,
                       const platform::Room& room, int threads) {
    std::vector<std::string> cures;
    if (processes > 1) cures.emplace_back("use fewer processes on this machine, or more machines");
    if (threads > 1) cures.emplace_back("use --threads 1");
    if (need.derivatives > considerable * more) cures.emplace_back("name fewer keys in sensitivity.keys");
    if (need.total() > considerable * more) cures.emplace_back("make the mesh coarser");
    cures.emplace_back("allow the program more memory");
    return fmt::format(
        "the model needs about {} more memory{} (factors {}, contact matrices {}, integration points and nodes {}, "
        "state and integrator {}{}{}), but only {} are left: {}; {}",
        platform::memory_text(more), processes > 1 ? fmt::format(" for {} processes on this machine", processes) : "",
        platform::memory_text(need.factors), platform::memory_text(need.contact), platform::memory_text(need.points),
        platform::memory_text(need.state),
        need.derivatives > 0 ? fmt::format(", derivatives {}", platform::memory_text(need.derivatives)) : "", also,
        platform::memory_text(room.bytes), room.reason, fmt::join(cures, ", or "));
  };
  const MemoryNeed of_all{processes_here * of_one.factors, of_one.contact, processes_here * of_one.points,
                          processes_here * of_one.state, processes_here * of_one.derivatives};
  if (const platform::Room room = platform::free_memory(); of_all.total() + small_things > room.bytes)
    return text(of_all, of_all.total() + small_things, processes_here, "", room, 1);
  const int threads = omp_get_max_threads();
  const double reserved = linalg::blas_address_space(threads), all = of_one.total() + small_things + reserved;
  if (const platform::Room room = platform::address_space(); all > room.bytes)
    return text(of_one, all, 1,
                fmt::format(", reserved for {} {}", threads_text(threads), platform::memory_text(reserved)), room,
                threads);
  return {};
}

}  // namespace creepcontact::run
