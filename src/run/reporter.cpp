#include "reporter.hpp"

#include "creepcontact/run/summary.hpp"

namespace creepcontact::run {

using Source = StepView::Source;

Reporter::Reporter(const RunContext& context, const ObserverList& observers, Position& position,
                   RestartPoints& restart_points)
    : context_(context),
      observers_(observers),
      position_(position),
      restart_points_(restart_points),
      passed_(!context.integrates && !context.system().depends_on_path() && !context.config.time.cycle) {}

void Reporter::output_before_now() {
  Schedule& schedule = position_.schedule();
  for (; schedule.next_output() < position_.time(); schedule.pass_output())
    output(position_.view_at(schedule.next_output(), Source::result), false);
}

void Reporter::output_end() {
  output_before_now();
  if (last_output_ != position_.time()) output(!is_ruptured());
}

bool Reporter::is_ruptured() const {
  Summary summary;
  observers_.finish(summary);
  return summary.results.rupture.has_value();
}

void Reporter::tell(void (Observer::*news)(StepView&)) {
  StepView now = position_.view(Source::accepted);
  if (passed_.evaluate(now)) observers_.tell(news, now);
}

void Reporter::tell_again() {
  StepView here = position_.view(Source::accepted);
  if (position_.schedule().is_breakpoint(position_.time())) passed_.evaluate(here);
}

void Reporter::output(StepView at, bool is_end) {
  at.is_end = is_end || at.time() == context_.config.time.end;
  at.evaluation();
  const auto lap = context_.watch.lap(Part::output);
  restart_points_.complete_files_before_output();
  observers_.tell(&Observer::output, at, Part::output);
  last_output_ = at.time();
}

}  // namespace creepcontact::run
