#pragma once
/// Counters of the work of a run. Reports, summary.json, steps.csv, checkpoints and studies take the counters from the
/// one list of fields here.

#include <array>
#include <cstdint>

#include "creepcontact/base/memory.hpp"

namespace creepcontact {

struct RunCounters {
  std::int64_t steps = 0;                 ///< accepted
  std::int64_t rejected_steps = 0;        ///< by the error test
  std::int64_t convergence_failures = 0;  ///< steps tried again because iterations did not converge
  std::int64_t rhs_evaluations = 0;       ///< of the rate of the state
  std::int64_t jacobian_products = 0;
  std::int64_t elastic_solves = 0;  ///< one = one forward and one backward pass through the factor of every body
  std::int64_t contact_solves = 0;
  std::int64_t schwarz_iterations = 0;  ///< over all contact solves
  std::int64_t factorizations = 0;      ///< of the stiffness of one body

  using Field = Member<RunCounters, std::int64_t>;  ///< the name is that in all files
  static constexpr std::array<Field, 9> fields{{
      {"steps", &RunCounters::steps},
      {"rejected_steps", &RunCounters::rejected_steps},
      {"convergence_failures", &RunCounters::convergence_failures},
      {"rhs_evaluations", &RunCounters::rhs_evaluations},
      {"jacobian_products", &RunCounters::jacobian_products},
      {"elastic_solves", &RunCounters::elastic_solves},
      {"contact_solves", &RunCounters::contact_solves},
      {"schwarz_iterations", &RunCounters::schwarz_iterations},
      {"factorizations", &RunCounters::factorizations},
  }};
  static constexpr auto members = fields;

  RunCounters& operator+=(const RunCounters& other);
  RunCounters& operator-=(const RunCounters& other);
  friend RunCounters operator+(RunCounters a, const RunCounters& b) { return a += b; }
  friend RunCounters operator-(RunCounters a, const RunCounters& b) { return a -= b; }
  bool operator==(const RunCounters&) const = default;
};

static_assert(sizeof(RunCounters) == RunCounters::fields.size() * sizeof(std::int64_t), "a counter is not listed");

inline RunCounters& RunCounters::operator+=(const RunCounters& other) {
  for (const Field& field : fields) this->*field.value += other.*field.value;
  return *this;
}

inline RunCounters& RunCounters::operator-=(const RunCounters& other) {
  for (const Field& field : fields) this->*field.value -= other.*field.value;
  return *this;
}

}  // namespace creepcontact
