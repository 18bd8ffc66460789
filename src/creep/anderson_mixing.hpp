#pragma once
/// Anderson acceleration of a fixed-point iteration x = f(x).

#include <Eigen/Core>
#include <deque>
#include <limits>
#include <span>
#include <vector>

#include "creepcontact/base/team.hpp"

namespace creepcontact::creep {

/// Takes as the next x the combination of the last f(x) whose residuals f(x) - x cancel best in the sense of least
/// squares (D. G. Anderson, J. ACM 12 (1965) 547; H. F. Walker, P. Ni, SIAM J. Numer. Anal. 49 (2011) 1715). Begins
/// again where the residual has grown beyond twice the smallest one. Vectors may be distributed over a team. Calls are
/// collective.
class AndersonMixing {
 public:
  /// @param depth  number of earlier iterations that count @param team  must outlive the object
  AndersonMixing(int depth, const Team& team) : depth_(static_cast<std::size_t>(depth)), team_(team) {}

  /// @param x, f  an argument and its value. They may be longer than before: earlier ones had zeros there
  /// @param next  set to the next argument
  /// Cost: depth scalar products
  void mix(std::span<const double> x, std::span<const double> f, std::span<double> next);

 private:
  struct Difference {
    Eigen::VectorXd f, residual;  // between consecutive iterations
  };
  std::size_t depth_;
  const Team& team_;
  std::deque<Difference> differences_;  // the latest first
  bool has_last_ = false;
  double smallest_ = std::numeric_limits<double>::infinity();  // norm of a residual
  Eigen::VectorXd last_f_, last_residual_;
};

}  // namespace creepcontact::creep
