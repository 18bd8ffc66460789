#include "creepcontact/run/results_in_memory.hpp"

#include <algorithm>
#include <iterator>

namespace creepcontact::run {

ResultsInMemory::ResultsInMemory(const config::Config& config)
    : with_fields_(config.output.fields), field_times_(config.output.field_times) {}

ResultsInMemory::~ResultsInMemory() = default;

Reaction ResultsInMemory::step(StepView& view) {
  if (view.system().size() == 0) return Reaction::advance;  // loads alone, which have no steps.csv either
  const StepMade& made = *view.step;
  (view.is_tentative ? tentative_ : steps_)
      .push_back({.time = made.report.time,
                  .step = made.report.step,
                  .order = made.report.order,
                  .work = made.work,
                  .active_contacts = made.n_active_contacts,
                  .error_estimate = made.report.error_estimate});
  return Reaction::advance;
}

void ResultsInMemory::keep() {
  std::ranges::move(tentative_, std::back_inserter(steps_));
  tentative_.clear();
}

void ResultsInMemory::undo() {
  tentative_.clear();
}

void ResultsInMemory::output(StepView& view) {
  if (mesh_.points.empty()) take_mesh(view.system().assembly());
  const std::vector<double>& probes = view.probe_values();
  times_.push_back(view.time());
  probe_values_.insert(probe_values_.end(), probes.begin(), probes.end());
  if (!with_fields_ || (field_times_ && !std::ranges::binary_search(*field_times_, view.time()))) return;
  view.with_snapshot([&](results::Snapshot& snapshot) {
    fields_[view.time()] = results::OutputFieldMaker(snapshot.assembly()).at(snapshot);
    return std::vector<double>{};
  });
}

void ResultsInMemory::take_mesh(const creep::Assembly& assembly) {
  const results::OutputFieldMaker maker(assembly);
  mesh_ = maker.mesh();
  if (!maker.surfaces().empty()) contact_mesh_ = maker.surfaces().mesh();
  std::int64_t first = 0;
  for (const mechanics::Body& body : assembly.bodies()) {
    for (const auto& [name, group] : body.mesh().groups)
      if (!group.cells.empty())
        for (const std::int64_t node : mesh::group_nodes(body.mesh(), name)) groups_[name].push_back(first + node);
    first += static_cast<std::int64_t>(body.mesh().n_cell_nodes());
  }
}

}  // namespace creepcontact::run
