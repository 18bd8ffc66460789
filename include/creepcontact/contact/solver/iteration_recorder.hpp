#pragma once
/// Record of the contact iterations, for diagnosis.

#include <cstddef>
#include <string_view>

namespace creepcontact::contact {

/// One iteration of a contact solver.
struct Iteration {
  int set_change = 0;  ///< updates of the active set so far in this solve
  int iteration = 0;   ///< within the set, from 1
  /// none, aitken, anderson or cg as in the configuration, or active_set; with friction also newton, or splitting
  std::string_view method;
  double residual = 0;     ///< estimated error of the multipliers relative to the largest one; 0: direct solution
  std::size_t active = 0;  ///< rows in the set
};

/// Receives the iterations of a contact solver.
class IterationRecorder {
 public:
  virtual ~IterationRecorder() = default;
  /// The iterations that follow belong to a new contact problem at this time.
  virtual void begin_solve(double time) = 0;
  virtual void record(const Iteration& iteration) = 0;
};

}  // namespace creepcontact::contact
