#include "creepcontact/mesh/surface_shape.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>
#include <utility>
#include <vector>

namespace creepcontact::mesh {
namespace {

constexpr std::size_t most_facets = 2000;
constexpr double fits = 1e-4;           // deviation of corners, relative to the size of the piece
constexpr double fits_normals = 0.2;    // mean deviation of the normals [rad]
constexpr double as_good = 1e-6;        // difference of these that does not count
constexpr double no_slope = 1e-6;       // radius of a cone over its length
constexpr double largest_radius = 1e4;  // of the size: beyond, a piece is nearly a plane, and its radius is not known

constexpr std::array kinds{std::pair{ShapeKind::plane, "plane"}, std::pair{ShapeKind::cylinder, "cylinder"},
                           std::pair{ShapeKind::cone, "cone"},   std::pair{ShapeKind::sphere, "sphere"},
                           std::pair{ShapeKind::torus, "torus"}, std::pair{ShapeKind::other, "other"}};

/// A piece of the size 1 about the origin.
struct Piece {
  std::vector<Vector3> points, centers, normals;
  std::vector<double> areas;
  Vector3 middle = Vector3::Zero();
  double size = 1;
};

Piece piece_of(std::span<const Facet> facets) {
  Piece piece;
  Eigen::AlignedBox3d box;
  for (const Facet& facet : facets)
    for (const Vector3& corner : facet.corners) box.extend(corner);
  piece.middle = box.center();
  piece.size = std::max(box.diagonal().norm(), std::numeric_limits<double>::min());
  const auto scaled = [&](const Vector3& x) -> Vector3 { return (x - piece.middle) / piece.size; };
  const std::size_t every = 1 + facets.size() / most_facets;
  for (std::size_t i = 0; i < facets.size(); i += every) {
    const Vector3 doubled = facets[i].doubled_area();
    if (!(doubled.norm() > 0)) continue;
    for (const Vector3& corner : facets[i].corners) piece.points.push_back(scaled(corner));
    piece.centers.push_back(scaled(facets[i].center()));
    piece.normals.push_back(doubled.normalized());
    piece.areas.push_back(doubled.norm() / 2 / piece.size / piece.size);
  }
  return piece;
}

/// A shape of the scaled piece, with the distance of a point from it and its normal at a point near it, of any sign.
struct TrialShape {
  SurfaceShape shape;
  double along = 0, slope = 0;  // cone: radius at the centre is shape.radius, and grows by the slope
};

double radial(const SurfaceShape& shape, const Vector3& x) {
  const Vector3 arm = x - shape.center;
  return (arm - shape.axis.dot(arm) * shape.axis).norm();
}

double distance_from(const TrialShape& one, const Vector3& x) {
  const SurfaceShape& shape = one.shape;
  const Vector3 arm = x - shape.center;
  switch (shape.kind) {
    case ShapeKind::plane:
      return shape.axis.dot(arm);
    case ShapeKind::sphere:
      return arm.norm() - shape.radius;
    case ShapeKind::torus:
      return std::hypot(radial(shape, x) - shape.radius, shape.axis.dot(arm)) - shape.minor_radius;
    default:
      return (radial(shape, x) - shape.radius - one.slope * shape.axis.dot(arm)) / std::hypot(1, one.slope);
  }
}

Vector3 normal_at(const TrialShape& one, const Vector3& x) {
  const SurfaceShape& shape = one.shape;
  const Vector3 arm = x - shape.center;
  const double z = shape.axis.dot(arm);
  const Vector3 out = (arm - z * shape.axis).normalized();
  switch (shape.kind) {
    case ShapeKind::plane:
      return shape.axis;
    case ShapeKind::sphere:
      return arm.normalized();
    case ShapeKind::torus:
      return ((radial(shape, x) - shape.radius) * out + z * shape.axis).normalized();
    default:
      return (out - one.slope * shape.axis).normalized();
  }
}

Vector3 any_normal(const Vector3& axis) {
  return axis.unitOrthogonal();
}

/// ShapeResiduals of a shape with an axis: two numbers turn the axis, two (with a torus three) move it, the others are
/// radii.
struct ShapeResiduals {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const Piece& piece;
  TrialShape start;

  int inputs() const { return start.shape.kind == ShapeKind::torus ? 7 : start.shape.kind == ShapeKind::cone ? 6 : 5; }
  int values() const { return static_cast<int>(piece.points.size()); }

  TrialShape moved(const Eigen::VectorXd& by) const {
    TrialShape result = start;
    const Vector3 u = any_normal(start.shape.axis), v = start.shape.axis.cross(u);
    result.shape.axis = (start.shape.axis + by[0] * u + by[1] * v).normalized();
    result.shape.center += by[2] * u + by[3] * v;
    result.shape.radius += by[4];
    if (start.shape.kind == ShapeKind::cone) result.slope += by[5];
    if (start.shape.kind == ShapeKind::torus) {
      result.shape.minor_radius += by[5];
      result.shape.center += by[6] * start.shape.axis;
    }
    return result;
  }
  int operator()(const Eigen::VectorXd& by, Eigen::VectorXd& residuals) const {
    const TrialShape one = moved(by);
    for (std::size_t i = 0; i < piece.points.size(); ++i)
      residuals[static_cast<Eigen::Index>(i)] = distance_from(one, piece.points[i]);
    return 0;
  }
};

std::optional<TrialShape> fitted(const Piece& piece, const TrialShape& start) {
  const ShapeResiduals residuals{piece, start};
  if (residuals.values() < residuals.inputs()) return std::nullopt;
  Eigen::NumericalDiff<ShapeResiduals> differences(residuals);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<ShapeResiduals>> solver(differences);
  solver.parameters.xtol = solver.parameters.ftol = 1e-14;
  solver.parameters.maxfev = 400;
  Eigen::VectorXd by = Eigen::VectorXd::Zero(residuals.inputs());
  solver.minimize(by);
  return by.allFinite() ? std::optional(residuals.moved(by)) : std::nullopt;
}

std::optional<TrialShape> plane(const Piece& piece) {
  TrialShape one;
  one.shape.kind = ShapeKind::plane;
  for (const Vector3& x : piece.points) one.shape.center += x / static_cast<double>(piece.points.size());
  Matrix3 moments = Matrix3::Zero();
  for (const Vector3& x : piece.points) moments += (x - one.shape.center) * (x - one.shape.center).transpose();
  one.shape.axis = tensor::Principal(moments).directions.col(0);
  return one;
}

/// A circle or a sphere.
template <int Dimension>
struct Round {
  Eigen::Matrix<double, Dimension, 1> center;
  double radius = 0;
};

/// The one through points: |x|^2 = 2 x c + d, about their mean. @returns nullopt if they lie in a line or a plane
template <int Dimension>
std::optional<Round<Dimension>> fit_round(const std::vector<Eigen::Matrix<double, Dimension, 1>>& points) {
  using Point = Eigen::Matrix<double, Dimension, 1>;
  const auto n = static_cast<double>(points.size());
  Point mean = Point::Zero();
  for (const Point& x : points) mean += x / n;
  Eigen::Matrix<double, Dimension, Dimension> moments = Eigen::Matrix<double, Dimension, Dimension>::Zero();
  Point right = Point::Zero();
  double mean_square = 0;
  for (const Point& x : points) {
    const Point arm = x - mean;
    moments += arm * arm.transpose();
    right += arm.squaredNorm() * arm / 2;
    mean_square += arm.squaredNorm() / n;
  }
  const Point center = moments.inverse() * right;
  if (!center.allFinite()) return std::nullopt;
  return Round<Dimension>{mean + center, std::sqrt(mean_square + center.squaredNorm())};
}

std::optional<TrialShape> sphere(const Piece& piece) {
  const std::optional<Round<3>> found = fit_round<3>(piece.points);
  if (!found) return std::nullopt;
  TrialShape one;
  one.shape.kind = ShapeKind::sphere;
  one.shape.center = found->center;
  one.shape.radius = found->radius;
  return one;
}

/// The axis to which the normals have the same angle: right for a cylinder and a cone.
std::optional<TrialShape> cone(const Piece& piece, bool is_cylinder) {
  Vector3 mean = Vector3::Zero();
  double area = 0;
  for (std::size_t i = 0; i < piece.normals.size(); ++i) {
    mean += piece.areas[i] * piece.normals[i];
    area += piece.areas[i];
  }
  mean /= area;
  if (is_cylinder) mean.setZero();
  Matrix3 moments = Matrix3::Zero();
  for (std::size_t i = 0; i < piece.normals.size(); ++i)
    moments += piece.areas[i] * (piece.normals[i] - mean) * (piece.normals[i] - mean).transpose();
  TrialShape one;
  one.shape.kind = is_cylinder ? ShapeKind::cylinder : ShapeKind::cone;
  one.shape.axis = tensor::Principal(moments).directions.col(0);
  // The axis meets the normals: in the plane across it, p + s n = c.
  const Vector3 u = any_normal(one.shape.axis), v = one.shape.axis.cross(u);
  Eigen::Matrix2d across = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < piece.normals.size(); ++i) {
    const Eigen::Vector2d n(piece.normals[i].dot(u), piece.normals[i].dot(v)),
        p(piece.centers[i].dot(u), piece.centers[i].dot(v)), t(-n[1], n[0]);
    across += t * t.transpose();
    right += t * t.dot(p);
  }
  const Eigen::Vector2d center = across.ldlt().solve(right);
  if (!center.allFinite()) return std::nullopt;
  one.shape.center = center[0] * u + center[1] * v;
  // Radius and slope: a line through the points (z, rho).
  double n = 0, z_sum = 0, r_sum = 0, zz = 0, zr = 0;
  for (const Vector3& x : piece.points) {
    const double z = one.shape.axis.dot(x - one.shape.center), r = radial(one.shape, x);
    n += 1, z_sum += z, r_sum += r, zz += z * z, zr += z * r;
  }
  const double spread = n * zz - z_sum * z_sum;
  if (!is_cylinder) one.slope = spread > 0 ? (n * zr - z_sum * r_sum) / spread : 0;
  one.shape.radius = (r_sum - one.slope * z_sum) / n;
  return fitted(piece, one);
}

/// About the line that all normals meet. In Pluecker's coordinates (direction a, moment m) it meets the normal n
/// through p if (p x n) a + n m = 0; the m of the least squares is eliminated.
std::optional<TrialShape> torus(const Piece& piece) {
  Matrix3 aa = Matrix3::Zero(), am = Matrix3::Zero(), mm = Matrix3::Zero();
  for (std::size_t i = 0; i < piece.normals.size(); ++i) {
    const Vector3 &n = piece.normals[i], turned = piece.centers[i].cross(n);
    aa += piece.areas[i] * turned * turned.transpose();
    am += piece.areas[i] * turned * n.transpose();
    mm += piece.areas[i] * n * n.transpose();
  }
  const Matrix3 moment_of = -mm.inverse() * am.transpose();
  const Matrix3 left = aa + am * moment_of;
  if (!left.allFinite()) return std::nullopt;
  TrialShape one;
  one.shape.kind = ShapeKind::torus;
  one.shape.axis = tensor::Principal(left).directions.col(0);
  one.shape.center = one.shape.axis.cross(moment_of * one.shape.axis);
  // In the half plane (rho, z) it is a circle.
  std::vector<Eigen::Vector2d> points;
  points.reserve(piece.points.size());
  for (const Vector3& x : piece.points)
    points.emplace_back(radial(one.shape, x), one.shape.axis.dot(x - one.shape.center));
  const std::optional<Round<2>> circle = fit_round<2>(points);
  if (!circle) return std::nullopt;
  one.shape.radius = circle->center[0];
  one.shape.minor_radius = circle->radius;
  one.shape.center += circle->center[1] * one.shape.axis;
  return fitted(piece, one);
}

/// Mean angle between the normals of the facets and those of the shape; infinite if corners do not lie on it.
double misfit(const Piece& piece, const TrialShape& one) {
  constexpr double none = std::numeric_limits<double>::infinity();
  for (const Vector3& x : piece.points)
    if (!(std::abs(distance_from(one, x)) <= fits)) return none;
  double sum = 0, area = 0;
  for (std::size_t i = 0; i < piece.normals.size(); ++i) {
    const double cosine = std::min(std::abs(piece.normals[i].dot(normal_at(one, piece.centers[i]))), 1.0);
    sum += piece.areas[i] * std::acos(cosine);
    area += piece.areas[i];
  }
  return sum / area <= fits_normals ? sum / area : none;
}

SurfaceShape finished(const Piece& piece, const TrialShape& one) {
  SurfaceShape shape = one.shape;
  double outward = 0, low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < piece.normals.size(); ++i)
    outward += piece.areas[i] * piece.normals[i].dot(normal_at(one, piece.centers[i]));
  for (const Vector3& x : piece.points) {
    const double z = shape.axis.dot(x - shape.center);
    low = std::min(low, z);
    high = std::max(high, z);
  }
  if (shape.kind == ShapeKind::plane) {
    if (outward < 0) shape.axis = -shape.axis;
  } else {
    shape.is_hollow = outward < 0;
    Eigen::Index largest = 0;
    if (shape.axis.cwiseAbs().maxCoeff(&largest); shape.axis[largest] < 0) shape.axis = -shape.axis;
  }
  if (shape.kind == ShapeKind::cylinder || shape.kind == ShapeKind::cone) {
    const double at_low = shape.radius + one.slope * low, at_high = shape.radius + one.slope * high;
    if (shape.kind == ShapeKind::cone) {
      shape.radius = std::max(at_low, at_high);
      shape.minor_radius = std::max(std::min(at_low, at_high), 0.0);
    }
    shape.center += (low + high) / 2 * one.shape.axis;
  }
  shape.center = piece.middle + piece.size * shape.center;
  shape.radius *= piece.size;
  shape.minor_radius *= piece.size;
  return shape;
}

}  // namespace

std::string_view name_of(ShapeKind kind) {
  return kinds[static_cast<std::size_t>(kind)].second;
}

SurfaceShape fit_shape(std::span<const Facet> facets) {
  const Piece piece = piece_of(facets);
  if (piece.normals.empty()) return {};
  if (const auto flat = plane(piece); misfit(piece, *flat) < fits_normals) return finished(piece, *flat);
  std::optional<TrialShape> best;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const std::optional<TrialShape>& one) {
    if (!one || !(one->shape.radius > 0) || !(one->shape.radius < largest_radius)) return;
    if (one->shape.kind == ShapeKind::cone && std::abs(one->slope) < no_slope) return;
    if (const double found = misfit(piece, *one); found < least - as_good) {
      least = found;
      best = one;
    }
  };
  consider(cone(piece, true));
  consider(sphere(piece));
  consider(cone(piece, false));
  consider(torus(piece));
  return best ? finished(piece, *best) : SurfaceShape{};
}

}  // namespace creepcontact::mesh
