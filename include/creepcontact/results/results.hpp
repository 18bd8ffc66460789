#pragma once
/// The result files of a run, written while it proceeds.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "creepcontact/config/config.hpp"
#include "creepcontact/io/fields/field_writer.hpp"
#include "creepcontact/io/fields/frd_writer.hpp"
#include "creepcontact/io/tables/history_writer.hpp"
#include "creepcontact/io/tables/step_writer.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/platform/background.hpp"
#include "creepcontact/results/output_fields.hpp"
#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

class RevolvedSection;  // pictures of axisymmetric models (implementation)

/// Writer of history.csv, steps.csv and the field files.
class Results {
 public:
  /// @param assembly  must outlive the object. @param continuation  of an interrupted run; default: a new one.
  /// @param writes  false: this process writes no results, another one does.
  /// @throws ConfigError if a file cannot be opened or, when resuming, does not fit
  Results(const config::Config& config, const std::filesystem::path& directory, const creep::Assembly& assembly,
          io::Continuation continuation, bool writes = true);
  ~Results();

  /// Writes a row of history.csv. The field files of bodies and contact surfaces, if their time is one of those wanted,
  /// are compressed and written while the caller goes on.
  /// @param probe_values  in the order of the configuration
  /// @throws Error if the disk is full, for field files with the next call of output(), wait() or sync()
  void output(Snapshot& snapshot, std::span<const double> probe_values);
  /// True while field files are being written.
  bool is_writing() const { return background_.busy(); }
  /// Waits until the field files are written. @throws Error if the disk is full
  void wait() { background_.wait(); }
  /// A row of steps.csv. @param work  of this step
  void step(const ode::StepReport& report, const RunCounters& work, std::int64_t n_active_contacts);
  /// Waits until all rows and field files are on the disk itself. @throws Error if it cannot take them
  void sync();

 private:
  /// The arrays under the names that they have in the files.
  std::vector<io::FieldData> named(std::vector<io::FieldData> arrays) const;

  std::unique_ptr<io::HistoryWriter> history_;
  std::unique_ptr<io::StepWriter> steps_;
  OutputFieldMaker maker_;
  std::unique_ptr<RevolvedSection> section_;
  std::unique_ptr<io::FieldWriter> fields_, contact_, revolved_;
  std::unique_ptr<io::FrdWriter> frd_;
  std::map<std::string, std::string> names_with_units_;  // by the name without
  std::optional<std::vector<double>> field_times_;       // nullopt: all
  platform::Background background_;                      // ends before what it writes with
};

}  // namespace creepcontact::results
