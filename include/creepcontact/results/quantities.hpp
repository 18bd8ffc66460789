#pragma once
/// The quantities that a probe can ask for, by name.

#include <string>
#include <vector>

#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

struct QuantityInfo {
  enum class Kind {
    field,     ///< a number at every place of a body: `value`
    pressure,  ///< contact surfaces, at the multiplier nodes
    gap,
    area,     ///< of the part in contact
    force,    ///< contact force along `axis`
    reaction  ///< of supports, along `axis`
  };
  enum class Axis { x, y, z };
  std::string name;
  std::string description;
  Kind kind = Kind::field;
  double (*value)(const Sample&) = nullptr;
  Axis axis = Axis::x;
  bool cylindrical = false;  ///< `value` takes the z axis for the one of the cylinder
};

const std::vector<QuantityInfo>& quantities();
/// @throws std::out_of_range if there is none of this name (the configuration is checked before)
const QuantityInfo& quantity(const std::string& name);

}  // namespace creepcontact::results
