#pragma once
/// The elastic state of a configuration given as text, with the pressure and the gap of every multiplier node.

#include <map>
#include <string>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/results/probes.hpp"
#include "verification/case.hpp"

namespace creepcontact::test {

/// A multiplier node of a unilateral pair.
struct ContactPoint {
  Vector3 position, normal;
  double area, pressure, gap;
  Vector3 shear = Vector3::Zero();  ///< traction on the master body
  double slip = 0;                  ///< accumulated
};

struct ContactState {
  std::map<std::string, std::vector<ContactPoint>> pairs;  ///< by the pairs' names
  std::map<std::string, std::string> slave;                ///< slave surface of each pair
  std::map<std::string, double> probes;
};

std::vector<ContactPoint> contact_points(const contact::Pair& pair, const mesh::Mesh& slave,
                                         const creep::Equilibrium& at);

/// @param accepted  times before t whose states, in this order, the slip of friction has gone through
ContactState contact_state(const std::string& toml, const std::string& geo,
                           const std::vector<std::string>& overrides = {}, double t = 0,
                           const std::vector<double>& accepted = {});

}  // namespace creepcontact::test
