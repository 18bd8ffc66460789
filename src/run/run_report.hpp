#pragma once
/// The tables at the end of a run, and advice where something was off.

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/ode/integrator.hpp"

namespace creepcontact::run {

/// What the steps of a run had in common.
class StepStatistics {
 public:
  void see(const ode::StepReport& step) {
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
  };
  std::vector<Body> bodies;
  std::vector<Contact> contacts;
};

/// What came out: contact forces and stresses at the start, at their largest and at the end, contacts that opened,
/// damage, life and rupture.
std::string outcome_table(const io::Summary& summary);

/// What it cost, in one line. @param method  the integrator at work at the end; empty: nothing creeps
std::string work_line(const io::Summary& summary, const StepStatistics& steps, double tolerance,
                      const std::string& method);

/// What it cost, in detail.
std::string work_table(const io::Summary& summary, const StepStatistics& steps, double tolerance,
                       const std::string& method);

/// One sentence or two for each thing that was off; empty if all went well.
std::vector<std::string> advice(const io::Summary& summary, const StepStatistics& steps, const Diagnosis& diagnosis);

}  // namespace creepcontact::run
