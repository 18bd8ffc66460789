#pragma once
/// The result files of a run, written as it goes.

#include <filesystem>
#include <memory>
#include <optional>

#include "creepcontact/config/config.hpp"
#include "creepcontact/io/field_writer.hpp"
#include "creepcontact/io/history_writer.hpp"
#include "creepcontact/io/step_writer.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/results/contact_surfaces.hpp"
#include "creepcontact/results/probes.hpp"

namespace creepcontact::results {

class Results {
 public:
  /// @param assembly  must outlive the object @param probes  those of the configuration
  /// @param continuation  of an interrupted run, or none
  Results(const config::Config& config, const std::filesystem::path& directory, const creep::Assembly& assembly,
          std::vector<std::unique_ptr<Probe>> probes, io::Continuation continuation);

  /// A row of history.csv, and files of the fields in the bodies and on the contact surfaces.
  void output(Snapshot& snapshot);
  /// A row of steps.csv. @param before, after  counters around the step
  void step(const ode::StepReport& report, const creep::RunCounters& before, const creep::RunCounters& after);
  /// Waits until all rows are on the disk itself; field files are when they are written.
  void sync();
  /// Last row of history.csv.
  const std::vector<double>& last_values() const { return values_; }

 private:
  std::vector<std::unique_ptr<Probe>> probes_;
  std::vector<double> values_;
  std::unique_ptr<io::HistoryWriter> history_;
  std::unique_ptr<io::StepWriter> steps_;
  ContactSurfaces surfaces_;
  std::unique_ptr<io::FieldWriter> fields_, contact_;
};

}  // namespace creepcontact::results
