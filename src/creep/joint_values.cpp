#include "creepcontact/creep/joint_values.hpp"

#include <algorithm>

#include "creepcontact/contact/closed_nodes.hpp"

namespace creepcontact::creep {
namespace {

JointValues no_contact(const Assembly& assembly) {
  std::size_t n_nodes = 0;
  for (const contact::Pair& pair : assembly.pairs()) n_nodes += pair.coupling.nodes.size();
  return {std::vector<double>(n_nodes, 0.0), std::vector<double>(n_nodes, 0.0)};
}

}  // namespace

JointValues joint_values(const Assembly& assembly, const Equilibrium& at) {
  JointValues result = no_contact(assembly);
  for (const contact::Pair& pair : assembly.pairs()) {
    const auto multiplier = at.contact.multiplier.segment(pair.first_row, pair.coupling.n_rows());
    for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
      const std::size_t node = static_cast<std::size_t>(pair.first_node) + i;
      if (contact::is_closed(pair, i, at.contact))
        result.pressure[node] = std::max(0.0, pair.coupling.pressure(i, multiplier));
      else
        result.gap[node] = std::max(0.0, at.gaps[pair.first_row + pair.coupling.row(i)] / pair.coupling.area[i]);
    }
  }
  return result;
}

JointValues joint_change(const Assembly& assembly, const Equilibrium& at, const Eigen::VectorXd& multiplier,
                         const Eigen::VectorXd& gap) {
  JointValues result = no_contact(assembly);
  for (const contact::Pair& pair : assembly.pairs()) {
    const auto own = multiplier.segment(pair.first_row, pair.coupling.n_rows());
    for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
      const std::size_t node = static_cast<std::size_t>(pair.first_node) + i;
      if (contact::is_closed(pair, i, at.contact))
        result.pressure[node] = pair.coupling.pressure(i, own);
      else
        result.gap[node] = gap[pair.first_row + pair.coupling.row(i)] / pair.coupling.area[i];
    }
  }
  return result;
}

}  // namespace creepcontact::creep
