#pragma once
/// What a criterion looks at: a probe, a field of bodies, a contact, the strain through a wall.

#include <memory>
#include <string>

#include "creepcontact/results/criteria.hpp"

namespace creepcontact::results {

bool is_minimum(const config::Criterion& criterion);
std::string unit_of_criterion(const config::Criterion& criterion, const config::Config& config);
/// What is demanded, without the times: "mean pressure of contact 'seal': at least 12 MPa"
std::string demand_of(const config::Criterion& criterion, const std::string& unit);

/// @param probes  of the configuration; they must outlive the measure, as the model
std::unique_ptr<CriterionMeasure> make_measure(const config::Criterion& criterion, const config::Config& config,
                                               const model::Model& model,
                                               std::span<const std::unique_ptr<Probe>> probes);

}  // namespace creepcontact::results
