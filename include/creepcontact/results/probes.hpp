#pragma once
/// Probes: numbers taken from a snapshot at every output time, the columns of history.csv.

#include <memory>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

class Probe {
 public:
  virtual ~Probe() = default;
  virtual double value(Snapshot& snapshot) const = 0;
};

/// Finds the place of every probe in the model.
/// @throws ModelError with every mistake: a missing group, a point outside the bodies, a surface that is in no contact
std::vector<std::unique_ptr<Probe>> make_probes(const config::Config& config, const model::Model& model);

}  // namespace creepcontact::results
