#pragma once
/// Shows the observers the states of a run: those at output times, and those that it passes between them.

#include <optional>

#include "observer_list.hpp"
#include "passed_states.hpp"
#include "position.hpp"
#include "restart_points.hpp"
#include "run_context.hpp"

namespace creepcontact::run {

class Reporter {
 public:
  /// @param context, observers, position, restart_points  must outlive the object
  Reporter(const RunContext& context, const ObserverList& observers, Position& position, RestartPoints& restart_points);

  /// The present state is one of results. @param is_end  the run ends here
  void output(bool is_end = false) { output(position_.view(StepView::Source::result), is_end); }
  /// Those output times before the present time whose outputs have not been made.
  void output_before_now();
  /// The run ends at the present time, with an output if there has been none there.
  void output_end();
  /// The present state is between output times.
  void tell(void (Observer::*news)(StepView&));
  /// What tell() does to the evaluation of the present state, if it has been called here before the run was resumed.
  void tell_again();
  bool has_output() const { return last_output_.has_value(); }
  bool is_ruptured() const;

 private:
  void output(StepView at, bool is_end);

  const RunContext& context_;
  const ObserverList& observers_;
  Position& position_;
  RestartPoints& restart_points_;
  PassedStates passed_;
  std::optional<double> last_output_;  // its time
};

}  // namespace creepcontact::run
