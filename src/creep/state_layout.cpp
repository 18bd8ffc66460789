#include "creepcontact/creep/state_layout.hpp"

namespace creepcontact::creep {

StateLayout::StateLayout(const Assembly& assembly) {
  for (const mechanics::Body& body : assembly.bodies()) {
    offset_.push_back(size_);
    stride_.push_back(static_cast<std::size_t>(body.material().n_state()));
    size_ += stride_.back() * body.discretization().n_points();
  }
}

void StateLayout::views(std::span<const double> y, std::vector<mechanics::CreepStrainView>& result) const {
  result.resize(offset_.size());
  for (std::size_t b = 0; b < offset_.size(); ++b)
    result[b] =
        stride_[b] == 0 ? mechanics::CreepStrainView{} : mechanics::CreepStrainView{y.data() + offset_[b], stride_[b]};
}

}  // namespace creepcontact::creep
