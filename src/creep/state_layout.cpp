#include "creepcontact/creep/state_layout.hpp"

namespace creepcontact::creep {

StateLayout::StateLayout(const Assembly& assembly) {
  for (const mechanics::Body& body : assembly.bodies()) {
    stride_.push_back(body.material().n_state());
    offset_.push_back(offset_.back() + stride_.back() * body.discretization().n_points());
  }
}

void StateLayout::views(std::span<const double> y, std::vector<mechanics::CreepStrainView>& result) const {
  result.resize(stride_.size());
  for (std::size_t b = 0; b < stride_.size(); ++b) result[b] = {part(b, y), stride_[b]};
}

}  // namespace creepcontact::creep
