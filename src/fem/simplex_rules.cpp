/// Rules on the unit triangle and tetrahedron: symmetric, positive weights, inner points.
/// Source: Dunavant (1985), the constants refined to double precision; for the tetrahedron Witherden and Vincent
/// (2015), degree 3, and Keast (1986), degree 5.
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/quadrature.hpp"

namespace creepcontact::fem {

namespace {

/// Collects orbits of symmetric points. Weights are given relative to the measure of the domain.
class SymmetricRule {
 public:
  explicit SymmetricRule(double measure) : measure_(measure) {}

  void add(double weight, std::initializer_list<Vector3> points) {
    for (const Vector3& point : points) {
      points_.push_back(point);
      weights_.push_back(weight * measure_);
    }
  }

  QuadratureRule get() const {
    const Index n = points_.size();
    QuadratureRule rule{Eigen::MatrixX3d(n, 3), Eigen::VectorXd(n)};
    for (Index i = 0; i < n; ++i) {
      rule.points.row(i) = points_[i];
      rule.weights[i] = weights_[i];
    }
    return rule;
  }

 private:
  double measure_;
  std::vector<Vector3> points_;
  std::vector<double> weights_;
};

struct Triangle : SymmetricRule {
  Triangle() : SymmetricRule(0.5) {}
  void centre(double w) { add(w, {{1. / 3, 1. / 3, 0}}); }
  void three(double w, double a) {
    const double b = 1 - 2 * a;
    add(w, {{a, a, 0}, {b, a, 0}, {a, b, 0}});
  }
  void six(double w, double a, double b) {
    const double c = 1 - a - b;
    add(w, {{a, b, 0}, {b, a, 0}, {a, c, 0}, {c, a, 0}, {b, c, 0}, {c, b, 0}});
  }
};

struct Tetrahedron : SymmetricRule {
  Tetrahedron() : SymmetricRule(1. / 6) {}
  void centre(double w) { add(w, {{0.25, 0.25, 0.25}}); }
  void four(double w, double a) {
    const double b = 1 - 3 * a;
    add(w, {{a, a, a}, {b, a, a}, {a, b, a}, {a, a, b}});
  }
  void six(double w, double a) {
    const double b = 0.5 - a;
    add(w, {{a, a, b}, {a, b, a}, {b, a, a}, {a, b, b}, {b, a, b}, {b, b, a}});
  }
};

[[noreturn]] void fail(const char* shape, int degree, int highest) {
  throw std::invalid_argument(std::string(shape) + " rule of degree " + std::to_string(degree) + "; allowed: 1 to " +
                              std::to_string(highest));
}

const double sqrt15 = std::sqrt(15.0);

}  // namespace

QuadratureRule triangle(int degree) {
  if (degree < 1 || degree > 8) fail("triangle", degree, 8);
  Triangle rule;
  if (degree == 1) {
    rule.centre(1);
  } else if (degree == 2) {
    rule.three(1. / 3, 1. / 6);
  } else if (degree <= 4) {  // the smallest rule of degree 3 has a negative weight
    rule.three(0.223381589678011466, 0.445948490915964886);
    rule.three(0.109951743655321868, 0.0915762135097707435);
  } else if (degree == 5) {
    rule.centre(0.225);
    rule.three((155 + sqrt15) / 1200, (6 + sqrt15) / 21);
    rule.three((155 - sqrt15) / 1200, (6 - sqrt15) / 21);
  } else if (degree == 6) {
    rule.three(0.116786275726379366, 0.249286745170910421);
    rule.three(0.0508449063702068169, 0.0630890144915022283);
    rule.six(0.0828510756183735752, 0.0531450498448169474, 0.310352451033784405);
  } else {  // degree 7 of Dunavant has a negative weight
    rule.centre(0.144315607677787168);
    rule.three(0.0950916342672846248, 0.459292588292723156);
    rule.three(0.10321737053471825, 0.170569307751760207);
    rule.three(0.0324584976231980803, 0.0505472283170309755);
    rule.six(0.0272303141744349943, 0.00839477740995760534, 0.263112829634638113);
  }
  return rule.get();
}

QuadratureRule tetrahedron(int degree) {
  if (degree < 1 || degree > 5) fail("tetrahedron", degree, 5);
  Tetrahedron rule;
  if (degree == 1) {
    rule.centre(1);
  } else if (degree == 2) {
    rule.four(0.25, (5 - std::sqrt(5.0)) / 20);
  } else if (degree == 3) {
    rule.four(0.13852796651186214, 0.32805469671142665);
    rule.four(0.11147203348813786, 0.10695227393293068);
  } else {  // smaller rules of degree 4 have negative weights
    rule.centre(16. / 135);
    rule.four((2665 + 14 * sqrt15) / 37800, (7 - sqrt15) / 34);
    rule.four((2665 - 14 * sqrt15) / 37800, (7 + sqrt15) / 34);
    rule.six(20. / 378, (10 - 2 * sqrt15) / 40);
  }
  return rule.get();
}

}  // namespace creepcontact::fem
