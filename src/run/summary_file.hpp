#pragma once
/// summary.json and model.json of a run.

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/log.hpp"
#include "creepcontact/run/summary.hpp"
#include "observer_list.hpp"
#include "run_context.hpp"

namespace creepcontact::run {

/// Gives the model.json of a run that goes on, or has ended, the texts that [report] has now. What the run computes
/// stays as it was recorded. Nothing happens if there is no model.json.
/// @throws Error if the disk cannot take it
void renew_report(const std::filesystem::path& directory, const config::Config& config);

/// Writes them at outputs, so that a run that is killed leaves a summary of how far it came, and at the end.
class SummaryFile final : public Observer {
 public:
  using Status = io::Summary::Status;

  /// @param context, observers, warnings (of this run)  must outlive the object
  /// @param earlier_warnings  of the run that this one continues
  /// @param describe_loop  adds to a summary what the loop knows
  SummaryFile(const RunContext& context, const ObserverList& observers, std::vector<std::string> earlier_warnings,
              const log::WarningRecord& warnings, std::function<void(Summary&)> describe_loop);

  /// Writes the summary at most once per second: this takes longer than many a step.
  void output(StepView& view) override;
  /// Returns the summary of the run up to now.
  Summary make(Status status, const std::string& message) const;
  /// Replaces summary.json. Collective. @throws Error if the disk cannot take it
  void write(const Summary& summary) const;

 private:
  using Clock = std::chrono::steady_clock;

  const RunContext& context_;
  const ObserverList& observers_;
  std::vector<std::string> earlier_warnings_;
  const log::WarningRecord& warnings_;
  std::function<void(Summary&)> describe_loop_;
  bool has_model_record_;
  std::optional<Clock::time_point> last_;
};

}  // namespace creepcontact::run
