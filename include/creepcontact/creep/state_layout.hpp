#pragma once
/// Layout of the creep states of all bodies in the vector y of the differential equation.

#include <span>
#include <vector>

#include "creepcontact/creep/assembly.hpp"

namespace creepcontact::creep {

/// Body after body, in each body point after point: creep strain (6, Mandel order), then the internal variables of its
/// laws in their order. Elastic bodies have no entries. Then creeping gaskets, pair after pair, node after node: creep
/// strain (closure over thickness), then the internal variables of its laws; all of them on the process that solves
/// contact. Then the temperatures of Assembly::heat().
class StateLayout {
 public:
  explicit StateLayout(const Assembly& assembly);

  std::size_t size() const { return offset_.back() + n_gaskets_ + n_temperatures_; }
  std::size_t n_gaskets() const { return n_gaskets_; }
  /// The part of y that belongs to gaskets, n_gaskets().
  template <typename Number>
  std::span<Number> gaskets(std::span<Number> y) const {
    return y.subspan(offset_.back(), n_gaskets_);
  }
  template <typename Number>
  std::span<Number> temperatures(std::span<Number> y) const {
    return y.last(n_temperatures_);
  }
  /// First entry of a body in y.
  std::size_t offset(std::size_t body) const { return offset_[body]; }
  /// Entries per point; 0 for an elastic body.
  std::size_t stride(std::size_t body) const { return stride_[body]; }

  /// The part of y that belongs to a body, n_points x stride(body).
  template <typename Number>
  std::span<Number> part(std::size_t body, std::span<Number> y) const {
    return y.subspan(offset_[body], offset_[body + 1] - offset_[body]);
  }

  /// Views of the creep strains of all bodies inside y, one per body; empty for elastic bodies. They are valid as long
  /// as y.
  void views(std::span<const double> y, std::vector<mechanics::CreepStrainView>& result) const;

 private:
  std::vector<std::size_t> offset_{0};  // of every body, then the end of the last one
  std::size_t n_gaskets_ = 0, n_temperatures_ = 0;
  std::vector<std::size_t> stride_;
};

/// State variables per node of a pair whose gasket creeps; else 0.
std::size_t gasket_stride(const contact::Pair& pair);

}  // namespace creepcontact::creep
