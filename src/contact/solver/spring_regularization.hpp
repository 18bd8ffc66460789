#pragma once
/// Sets of rows for bodies held by contact alone when the set at hand cannot balance the loads: springs hold the
/// bodies, and their force is iterated away (method of multipliers, Hestenes 1969).

#include <functional>
#include <memory>

#include "creepcontact/contact/solver/contact_solver.hpp"

namespace creepcontact::contact {

class SpringRegularization {
 public:
  /// Tries to go on from a state whose set and multipliers the springs found. @returns true to end the search
  using Attempt = std::function<bool(const ContactState& state)>;

  /// @param problem  with rigid-body modes; must outlive the object
  SpringRegularization(const ContactProblem& problem, const StopRequest& stop);
  ~SpringRegularization();

  /// @param set_changes  counted up
  /// @returns false if no attempt succeeded. @throws UnbalancedLoad if no pressures can balance the load
  bool search(const ContactLoad& load, int& set_changes, const Attempt& attempt);

 private:
  class HeldOperator;

  const ContactProblem& problem_;
  ContactProblem held_;  // F + N P N^T, without rigid-body modes
  Eigen::VectorXd compliance_;
  std::unique_ptr<HeldOperator> operator_;
  std::unique_ptr<ContactSolver> solver_;
};

}  // namespace creepcontact::contact
