#pragma once
/// What a run tells when it has ended.

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/ode/integrator.hpp"

namespace creepcontact::run {

/// What the steps of a run had in common.
class StepStatistics {
 public:
  void add(const ode::StepReport& step) {
    shortest_ = n_ == 0 ? step.step : std::min(shortest_, step.step);
    longest_ = std::max(longest_, step.step);
    highest_order_ = std::max(highest_order_, step.order);
    largest_error_ = std::max(largest_error_, step.error_estimate);
    sum_of_errors_ += step.error_estimate;
    ++n_;
  }
  bool empty() const { return n_ == 0; }
  std::int64_t n_steps() const { return n_; }
  double shortest() const { return shortest_; }
  double longest() const { return longest_; }
  int highest_order() const { return highest_order_; }
  /// In units of what the tolerance allows a step; 0: the method estimates none.
  double largest_error() const { return largest_error_; }
  double mean_error() const { return n_ > 0 ? sum_of_errors_ / static_cast<double>(n_) : 0; }

 private:
  std::int64_t n_ = 0;
  double shortest_ = 0, longest_ = 0, largest_error_ = 0, sum_of_errors_ = 0;
  int highest_order_ = 0;
};

/// What may have caused trouble.
struct Diagnosis {
  struct Body {
    std::string name;
    double relaxation_time;  ///< shortest at the end; infinity: does not creep
  };
  struct Contact {
    std::string name;
    std::int64_t set_changes;  ///< accepted steps after which other nodes were in contact
    bool is_narrow = false;    ///< its zone is too few elements wide already
  };
  std::vector<Body> bodies;
  std::vector<Contact> contacts;
};

/// Work of the processes that share a run.
struct ProcessWork {
  std::vector<std::string> names;           ///< with units
  std::vector<std::vector<double>> values;  ///< by process, in the order of the names
};

/// The outcome of a run, as a value. run::report() and run::details() make text for people of it.
struct Summary {
  int exit_status = 0;
  std::string message;              ///< why the run ended early, or that nothing was left to do; empty: it did neither
  std::string directory;            ///< of the result files
  bool has_output = false;          ///< at least the first output time has been reached
  io::Summary results;              ///< what summary.json holds
  StepStatistics steps;             ///< since the start or the resume
  bool is_resumed = false;          ///< the run continues another one
  Diagnosis diagnosis;              ///< empty if the last step left nothing to examine
  ProcessWork processes;            ///< empty for one process
  std::vector<std::string> advice;  ///< a sentence or two for each thing that was off

  /// Adds to the warnings of the results, each once.
  void add_warning(const std::string& text) {
    std::vector<std::string>& all = results.warnings;
    if (std::ranges::find(all, text) == all.end()) all.push_back(text);
  }
};

}  // namespace creepcontact::run
