#include "patches.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <map>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/tangents.hpp"

namespace creepcontact::heat {
namespace {

constexpr double perfect = 1000;       // times the conductivity over the size of an element
constexpr double least_weight = 1e-9;  // of the corners that are nodes of contact

/// Exact for products of two shape functions on undistorted elements, with the radius of axisymmetric sections.
fem::QuadratureRule rule_of(mesh::CellType type) {
  using enum mesh::CellType;
  if (mesh::dimension(type) == 1) return fem::gauss_line(mesh::order(type) + 2);
  switch (mesh::linear_type(type)) {
    case tri3:
      return fem::triangle(2 * mesh::order(type) + 1);
    case quad4:
      return fem::gauss_quadrilateral(mesh::order(type) + 1);
    case tet4:
      return fem::tetrahedron(mesh::order(type) == 1 ? 2 : 4);
    case wedge6:
      return fem::wedge(2 * mesh::order(type), mesh::order(type) + 1);
    default:
      return fem::gauss_hexahedron(mesh::order(type) + 1);
  }
}

/// Shape functions of a type at the points of its rule.
struct Table {
  explicit Table(mesh::CellType type) : element(fem::reference_element(type)), rule(rule_of(type)) {
    for (Index q = 0; q < rule.size(); ++q) {
      const Vector3 xi = rule.points.row(q).transpose();
      element.shape(xi, shapes.emplace_back(element.n_nodes()));
      element.gradient(xi, gradients.emplace_back(element.n_nodes(), 3));
    }
    rows.resize(rule.size(), element.n_nodes());
    reference.resize(3 * rule.size(), element.n_nodes());
    for (Index q = 0; q < rule.size(); ++q) {
      rows.row(q) = shapes[static_cast<std::size_t>(q)].transpose();
      reference.middleRows<3>(3 * q) = gradients[static_cast<std::size_t>(q)].transpose();
    }
    rows_turned = rows.transpose();
    reference_turned = reference.transpose();
  }
  static const Table& of(mesh::CellType type) {
    static std::map<mesh::CellType, Table> all;
    return all.try_emplace(type, type).first->second;
  }

  const fem::ReferenceElement& element;
  fem::QuadratureRule rule;
  std::vector<Eigen::VectorXd> shapes;
  std::vector<Eigen::MatrixX3d> gradients;
  Eigen::MatrixXd rows;       ///< the shapes, one row per point
  Eigen::MatrixXd reference;  ///< the gradients, three rows per point
  Eigen::MatrixXd rows_turned, reference_turned;
};

Eigen::Matrix3Xd coordinates(const mesh::Mesh& mesh, std::span<const std::int64_t> nodes) {
  Eigen::Matrix3Xd x(3, nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) x.col(static_cast<Index>(i)) = mesh.nodes[nodes[i]];
  return x;
}

/// The part of a cell, or of a face, that belongs to a point of its rule.
double size_at(const mesh::Mesh& mesh, mesh::CellType type, const Table& table, const Eigen::Matrix3Xd& x,
               std::size_t q) {
  const double size = mesh.is_bulk(type) ? std::abs(fem::jacobian(table.element, x, table.gradients[q]).determinant())
                                         : fem::area_vector(table.element, x, table.gradients[q]).norm();
  return table.rule.weights[static_cast<Index>(q)] * mesh.section.depth(x * table.shapes[q]) * size;
}

Arguments arguments(const Vector3& x, double t, double T) {
  return {.x = x[0], .y = x[1], .z = x[2], .t = t, .T = T};
}

std::vector<int> unknowns(std::span<const std::int64_t> nodes, const std::vector<int>& unknown_of) {
  std::vector<int> result;
  for (const std::int64_t node : nodes) result.push_back(unknown_of[node]);
  return result;
}

constexpr int most_nodes = 27, most_points = 27;  // of a cell, for arrays without allocation
template <int Rows>
using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, Rows, 1>;
template <int Rows>
using OfNodes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Rows, most_nodes>;

/// A cell of a body: conduction and capacity. Gradients are those in the reference cell, which all share.
class Cell final : public Patch {
 public:
  Cell(const Conductor& body, mesh::CellType type, std::span<const std::int64_t> cell, double time_unit)
      : body_(body), table_(Table::of(type)), time_unit_(time_unit) {
    const Eigen::Matrix3Xd x = coordinates(*body.mesh, cell);
    const mesh::Section& section = body.mesh->section;
    for (Index q = 0; q < table_.rule.size(); ++q) {
      Point& point = points_.emplace_back();
      const Matrix3 J = fem::jacobian(table_.element, x, table_.gradients[static_cast<std::size_t>(q)]);
      point.to_place = J.inverse().transpose();
      if (section.dimension() == 2) point.to_place.row(2).setZero();
      const Vector3 place = x * table_.shapes[static_cast<std::size_t>(q)];
      point.weight = table_.rule.weights[q] * std::abs(J.determinant()) * section.depth(place);
      if (body.axes && body.conductivity.size() == 3) axes_.push_back(body.axes->at(place));
    }
  }

  void evaluate(const Moment& at, const Eigen::VectorXd& T, const Eigen::VectorXd& rate, Eigen::VectorXd& residual,
                Eigen::MatrixXd* matrix) const override {
    const Column<most_points> at_points = table_.rows * T, rates = table_.rows * rate;
    const Column<3 * most_points> gradient = table_.reference * T;
    thread_local Eigen::VectorXd fluxes, heats;
    fluxes.resize(gradient.size());
    heats.resize(rates.size());
    for (Index q = 0; q < rates.size(); ++q) {
      const Point& point = points_[static_cast<std::size_t>(q)];
      const Vector3 here = point.to_place * gradient.segment<3>(3 * q);
      fluxes.segment<3>(3 * q) =
          point.to_place.transpose() * (point.weight * times_conductivity(q, at_points[q], here));
      heats[q] = rates[q] == 0 ? 0 : point.weight * capacity(at_points[q]) * rates[q];
    }
    residual.noalias() = table_.reference_turned * fluxes;
    residual.noalias() += table_.rows_turned * heats;
    if (matrix == nullptr) return;
    matrix->setZero(T.size(), T.size());
    if (at.conduction != 0) add_conduction(at.conduction, at_points, *matrix);
    if (at.capacity != 0) add_capacities(at.capacity, at_points, *matrix);
  }

  bool capacities(const Eigen::VectorXd& T, Eigen::MatrixXd& matrix) const override {
    matrix.setZero(T.size(), T.size());
    add_capacities(1, table_.rows * T, matrix);
    return true;
  }

 private:
  struct Point {
    Matrix3 to_place;  ///< from gradients in the reference cell
    double weight = 0;
  };

  double checked(double conductivity, double T) const {
    if (conductivity >= 0 && std::isfinite(conductivity)) return conductivity;
    throw ModelError(fmt::format("the conductivity of body '{}' is {:.6g} at T = {:.6g}; it must not be negative",
                                 body_.name, conductivity, T));
  }
  double capacity(double T) const { return body_.density * body_.capacity({.T = T}) / time_unit_; }
  Vector3 times_conductivity(Index point, double T, const Vector3& gradient) const {
    const std::vector<Function>& along = body_.conductivity;
    if (along.size() == 1) return checked(along.front()({.T = T}), T) * gradient;
    const Vector3 own(checked(along[0]({.T = T}), T), checked(along[1]({.T = T}), T), checked(along[2]({.T = T}), T));
    if (axes_.empty()) return own.cwiseProduct(gradient);
    const Matrix3& axes = axes_[static_cast<std::size_t>(point)];
    return axes * own.cwiseProduct(axes.transpose() * gradient);
  }
  /// @param T  at the points
  void add_conduction(double factor, const Column<most_points>& T, Eigen::MatrixXd& matrix) const {
    OfNodes<3 * most_points> fluxes(table_.reference.rows(), matrix.cols());
    for (Index q = 0; q < T.size(); ++q) {
      const Point& point = points_[static_cast<std::size_t>(q)];
      Matrix3 k;
      for (int i = 0; i < 3; ++i) k.col(i) = times_conductivity(q, T[q], point.to_place.col(i));
      k = factor * point.weight * point.to_place.transpose() * k;
      fluxes.middleRows<3>(3 * q).noalias() = k * table_.reference.middleRows<3>(3 * q);
    }
    matrix.noalias() += table_.reference_turned * fluxes;
  }
  void add_capacities(double factor, const Column<most_points>& T, Eigen::MatrixXd& matrix) const {
    OfNodes<most_points> weighted(T.size(), matrix.cols());
    for (Index q = 0; q < T.size(); ++q)
      weighted.row(q) = factor * points_[static_cast<std::size_t>(q)].weight * capacity(T[q]) * table_.rows.row(q);
    matrix.noalias() += table_.rows_turned * weighted;
  }

  const Conductor& body_;
  const Table& table_;
  double time_unit_;
  std::vector<Point> points_;
  std::vector<Matrix3> axes_;  // of orthotropic bodies, at the points
};

/// A film, a flux or radiation on a face; or a flux that is a source, per volume of a cell.
class Inflow final : public Patch {
 public:
  Inflow(std::string name, SurfaceFlow::Kind kind, Function factor, Function beyond, double absolute_zero,
         const mesh::Mesh& mesh, mesh::CellType type, std::span<const std::int64_t> nodes)
      : name_(std::move(name)),
        kind_(kind),
        factor_(std::move(factor)),
        beyond_(std::move(beyond)),
        absolute_zero_(absolute_zero),
        table_(Table::of(type)) {
    const Eigen::Matrix3Xd x = coordinates(mesh, nodes);
    for (std::size_t q = 0; q < table_.shapes.size(); ++q) {
      places_.emplace_back(x * table_.shapes[q]);
      sizes_.push_back(size_at(mesh, type, table_, x, q));
    }
  }

  void evaluate(const Moment& at, const Eigen::VectorXd& T, const Eigen::VectorXd& /*rate*/, Eigen::VectorXd& residual,
                Eigen::MatrixXd* matrix) const override {
    using Kind = SurfaceFlow::Kind;
    residual.setZero(T.size());
    if (matrix != nullptr) matrix->setZero(T.size(), T.size());
    for (std::size_t q = 0; q < places_.size(); ++q) {
      const Eigen::VectorXd& N = table_.shapes[q];
      const double own = N.dot(T);
      const Arguments here = arguments(places_[q], at.t, own);
      const double factor = factor_(here);
      if (!std::isfinite(factor) || (factor < 0 && kind_ != Kind::flux)) refuse(factor, here);
      if (kind_ == Kind::flux) {
        residual.noalias() -= sizes_[q] * factor * N;
        continue;
      }
      const double beyond = beyond_(here);
      if (!std::isfinite(beyond)) refuse(beyond, here);
      double inwards = factor * (beyond - own), slope = factor;
      if (kind_ == Kind::radiation) {
        const double a = beyond - absolute_zero_, b = own - absolute_zero_;
        inwards = factor * (a * a * a * a - b * b * b * b);
        slope = 4 * factor * std::abs(b * b * b);
      }
      residual.noalias() -= sizes_[q] * inwards * N;
      if (matrix != nullptr) matrix->noalias() += at.conduction * sizes_[q] * slope * N * N.transpose();
    }
  }

 private:
  [[noreturn]] void refuse(double value, const Arguments& at) const {
    throw ModelError(
        fmt::format("the {}: one of its values is {:.6g} at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g}, T = {:.6g}; "
                    "coefficients must not be negative, emissivities between 0 and 1, and all of it finite",
                    name_, value, at.x, at.y, at.z, at.t, at.T));
  }

  std::string name_;
  SurfaceFlow::Kind kind_;
  Function factor_, beyond_;
  double absolute_zero_;
  const Table& table_;
  std::vector<Vector3> places_;
  std::vector<double> sizes_;  // area or volume
};

/// Heat that flows into a node.
class PointInflow final : public Patch {
 public:
  PointInflow(const PointFlow& flow, const Vector3& place) : flow_(flow), place_(place) {}

  void evaluate(const Moment& at, const Eigen::VectorXd& T, const Eigen::VectorXd& /*rate*/, Eigen::VectorXd& residual,
                Eigen::MatrixXd* matrix) const override {
    residual.setConstant(T.size(), -flow_.value({.x = place_[0], .y = place_[1], .z = place_[2], .t = at.t}));
    if (matrix != nullptr) matrix->setZero(T.size(), T.size());
  }

 private:
  const PointFlow& flow_;
  Vector3 place_;
};

/// Two faces that see each other. The nodes are those of the first, then those of the second.
class InterfaceFaces final : public Patch {
 public:
  InterfaceFaces(const Interface& interface, const contact::FacingFaces& faces, const Conductor& first,
                 const Conductor& second)
      : interface_(interface), faces_(faces), first_(first), second_(second) {}

  void evaluate(const Moment& at, const Eigen::VectorXd& T, const Eigen::VectorXd& /*rate*/, Eigen::VectorXd& residual,
                Eigen::MatrixXd* matrix) const override {
    residual.setZero(T.size());
    if (matrix != nullptr) matrix->setZero(T.size(), T.size());
    const auto n_first = static_cast<Index>(faces_.first_nodes.size());
    Eigen::VectorXd jump(T.size());
    for (const contact::FacingFaces::Point& point : faces_.points) {
      jump << point.first, -point.second;
      const double mean = (point.first.dot(T.head(n_first)) + point.second.dot(T.tail(T.size() - n_first))) / 2;
      const double h = point.area * conductance(interface_, faces_, point, {&first_, &second_}, at, mean);
      residual.noalias() += h * jump.dot(T) * jump;
      if (matrix != nullptr) matrix->noalias() += at.conduction * h * jump * jump.transpose();
    }
  }

 private:
  const Interface& interface_;
  const contact::FacingFaces& faces_;
  const Conductor &first_, &second_;
};

/// @param make  the patch of a cell: of its type and nodes
template <typename Make>
Patches patches_of_cells(const Conductor& body, const std::vector<int>& unknown_of, const Make& make) {
  Patches result;
  for (const mesh::CellBlock& block : body.mesh->blocks) {
    if (!body.mesh->is_bulk(block.type)) continue;
    for (std::size_t c = 0; c < block.size(); ++c) {
      result.push_back(make(block.type, block.cell(c)));
      result.back()->nodes = unknowns(block.cell(c), unknown_of);
    }
  }
  return result;
}

}  // namespace

double size_of(const mesh::Mesh& mesh, mesh::CellType type, std::span<const std::int64_t> nodes) {
  const Table& table = Table::of(type);
  const Eigen::Matrix3Xd x = coordinates(mesh, nodes);
  double sum = 0;
  for (std::size_t q = 0; q < table.shapes.size(); ++q) sum += size_at(mesh, type, table, x, q);
  return sum;
}

Matrix3 conductivity(const Conductor& body, double T, const Vector3& place) {
  const std::vector<Function>& along = body.conductivity;
  if (along.size() == 1) return along.front()({.T = T}) * Matrix3::Identity();
  Matrix3 own = Vector3(along[0]({.T = T}), along[1]({.T = T}), along[2]({.T = T})).asDiagonal();
  if (!body.axes) return own;
  const Matrix3 axes = body.axes->at(place);
  return axes * own * axes.transpose();
}

double conductance(const Interface& interface, const contact::FacingFaces& faces,
                   const contact::FacingFaces::Point& point, const std::array<const Conductor*, 2>& bodies,
                   const Moment& at, double T) {
  Arguments here = arguments(point.position, at.t, T);
  if (interface.is_perfect) {
    double k = 0;
    for (const Conductor* body : bodies)
      for (const Function& one : body->conductivity) k = std::max(k, one(here));
    return perfect * k / faces.size;
  }
  const bool depends_on_contact = interface.conductance.depends_on_contact() && !interface.contact_nodes.empty();
  if (depends_on_contact && !at.contact.pressure.empty()) {
    double sum = 0, p = 0, gap = 0;
    for (Index i = 0; i < point.hats.size(); ++i) {
      const int node =
          interface.contact_nodes[static_cast<std::size_t>(faces.first_nodes[static_cast<std::size_t>(i)])];
      if (node < 0) continue;
      sum += point.hats[i];
      p += point.hats[i] * at.contact.pressure[static_cast<std::size_t>(node)];
      gap += point.hats[i] * at.contact.gap[static_cast<std::size_t>(node)];
    }
    if (!(sum > least_weight)) return 0;
    here.p = std::max(0.0, p / sum);
    here.gap = std::max(0.0, gap / sum);
  }
  double h = 0;
  if (const double p = here.p; !depends_on_contact || p >= interface.linear_below) {
    h = interface.conductance(here);
  } else {
    here.p = 0;
    const double at_zero = interface.conductance(here);
    here.p = interface.linear_below;
    h = at_zero + (interface.conductance(here) - at_zero) * p / interface.linear_below;
    here.p = p;
  }
  if (h >= 0 && std::isfinite(h)) return h;
  throw ModelError(
      fmt::format("contact '{}': the conductance is {:.6g} at p = {:.6g}, gap = {:.6g}, T = {:.6g}, t = {:.6g}; it "
                  "must be a number that is not negative",
                  interface.name, h, here.p, here.gap, here.T, here.t));
}

Patches cell_patches(const Conductor& body, const std::vector<int>& unknown_of, double time_unit) {
  return patches_of_cells(body, unknown_of, [&](mesh::CellType type, std::span<const std::int64_t> cell) {
    return std::make_unique<Cell>(body, type, cell, time_unit);
  });
}

Patches source_patches(const Source& source, const Conductor& body, const std::vector<int>& unknown_of) {
  return patches_of_cells(body, unknown_of, [&](mesh::CellType type, std::span<const std::int64_t> cell) {
    return std::make_unique<Inflow>(source.name, SurfaceFlow::Kind::flux, source.value, 0.0, 0.0, *body.mesh, type,
                                    cell);
  });
}

Patches flow_patches(const SurfaceFlow& flow, const Conductor& body, const std::vector<int>& unknown_of,
                     double absolute_zero) {
  Patches result;
  for (const mesh::Face& face : flow.faces) {
    result.push_back(std::make_unique<Inflow>(flow.name, flow.kind, flow.factor, flow.beyond, absolute_zero, *body.mesh,
                                              face.type, face.nodes));
    result.back()->nodes = unknowns(face.nodes, unknown_of);
  }
  return result;
}

Patches point_patches(const PointFlow& flow, const Definition& definition, const UnknownOf& unknown_of) {
  std::map<int, Vector3> places;  // by unknown
  for (const BodyNode& node : flow.nodes)
    places.try_emplace(unknown_of[node.body][static_cast<std::size_t>(node.node)],
                       definition.bodies[node.body].mesh->nodes[static_cast<std::size_t>(node.node)]);
  Patches result;
  for (const auto& [unknown, place] : places) {
    result.push_back(std::make_unique<PointInflow>(flow, place));
    result.back()->nodes = {unknown};
  }
  return result;
}

Patches interface_patches(const Interface& interface, const Definition& definition, const UnknownOf& unknown_of) {
  Patches result;
  for (const contact::FacingFaces& faces : interface.faces) {
    result.push_back(std::make_unique<InterfaceFaces>(interface, faces, definition.bodies[interface.first],
                                                      definition.bodies[interface.second]));
    result.back()->nodes = unknowns(faces.first_nodes, unknown_of[interface.first]);
    const std::vector<int> second = unknowns(faces.second_nodes, unknown_of[interface.second]);
    result.back()->nodes.insert(result.back()->nodes.end(), second.begin(), second.end());
  }
  return result;
}

}  // namespace creepcontact::heat
