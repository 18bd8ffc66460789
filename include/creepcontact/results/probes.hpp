#pragma once
/// Probes: numbers computed from a snapshot at every output time, the columns of history.csv.

#include <memory>
#include <span>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

/// One column of history.csv. value() is collective.
class Probe {
 public:
  virtual ~Probe() = default;
  virtual double value(Snapshot& snapshot) const = 0;
};

/// Makes all probes of the configuration, located in the model.
/// @throws ModelError with every error found: a missing group, a point outside the bodies, a surface without contact
std::vector<std::unique_ptr<Probe>> make_probes(const config::Config& config, const model::Model& model);

/// The values of all probes, a row of history.csv. Collective.
std::vector<double> probe_values(std::span<const std::unique_ptr<Probe>> probes, Snapshot& snapshot);

}  // namespace creepcontact::results
