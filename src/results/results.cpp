#include "creepcontact/results/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "creepcontact/base/units.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "creepcontact/results/quantities.hpp"
#include "frd_fields.hpp"
#include "revolved_section.hpp"

namespace creepcontact::results {
namespace {

/// Names of the arrays with their units: "stress [MPa]".
std::map<std::string, std::string> names_with_units(const std::string& units) {
  std::map<std::string, std::string> names;
  for (const OutputVariable& variable : output_variables())
    if (const std::string unit = unit_of(variable.dimension, units); !unit.empty())
      for (const std::string& name : {variable.name, variable.point_array, variable.cell_array})
        names[name] = fmt::format("{} [{}]", name, unit);
  names["contact_traction"] =
      "contact_traction" +
      (unit_of(Dimension::stress, units).empty() ? "" : " [" + unit_of(Dimension::stress, units) + "]");
  return names;
}

}  // namespace

Results::Results(const config::Config& config, const std::filesystem::path& directory, const creep::Assembly& assembly,
                 io::Continuation continuation, bool writes)
    : maker_(assembly), field_times_(config.output.field_times) {
  if (!writes) return;
  std::vector<std::string> names;
  for (const config::Probe& probe : config.probes) names.push_back(probe.name);
  history_ = std::make_unique<io::HistoryWriter>(directory / "history.csv", names, continuation, config.output.csv);
  steps_ = std::make_unique<io::StepWriter>(directory / "steps.csv", continuation, config.output.csv);
  if (config.output.frd) {
    std::vector<const mesh::Mesh*> meshes;
    for (const mechanics::Body& body : assembly.bodies()) meshes.push_back(&body.mesh());
    frd_ = std::make_unique<io::FrdWriter>(directory / "fields.frd", meshes, continuation);
  }
  if (!config.output.fields) return;
  if (config.output.unit_names) names_with_units_ = names_with_units(config.units);
  const io::FieldMesh mesh = maker_.mesh();
  fields_ = std::make_unique<io::FieldWriter>(directory, "fields", mesh, config.units, continuation);
  if (config.output.revolve > 0) {
    section_ = std::make_unique<RevolvedSection>(mesh, config.output.revolve);
    revolved_ = std::make_unique<io::FieldWriter>(directory, "revolved", section_->mesh(), config.units, continuation);
  }
  if (!maker_.surfaces().empty())
    contact_ =
        std::make_unique<io::FieldWriter>(directory, "contact", maker_.surfaces().mesh(), config.units, continuation);
}

Results::~Results() = default;

void Results::output(Snapshot& snapshot, std::span<const double> probe_values) {
  history_->write(snapshot.time(), probe_values);
  if ((!fields_ && !frd_) || (field_times_ && !std::ranges::binary_search(*field_times_, snapshot.time()))) return;
  OutputFields made = maker_.at(snapshot);
  std::vector<io::FrdField> for_frd;
  if (frd_) for_frd = frd_fields(made.at_points);
  background_.start([this, for_frd = std::move(for_frd), time = snapshot.time(),
                     points = named(std::move(made.at_points)), cells = named(std::move(made.in_cells)),
                     on_surfaces = named(std::move(made.on_contacts))] {
    if (contact_) contact_->write(time, on_surfaces, named(maker_.surfaces().cell_arrays()));
    if (fields_) fields_->write(time, points, cells);
    if (frd_) frd_->write(time, for_frd);
    if (revolved_) revolved_->write(time, section_->at_points(points), section_->at_cells(cells));
  });
}

std::vector<io::FieldData> Results::named(std::vector<io::FieldData> arrays) const {
  for (io::FieldData& array : arrays)
    if (const auto found = names_with_units_.find(array.name); found != names_with_units_.end())
      array.name = found->second;
  return arrays;
}

void Results::sync() {
  if (!history_) return;
  background_.wait();
  std::vector<std::filesystem::path> files{history_->path(), steps_->path()};
  for (io::FieldWriter* const writer : {fields_.get(), contact_.get(), revolved_.get()})
    if (writer != nullptr) std::ranges::move(writer->take_unsynced(), std::back_inserter(files));
  if (frd_) files.push_back(frd_->path());
  platform::sync_files(files);
}

void Results::step(const ode::StepReport& report, const RunCounters& work, std::int64_t n_active_contacts) {
  if (!steps_) return;
  steps_->write({.time = report.time,
                 .step = report.step,
                 .order = report.order,
                 .work = work,
                 .active_contacts = n_active_contacts,
                 .error_estimate = report.error_estimate});
}

}  // namespace creepcontact::results
