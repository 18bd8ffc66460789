#include "creepcontact/creep/joint_values.hpp"

#include <algorithm>

#include "creepcontact/contact/closed_nodes.hpp"

namespace creepcontact::creep {
namespace {

/// @param pressure, gap  (pair, node) of closed and of open nodes
template <typename Pressure, typename Gap>
JointValues at_all_nodes(const Assembly& assembly, const Equilibrium& at, const Pressure& pressure, const Gap& gap) {
  JointValues result;
  for (const contact::Pair& pair : assembly.pairs())
    for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
      const bool is_closed = contact::is_closed(pair, i, at.contact);
      result.pressure.push_back(is_closed ? pressure(pair, i) : 0.0);
      result.gap.push_back(is_closed ? 0.0 : gap(pair, i));
    }
  return result;
}

double pressure_at(const contact::Pair& pair, std::size_t node, const Eigen::VectorXd& multiplier) {
  return pair.coupling.pressure(node, multiplier.segment(pair.first_row, pair.coupling.n_rows()));
}
double gap_at(const contact::Pair& pair, std::size_t node, const Eigen::VectorXd& weighted) {
  return weighted[pair.first_row + pair.coupling.row(node)] / pair.coupling.area[node];
}

}  // namespace

JointValues joint_values(const Assembly& assembly, const Equilibrium& at) {
  return at_all_nodes(
      assembly, at,
      [&](const contact::Pair& pair, std::size_t i) {
        return std::max(0.0, pressure_at(pair, i, at.contact.multiplier));
      },
      [&](const contact::Pair& pair, std::size_t i) { return std::max(0.0, gap_at(pair, i, at.gaps)); });
}

JointValues joint_change(const Assembly& assembly, const Equilibrium& at, const Eigen::VectorXd& multiplier,
                         const Eigen::VectorXd& gap) {
  return at_all_nodes(
      assembly, at, [&](const contact::Pair& pair, std::size_t i) { return pressure_at(pair, i, multiplier); },
      [&](const contact::Pair& pair, std::size_t i) { return gap_at(pair, i, gap); });
}

}  // namespace creepcontact::creep
