#pragma once
/// How far the loads between two times are off the straight line between those at both, as contact sees it.

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace creepcontact::creep {

/// Quadratic in pieces.
class LoadCourse {
 public:
  struct Deviation {
    Eigen::VectorXd gap;        ///< weighted gaps without multipliers, n_rows
    Eigen::VectorXd resultant;  ///< on the rigid-body modes that contact holds
  };
  /// @param at  the deviation after a part of the step, in (0, 1) @param is_near  whether two are equal within the
  /// tolerance
  using At = std::function<Deviation(double part)>;
  using IsNear = std::function<bool(const Deviation&, const Deviation&)>;

  /// No deviation: straight.
  LoadCourse() = default;
  /// Splits the step until the parabola through the ends and the middle of each piece meets its quarter points.
  LoadCourse(const Deviation& none, const At& at, const IsNear& is_near);

  bool is_straight() const { return pieces_.empty(); }
  /// False if the pieces became too short before they were near enough, as where loads jump.
  bool is_resolved() const { return is_resolved_; }
  /// Precondition: !is_straight()
  Deviation at(double part) const;

 private:
  struct Piece {
    double begin, end;
    Deviation first, middle, last;
    Deviation at(double part) const;
  };
  void split(Piece piece, int depth, const At& at, const IsNear& is_near);

  std::vector<Piece> pieces_;
  bool is_resolved_ = true;
};

}  // namespace creepcontact::creep
