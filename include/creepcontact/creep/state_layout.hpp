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

  std::size_t size() const { return offset_.back(); }
  std::size_t offset(std::size_t body) const { return offset_[body]; }
  /// Numbers per point; 0 for an elastic body.
  std::size_t stride(std::size_t body) const { return stride_[body]; }

  /// The part of y that belongs to a body, n_points x stride.
  template <typename Number>
  std::span<Number> part(std::size_t body, std::span<Number> y) const {
    return y.subspan(offset_[body], offset_[body + 1] - offset_[body]);
  }

  /// Creep strains of all bodies within y; views of elastic bodies are empty.
  void views(std::span<const double> y, std::vector<mechanics::CreepStrainView>& result) const;

 private:
  std::vector<std::size_t> offset_{0};  // of every body, and the size of all
  std::vector<std::size_t> stride_;
};

}  // namespace creepcontact::creep
