#pragma once
/// Probes: numbers taken from a snapshot at every output time, the columns of history.csv.

#include <memory>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/simulation/snapshot.hpp"

namespace creepcontact::simulation {

class Probe {
 public:
  virtual ~Probe() = default;
  virtual double value(const Snapshot& snapshot) const = 0;
};

/// Finds the place of every probe in the model.
/// @throws ModelError with every mistake: a missing group, a point outside the bodies, a surface that is in no contact
std::vector<std::unique_ptr<Probe>> make_probes(const config::Config& config, const Model& model,
                                                const std::vector<contact::Pair>& pairs);

}  // namespace creepcontact::simulation
