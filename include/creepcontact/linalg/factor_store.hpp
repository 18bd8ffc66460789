#pragma once
/// Factors that outlive the runs that made them, for other runs with the same stiffness.

#include <cstdint>
#include <memory>

#include "creepcontact/linalg/gathered_passes.hpp"
#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::linalg {

/// Lends factors. A matrix that is the same to the last bit is factored once, and all who need its factor share it;
/// another matrix of the same pattern is not analysed again. As many factors as were in use at a time are kept when
/// nobody uses them. Several threads may use one store.
class FactorStore {
 public:
  FactorStore();
  /// Factors that are lent may outlive the store.
  ~FactorStore();
  FactorStore(const FactorStore&) = delete;
  FactorStore& operator=(const FactorStore&) = delete;

  /// Makes solvers with factors of the store. @param make  makes those that it lacks, with a shared_factor()
  /// @param gathering  of their passes; null: none. It must outlive the solvers
  StiffnessSolverFactory lending(GatheredPasses* gathering = nullptr,
                                 StiffnessSolverFactory make = default_stiffness_solver);
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
