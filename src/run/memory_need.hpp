#pragma once
/// Memory that a run takes, and whether there is as much.

#include <functional>
#include <string>

#include "creepcontact/config/config.hpp"
#include "creepcontact/model/model.hpp"

namespace creepcontact::run {

/// Bytes.
struct MemoryNeed {
  double factors = 0;      ///< with the working memory of a factorisation
  double contact = 0;      ///< matrices of the contact zones
  double points = 0;       ///< at integration points and nodes
  double state = 0;        ///< of the differential equation, and the vectors of its integrator
  double derivatives = 0;  ///< likewise of the derivatives ([sensitivity]), and the models from which they are taken
  double total() const { return factors + contact + points + state + derivatives; }
};

/// What a run takes beyond its model. @param assembly  what this process has of it @param contact_bytes  the matrices
/// of all contact zones
/// @param of_factor  bytes of a body's factor, with the working memory of its factorisation
MemoryNeed memory_need(const config::Config& config, const creep::Assembly& assembly, double contact_bytes,
                       const std::function<double(std::size_t body)>& of_factor);

/// Why there is no room for this need: what it consists of, what there is, and what bounds it. Empty if there is.
/// @param processes_here  that need as much each, and share the memory of this machine
std::string memory_shortage(const MemoryNeed& need, int processes_here = 1);

}  // namespace creepcontact::run
