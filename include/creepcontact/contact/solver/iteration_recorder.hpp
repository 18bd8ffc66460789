#pragma once
/// The history of the contact iterations, for those who ask for it.

#include <cstddef>
#include <string_view>

namespace creepcontact::contact {

struct Iteration {
  int set_change = 0;       ///< updates of the active set so far in this solve
  int iteration = 0;        ///< within the set, from 1
  std::string_view method;  ///< none, aitken, anderson, cg as in the configuration, or active_set
  double residual = 0;      ///< estimated error of the multipliers relative to the largest; 0: solved directly
  std::size_t active = 0;   ///< rows in the set
};

class IterationRecorder {
 public:
  virtual ~IterationRecorder() = default;
  /// The iterations to come belong to a new contact problem.
  virtual void begin_solve(double time) = 0;
  virtual void record(const Iteration& iteration) = 0;
};

}  // namespace creepcontact::contact
