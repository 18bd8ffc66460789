#pragma once
/// Whole runs of the two blocks, and the tables they leave.

#include <csignal>
#include <string>
#include <vector>

#include "creepcontact/run/report.hpp"
#include "creepcontact/run/run.hpp"
#include "support/run/blocks.hpp"
#include "support/run/result_files.hpp"

namespace creepcontact::run::test {

using creepcontact::test::SummaryFile;
using creepcontact::test::Table;

inline const std::string pressure_probe = R"(
[[probes]]
name = "pressure"
quantity = "contact_pressure"
on = "upper_bottom"
)";

/// Interrupts a run, as Ctrl-C does, at an output.
class InterruptAtOutput final : public Observer {
 public:
  /// @param number  of the output, from 1
  explicit InterruptAtOutput(int number) : left_(number) {}
  void output(StepView& /*view*/) override {
    if (--left_ == 0) std::raise(SIGINT);
  }

 private:
  int left_;
};

/// These overrides and those that make the blocks elastic.
std::vector<std::string> elastic(std::vector<std::string> more);

/// Mean pressure of the blocks, pressed with 1 and held: (0.025 / 1) d(sigma)/dt = -(2 + 1) A sigma^4
double relaxed_pressure(double t);

/// At all output times of the probe `pressure`.
void expect_relaxed_pressure(const Table& history, double tolerance, const std::string& where = "");

}  // namespace creepcontact::run::test
