#pragma once
/// The results of a run, kept in memory for the program that called it.

#include <map>
#include <string>
#include <vector>

#include "creepcontact/io/tables/step_writer.hpp"
#include "creepcontact/results/output_fields.hpp"
#include "creepcontact/run/observer.hpp"

namespace creepcontact::run {

/// What history.csv, steps.csv and the field files would have: RunOptions::observers. For one process.
class ResultsInMemory final : public Observer {
 public:
  /// @param config  says which fields are wanted (output.fields)
  explicit ResultsInMemory(const config::Config& config);
  ~ResultsInMemory() override;

  Reaction step(StepView& view) override;
  void output(StepView& view) override;
  void keep() override;
  void undo() override;

  const std::vector<double>& times() const { return times_; }
  /// A row per output time, in the order of the probes.
  const std::vector<double>& probe_values() const { return probe_values_; }
  const std::vector<io::StepRow>& steps() const { return steps_; }
  const std::map<double, results::OutputFields>& fields() const { return fields_; }
  /// The mesh of the fields, also where none are wanted; empty before the first output.
  const io::FieldMesh& mesh() const { return mesh_; }
  const io::FieldMesh& contact_mesh() const { return contact_mesh_; }
  /// The nodes of the named groups of the mesh, numbered as the points of mesh(), by name.
  const std::map<std::string, std::vector<std::int64_t>>& groups() const { return groups_; }

 private:
  void take_mesh(const creep::Assembly& assembly);

  bool with_fields_;
  std::optional<std::vector<double>> field_times_;  // nullopt: all
  std::vector<double> times_, probe_values_;
  std::vector<io::StepRow> steps_, tentative_;
  std::map<double, results::OutputFields> fields_;
  io::FieldMesh mesh_, contact_mesh_;
  std::map<std::string, std::vector<std::int64_t>> groups_;
};

}  // namespace creepcontact::run
