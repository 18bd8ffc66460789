#include "creepcontact/creep/state_layout.hpp"

namespace creepcontact::creep {

std::size_t gasket_stride(const contact::Pair& pair) {
  if (!pair.gasket || !pair.gasket->kind().creep) return 0;
  std::size_t n = 1;
  for (const auto& law : pair.gasket->kind().creep->creep) n += static_cast<std::size_t>(law->n_internal());
  return n;
}

StateLayout::StateLayout(const Assembly& assembly) {
  for (const mechanics::Body& body : assembly.bodies()) {
    stride_.push_back(body.material().n_state());
    offset_.push_back(offset_.back() + stride_.back() * body.discretization().n_points());
  }
  if (assembly.heat() != nullptr) n_temperatures_ = assembly.heat()->start.size();
  if (assembly.team().rank() != 0) return;
  for (const contact::Pair& pair : assembly.pairs()) n_gaskets_ += gasket_stride(pair) * pair.coupling.nodes.size();
}

void StateLayout::views(std::span<const double> y, std::vector<mechanics::CreepStrainView>& result) const {
  result.resize(stride_.size());
  for (std::size_t b = 0; b < stride_.size(); ++b) result[b] = {part(b, y), stride_[b]};
}

}  // namespace creepcontact::creep
