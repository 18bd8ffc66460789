#pragma once
/// Where functions of the configuration act.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model_parts.hpp"

namespace creepcontact::model {

/// A position at which a function is evaluated, on a body.
struct Place {
  Vector3 position = Vector3::Zero();
  std::size_t body = 0;
};
using Places = std::vector<Place>;

/// The one list that says where a key acts: a load or a support on its group or point, a gap or friction on the two
/// surfaces, a material or a body on its elements. Every other key acts on all bodies. The objects must outlive it.
class KeyPlaces {
 public:
  KeyPlaces(const config::Config& config, const Bodies& bodies) : config_(config), bodies_(bodies) {}

  /// Nodes, centres of elements or faces, and, where there are few, points between. Empty: a material that no body has.
  /// @param key  full: "loads[0].traction[2]"
  std::shared_ptr<const Places> of(const std::string& key);

 private:
  Places on_group(const std::string& group, const config::Reference& body) const;
  Places on_bodies(const std::vector<std::size_t>& bodies) const;
  Places of_load(const config::Load& load) const;
  /// The node at which functions of position are evaluated: the nearest one, or that with the number.
  Places at_node(const config::PointForce& force, const config::Reference& body) const;
  /// What decides where the key acts: "loads[0]"; empty: acts on all bodies.
  std::string part(const std::string& key) const;
  Places made(const std::string& part) const;

  const config::Config& config_;
  const Bodies& bodies_;
  std::map<std::string, std::shared_ptr<const Places>> known_;
};

/// Positions far from each other, the first of each body among them: indices, `n` or few more.
std::vector<std::size_t> spread(const Places& places, std::size_t n);

}  // namespace creepcontact::model
