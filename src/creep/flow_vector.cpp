#include "flow_vector.hpp"

#include <algorithm>
#include <array>

namespace creepcontact::creep {
namespace {

/// An array of a body and its numbers at each point.
struct FlowArray {
  std::vector<double> PlasticState::*values;
  std::size_t width;
};

std::array<FlowArray, 3> flow_arrays(const material::Plasticity& law) {
  return {{{&PlasticState::strain, 6}, {&PlasticState::accumulated, 1}, {&PlasticState::back, 6 * law.n_back()}}};
}

const material::Plasticity* law_of(const Assembly& assembly, std::size_t body) {
  return assembly.bodies()[body].material().plasticity.get();
}

}  // namespace

std::size_t flow_size(const Assembly& assembly, std::size_t body) {
  const material::Plasticity* law = law_of(assembly, body);
  return law == nullptr ? 0 : (7 + 6 * law->n_back()) * assembly.bodies()[body].discretization().n_points();
}

std::vector<double> flow_vector(const Assembly& assembly, const PlasticHistory& history) {
  std::vector<double> flow;
  for (std::size_t b = 0; b < history.bodies.size(); ++b) {
    const material::Plasticity* law = law_of(assembly, b);
    if (law == nullptr) continue;
    const std::size_t n = assembly.bodies()[b].discretization().n_points();
    for (const FlowArray& array : flow_arrays(*law)) {
      std::vector<double> values = history.bodies[b].*array.values;
      values.resize(n * array.width);  // zero where nothing has flowed
      flow.insert(flow.end(), values.begin(), values.end());
    }
  }
  return flow;
}

void set_flow_vector(const Assembly& assembly, std::span<const double> flow, PlasticHistory& history) {
  auto next = flow.begin();
  for (std::size_t b = 0; b < history.bodies.size(); ++b) {
    const material::Plasticity* law = law_of(assembly, b);
    if (law == nullptr) continue;
    const std::size_t n = assembly.bodies()[b].discretization().n_points();
    for (const FlowArray& array : flow_arrays(*law)) {
      const auto end = next + static_cast<std::ptrdiff_t>(n * array.width);
      (history.bodies[b].*array.values).assign(next, end);
      next = end;
    }
    history.bodies[b].rate.clear();
  }
  history.before.clear();
}

}  // namespace creepcontact::creep
