#pragma once
/// Where every body's creep state stands in the vector y of the differential equation.

#include <span>
#include <vector>

#include "creepcontact/creep/assembly.hpp"

namespace creepcontact::creep {

/// Bodies one after the other; in a body point after point: creep strain (6, Mandel order), then the internal variables
/// of its mechanisms in their order. Elastic bodies take no place.
class StateLayout {
 public:
  explicit StateLayout(const Assembly& assembly);

  std::size_t size() const { return size_; }
  std::size_t offset(std::size_t body) const { return offset_[body]; }
  /// Numbers per point; 0 for an elastic body.
  std::size_t stride(std::size_t body) const { return stride_[body]; }

  /// Creep strains of all bodies within y; views of elastic bodies are empty.
  void views(std::span<const double> y, std::vector<mechanics::CreepStrainView>& result) const;

 private:
  std::vector<std::size_t> offset_, stride_;
  std::size_t size_ = 0;
};

}  // namespace creepcontact::creep
