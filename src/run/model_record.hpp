#pragma once
/// model.json: what a run computes, for reports.

#include "creepcontact/config/config.hpp"
#include "creepcontact/io/tables/model_record.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/model/model.hpp"

namespace creepcontact::run {

/// "48 hex20, 3 wedge15"
std::string element_names(const mesh::Mesh& mesh);

/// [report] of the configuration, with the logo. If the logo cannot be read any more, its name remains.
io::RecordedReport recorded_report(const config::Config& config);

/// @param at_start  its von Mises stresses are the levels of the creep curves
io::ModelRecord model_record(const config::Config& config, const model::Model& model, const io::Summary& at_start);

}  // namespace creepcontact::run
