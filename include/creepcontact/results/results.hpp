#pragma once
/// The result files of a run, written while it proceeds.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "creepcontact/config/config.hpp"
#include "creepcontact/io/field_writer.hpp"
#include "creepcontact/io/history_writer.hpp"
#include "creepcontact/io/step_writer.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/results/contact_surfaces.hpp"
#include "creepcontact/results/probes.hpp"

namespace creepcontact::results {

class RevolvedSection;  // pictures of axisymmetric models (implementation)

/// Writer of history.csv, steps.csv and the field files.
class Results {
 public:
  /// @param assembly  must outlive the object @param probes  as made by make_probes() for this configuration
  /// @param continuation  of an interrupted run; default: a new one
  /// @throws ConfigError if a file cannot be opened or, when resuming, does not fit
  Results(const config::Config& config, const std::filesystem::path& directory, const creep::Assembly& assembly,
          std::vector<std::unique_ptr<Probe>> probes, io::Continuation continuation);
  ~Results();

  /// Writes a row of history.csv, and the field files of bodies and contact surfaces. @throws Error if the disk is full
  void output(Snapshot& snapshot);
  /// A row of steps.csv. @param work  of this step
  void step(const ode::StepReport& report, const RunCounters& work, std::int64_t n_active_contacts);
  /// Waits until all rows are on the disk itself; field files are when they are written.
  void sync();
  /// Values of the last row of history.csv, one per probe.
  const std::vector<double>& last_values() const { return values_; }
  /// Those of the configuration, in its order.
  std::span<const std::unique_ptr<Probe>> probes() const { return probes_; }

 private:
  /// The arrays under the names that they have in the files.
  std::vector<io::FieldData> named(std::vector<io::FieldData> arrays) const;

  std::vector<std::unique_ptr<Probe>> probes_;
  std::vector<double> values_;
  std::unique_ptr<io::HistoryWriter> history_;
  std::unique_ptr<io::StepWriter> steps_;
  ContactSurfaces surfaces_;
  std::unique_ptr<RevolvedSection> section_;
  std::unique_ptr<io::FieldWriter> fields_, contact_, revolved_;
  std::map<std::string, std::string> names_with_units_;  // by the name without
};

}  // namespace creepcontact::results
