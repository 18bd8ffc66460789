#pragma once
/// The projection of the trace of a tensor at the points of an element (fem::Projection).

#include <array>

#include "element_view.hpp"
#include "lanes.hpp"

namespace creepcontact::mechanics {

/// ElementBlock::linear_functions() at adjacent points.
template <typename V>
CREEPCONTACT_INLINE V linear_function(const ElementView& element, std::size_t p, std::size_t j) {
  return load<V>(element.linear + j * element.n_points + p);
}

/// False if all of the trace stays as it is. @param unprojected  share of it that does
CREEPCONTACT_INLINE bool changes_trace(const ElementView& element, double unprojected) {
  return element.projection != fem::Projection::none && unprojected != 1;
}

/// Precondition: changes_trace(). First add() at all points, then finish(), then shift() at all points. D: dimension of
/// the section.
template <std::size_t D>
class TraceProjection {
 public:
  /// @param unprojected  share of the trace that stays as it is
  CREEPCONTACT_INLINE TraceProjection(const ElementView& element, double unprojected)
      : element_(element), share_((1 - unprojected) / 3), is_linear_(element.projection == fem::Projection::linear) {}

  template <typename V>
  CREEPCONTACT_INLINE void add(std::size_t p, const V& trace) {
    const V weight = load<V>(element_.weight + p), weighted = weight * trace;
    volume_.add(weight);
    sum_.add(weighted);
    if (!is_linear_) return;
    for (std::size_t j = 0; j < D; ++j) sums_[j].add(weighted * linear_function<V>(element_, p, j));
  }

  CREEPCONTACT_INLINE void finish() {
    mean_ = sum_.value() / volume_.value();
    for (std::size_t j = 0; j < D; ++j) moments_[j] = sums_[j].value();
  }
  CREEPCONTACT_INLINE double mean() const { return mean_; }
  /// Sum of weight, trace and linear function j.
  CREEPCONTACT_INLINE double moment(std::size_t j) const { return moments_[j]; }

  /// What is added to each of the three normal components. @param trace  that of add()
  template <typename V>
  CREEPCONTACT_INLINE V shift(std::size_t p, const V& trace) const {
    V projected = V{} + mean_;
    if (is_linear_)
      for (std::size_t j = 0; j < D; ++j) projected += moments_[j] * linear_function<V>(element_, p, j);
    return share_ * (projected - trace);
  }

 private:
  const ElementView& element_;
  double share_;
  bool is_linear_;
  LaneSum volume_, sum_;
  std::array<LaneSum, D> sums_;
  double mean_ = 0;
  std::array<double, D> moments_{};
};

}  // namespace creepcontact::mechanics
