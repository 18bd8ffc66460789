#pragma once
/// Factors that outlive the runs that made them, for further runs with the same stiffness.

#include <cstdint>
#include <memory>

#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::linalg {

/// Lends factors. One that comes back is kept and lent again for the same matrix, to the last bit, without being
/// computed again; for another matrix of the same pattern its analysis is used again. At most as many are kept as have
/// been lent at once. Several threads may use one store, each gets factors of its own.
class FactorStore {
 public:
  FactorStore();
  /// Factors that are lent may outlive the store.
  ~FactorStore();
  FactorStore(const FactorStore&) = delete;
  FactorStore& operator=(const FactorStore&) = delete;

  /// Makes solvers that come back to the store when they are destroyed. @param make  makes those that it lacks
  StiffnessSolverFactory lending(StiffnessSolverFactory make = default_stiffness_solver);
  /// Factorisations computed by all that have been lent.
  std::int64_t n_computed() const;
  /// Factorisations that were found computed.
  std::int64_t n_found() const;

 private:
  class Content;
  class Lent;
  std::shared_ptr<Content> content_;
};

}  // namespace creepcontact::linalg
