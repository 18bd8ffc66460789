#include "creepcontact/contact/geometry/mortar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <span>

#include "contact_geometry.hpp"
#include "continued_surface.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "node_glue.hpp"
#include "row_directions.hpp"
#include "row_gathering.hpp"

namespace creepcontact::contact {
namespace {

using HatMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;
using HatVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;

constexpr double min_cover_of_row = 0.1;          // of a multiplier's area
constexpr double min_cover_of_dual_facet = 1e-3;  // below it the dual hats would oscillate wildly: standard ones

/// Sums of one slave facet before its dual hats are known: rows are standard hats.
struct FacetSums {
  HatMatrix mass;      // integral hat_i hat_j over the covered part
  HatVector integral;  // integral hat_i over the covered part
};

/// Directions of the rows of the multipliers at the corners of a facet, at one point: per corner the normal there and
/// tangents, if there is friction (unilateral), or three (tied).
using Directions = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 12>;

/// Plates of different thickness touch over the smaller one.
Strip common_strip(const Surface& slave, const Surface& master) {
  Strip strip = strip_of(*slave.mesh, slave.faces);
  strip.section.thickness = std::min(strip.section.thickness, master.mesh->section.thickness);
  return strip;
}

/// The multiplier that acts at a corner of a facet: one of the corner's node, or that of the node which this one
/// follows by cyclic symmetry, turned.
struct Acting {
  int row = 0;
  const mechanics::NodeLinks::Turned* link = nullptr;

  Matrix3 rotation() const { return link != nullptr ? link->rotation : Matrix3::Identity(); }
};

/// Indexed like `normals.multipliers`.
std::vector<Acting> acting_multipliers(const SurfaceNormals& normals, const ContinuedSurface& slave) {
  std::map<std::int64_t, std::vector<int>> of_node;
  const auto n = static_cast<int>(normals.multipliers.size());
  for (int i = 0; i < n; ++i) of_node[normals.multipliers[i].node].push_back(i);
  std::vector<Acting> result;
  for (int i = 0; i < n; ++i) {
    result.push_back({i});
    const MultiplierNode& at = normals.multipliers[i];
    const mechanics::NodeLinks::Turned* link = slave.link_or_null(at.node);
    const auto followed = link != nullptr ? of_node.find(link->of) : of_node.end();
    if (followed == of_node.end()) continue;
    const Vector3 normal = link->rotation.transpose() * at.normal;
    const auto less = [&](int a, int b) {
      return normals.multipliers[a].normal.dot(normal) < normals.multipliers[b].normal.dot(normal);
    };
    result.back() = {*std::ranges::max_element(followed->second, less), link};
  }
  return result;
}

class Assembler {
 public:
  Assembler(const Surface& slave, const Surface& master, ContactType type,
            std::span<const mechanics::RigidMotion> sliding, bool friction, bool glue)
      : slave_(slave),
        master_(master),
        type_(type),
        slave_facets_(make_facets(slave_.mesh(), slave_.faces(), common_strip(slave, master))),
        master_facets_(make_facets(master_.mesh(), master_.faces(), common_strip(slave, master))),
        normals_(surface_normals(slave_facets_, slave_.constraints())),
        acting_(acting_multipliers(normals_, slave_)),
        directions_(type, friction, normals_, slave_, slave),
        segmentation_(slave_facets_, master_facets_),
        geometry_(slave_facets_, normals_, master_facets_, surface_normals(master_facets_, master_.constraints()),
                  sliding) {
    covered_.assign(normals_.multipliers.size(), 0.0);
    full_.assign(normals_.multipliers.size(), 0.0);
    geometric_.setZero(normals_.multipliers.size());
    opposite_.resize(normals_.multipliers.size());
    if (glue) glue_ = NodeGlue({slave, slave_, slave_facets_}, normals_, {master, master_, master_facets_});
  }

  void integrate() {
    for (std::size_t f = 0; f < slave_.n_own_faces(); ++f) {
      if (glue_.holds(f)) continue;
      add_full_area(f);
      const std::vector<Segment> segments = segmentation_.segments(f);
      if (!segments.empty()) add_facet(f, segments);
    }
  }

  /// @throws ModelError if nothing is covered
  MortarCoupling coupling(const Surface& slave, const Surface& master) const;

 private:
  void add_full_area(std::size_t f) {
    const Facet& facet = slave_facets_[f];
    const fem::QuadratureRule& rule = facet.element().rule();
    for (int q = 0; q < rule.size(); ++q) {
      const Vector3 xi = rule.points.row(q).transpose();
      const HatVector hats = hat_values(facet, xi);
      const double area = rule.weights[q] * facet.area_vector(xi).norm() * facet.area_ratio(facet.position(xi));
      for (int i = 0; i < facet.n_corners(); ++i) full_[acting(f, i).row] += area * hats[i];
    }
  }

  void add_facet(std::size_t f, const std::vector<Segment>& segments);
  Matrix3 turned(const Acting& at, const Vector3& normal) const;
  Directions directions(std::size_t f, const ContactPoint& point) const;
  void add_gap(std::size_t f, const HatVector& weighted, const ContactPoint& point);
  HatMatrix dual_transformation(std::size_t f, const std::vector<Segment>& segments) const;
  std::vector<std::vector<RowGathering::Neighbour>> neighbours(const std::vector<char>& joins) const;
  Matrix3 turned_directions(const RowGathering::Neighbour& of, int in) const;
  std::vector<MortarCoupling::Image> images(const std::vector<int>& kept) const;
  std::vector<char> rows_without_effect(const std::vector<int>& kept, const Surface& master) const;

  static HatVector hat_values(const Facet& facet, const Vector3& xi) {
    HatVector hats(facet.n_corners());
    facet.corner_element().shape(xi, hats);
    return hats;
  }
  const Acting& acting(std::size_t f, int corner) const { return acting_[normals_.multiplier_of_corner[f][corner]]; }
  /// Rows of the multipliers that act at the corners of a facet.
  std::vector<int> rows(std::size_t f) const {
    std::vector<int> result;
    for (const int multiplier : normals_.multiplier_of_corner[f]) result.push_back(acting_[multiplier].row);
    return result;
  }

  ContinuedSurface slave_, master_;
  ContactType type_;
  std::vector<Facet> slave_facets_, master_facets_;
  SurfaceNormals normals_;
  std::vector<Acting> acting_;  // by multiplier of normals_
  RowDirections directions_;
  NodeGlue glue_;
  Segmentation segmentation_;
  ContactGeometry geometry_;
  std::vector<double> covered_, full_;           // area of each multiplier: the covered part, and all
  std::vector<std::set<std::size_t>> opposite_;  // master facets, of multipliers that planes of symmetry hold
  // Rows are multipliers (tied: three each), columns the components of the nodes.
  Triplets on_slave_, on_master_, gap_;
  std::vector<Vector3> gap_points_;
  std::vector<double> gap_distances_;
  Eigen::VectorXd geometric_;  // weighted gap as measured from the meshes
};

HatMatrix Assembler::dual_transformation(std::size_t f, const std::vector<Segment>& segments) const {
  const Facet& facet = slave_facets_[f];
  const int n = facet.n_corners();
  FacetSums sums{HatMatrix::Zero(n, n), HatVector::Zero(n)};
  for (const Segment& segment : segments)
    for (const SegmentPoint& point : segment.points) {
      const HatVector hats = hat_values(facet, point.slave_xi);
      sums.mass += point.weight * hats * hats.transpose();
      sums.integral += point.weight * hats;
    }
  if (sums.integral.sum() < min_cover_of_dual_facet * facet.surface_area()) return HatMatrix::Identity(n, n);
  // psi = D M^-1 phi  =>  integral psi_i phi_j = delta_ij integral phi_j
  const Eigen::MatrixXd right = sums.integral.asDiagonal().toDenseMatrix();
  return linalg::solve_positive(sums.mass, right).transpose();
}

/// Integral of hats times shape functions times directions over one segment.
class Products {
 public:
  Products(const Facet& side, double sign, int n_rows) : side_(side), sign_(sign), shape_(side.n_nodes()) {
    sums_.setZero(n_rows, Index{3} * side.n_nodes());
  }

  /// @param directions  one per row @param weights  of the rows
  void add(const Vector3& xi, const Directions& directions, const Eigen::Ref<const Eigen::VectorXd>& weights) {
    side_.element().shape(xi, shape_);
    const Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 12, 3> weighted =
        sign_ * weights.asDiagonal() * directions.transpose();
    for (int j = 0; j < side_.n_nodes(); ++j) sums_.middleCols<3>(Index{3} * j) += shape_[j] * weighted;
  }

  /// @param rows  of the corners @param width  rows per corner
  void emit(std::span<const int> rows, int width, Triplets& triplets) const {
    for (int i = 0; i < sums_.rows(); ++i)
      for (int j = 0; j < side_.n_nodes(); ++j)
        for (int a = 0; a < 3; ++a)
          if (const double value = sums_(i, Index{3} * j + a); value != 0)
            triplets.emplace_back(width * rows[i / width] + i % width, 3 * static_cast<int>(side_.nodes()[j]) + a,
                                  value);
  }

 private:
  const Facet& side_;
  double sign_;
  ShapeValues shape_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 12, 27> sums_;
};

/// The rotation that takes one unit vector to another one by the shortest way; exactly none where they are the same.
Matrix3 rotation(const Vector3& from, const Vector3& to) {
  constexpr double direction_tolerance = 1e-12;
  if ((to - from).norm() < direction_tolerance) return Matrix3::Identity();
  // Not by Eigen's Quaternion, whose FromTwoVectors takes ten seconds to compile.
  const double cosine = from.dot(to);
  if (cosine < -1 + direction_tolerance) {  // opposite: half a turn about any normal
    const Vector3 axis = from.unitOrthogonal();
    return 2 * axis * axis.transpose() - Matrix3::Identity();
  }
  const Vector3 sine = from.cross(to), shared = sine / (1 + cosine);
  Matrix3 result = shared * sine.transpose();
  for (Index i = 0; i < 3; ++i) {
    const Index j = (i + 1) % 3, k = (i + 2) % 3;
    result(i, i) += cosine;
    result(k, j) += sine[i];
    result(j, k) -= sine[i];
  }
  return result;
}

void Assembler::add_facet(std::size_t f, const std::vector<Segment>& segments) {
  const Facet& facet = slave_facets_[f];
  const std::vector<int> rows = this->rows(f);
  const HatMatrix dual = dual_transformation(f, segments);
  const int width = directions_.width(), n_rows = width * facet.n_corners();
  for (const int row : rows)
    if (directions_.is_any_held(row))
      for (const Segment& segment : segments) opposite_[static_cast<std::size_t>(row)].insert(segment.master);
  Products on_slave(facet, -1.0, n_rows);
  for (const Segment& segment : segments) {
    const Facet& master = master_facets_[segment.master];
    Products on_master(master, 1.0, n_rows);
    for (const ContactPoint& point : geometry_.points(f, segment)) {
      const HatVector weighted = point.weight * (dual * hat_values(facet, point.slave_xi));
      Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 12, 1> weights(n_rows);
      for (int i = 0; i < n_rows; ++i) weights[i] = weighted[i / width];
      const Directions directions = this->directions(f, point);
      on_slave.add(point.slave_xi, directions, weights);
      on_master.add(point.master_xi, directions, weights);
      add_gap(f, weighted, point);
    }
    on_master.emit(rows, width, on_master_);
  }
  on_slave.emit(rows, width, on_slave_);
}

/// The rotation from the directions of a multiplier at its node to those at a point with this normal.
Matrix3 Assembler::turned(const Acting& at, const Vector3& normal) const {
  const Vector3& own = normals_.multipliers[at.row].normal;
  if (at.link == nullptr) return rotation(own, normal);
  return rotation(at.link->rotation * own, normal) * at.link->rotation;
}

/// A multiplier turns with the normal on its way from its node: a traction that is constant along a curved surface is
/// then transmitted as exactly as on a flat one.
Directions Assembler::directions(std::size_t f, const ContactPoint& point) const {
  const int n = slave_facets_[f].n_corners(), width = directions_.width();
  Directions result(3, width * n);
  for (int i = 0; i < n; ++i) {
    const Acting& at = acting(f, i);
    if (type_ == ContactType::tied) {
      result.middleCols<3>(Index{3} * i) = turned(at, point.normal) * directions_.axes(at.row);
      continue;
    }
    result.col(Index{width} * i) = point.normal;
    if (width == 1) continue;
    const Matrix3 turn = turned(at, point.normal);
    for (int k = 1; k < width; ++k) result.col(Index{width} * i + k) = turn * directions_.axes(at.row).col(k);
  }
  return result;
}

void Assembler::add_gap(std::size_t f, const HatVector& weighted, const ContactPoint& point) {
  const std::vector<int> rows = this->rows(f);
  const auto column = static_cast<int>(gap_points_.size());
  gap_points_.push_back(slave_facets_[f].in_section(point.on_slave));
  gap_distances_.push_back(point.gap);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double weight = weighted[i];
    covered_[rows[i]] += weight;
    geometric_[rows[i]] += weight * point.gap;
    gap_.emplace_back(rows[i], column, weight);
  }
}

std::vector<std::vector<RowGathering::Neighbour>> Assembler::neighbours(const std::vector<char>& joins) const {
  std::vector<std::vector<RowGathering::Neighbour>> result(covered_.size());
  for (std::size_t f = 0; f < slave_.n_own_faces(); ++f) {
    const Facet& facet = slave_facets_[f];
    for (int i = 0; i < facet.n_corners(); ++i)
      for (int j = 0; j < facet.n_corners(); ++j) {
        const Acting &own = acting(f, i), &other = acting(f, j);
        if (joins[own.row] == 0) continue;
        result[own.row].push_back({other.row, (facet.node_position(j) - facet.node_position(i)).norm(),
                                   own.rotation().transpose() * other.rotation()});
      }
  }
  return result;
}

/// The directions of one multiplier in those of another, as they arrive there: entry (a, b) is direction a of `of`
/// times direction b of `in`.
Matrix3 Assembler::turned_directions(const RowGathering::Neighbour& of, int in) const {
  if (of.row == in) return Matrix3::Identity();
  const Matrix3 &axes_of = directions_.axes(of.row), &axes_in = directions_.axes(in);
  if (type_ == ContactType::tied) return axes_of.transpose() * of.turned.transpose() * axes_in;
  Matrix3 result = Matrix3::Identity();
  if (directions_.width() == 1) return result;
  const Matrix3 turned =
      rotation(of.turned * normals_.multipliers[of.row].normal, normals_.multipliers[in].normal) * of.turned;
  for (int a = 1; a < directions_.width(); ++a)
    for (int b = 1; b < directions_.width(); ++b) result(a, b) = axes_in.col(b).dot(turned * axes_of.col(a));
  return result;
}

std::vector<MortarCoupling::Image> Assembler::images(const std::vector<int>& kept) const {
  std::set<int> on_own_faces;
  for (std::size_t f = 0; f < slave_.n_own_faces(); ++f)
    on_own_faces.insert(normals_.multiplier_of_corner[f].begin(), normals_.multiplier_of_corner[f].end());
  std::vector<MortarCoupling::Image> result;
  for (const int i : on_own_faces) {
    const auto of = std::ranges::lower_bound(kept, acting_[i].row);
    if (acting_[i].link == nullptr || of == kept.end() || *of != acting_[i].row) continue;
    result.push_back({normals_.multipliers[i], static_cast<std::size_t>(of - kept.begin())});
  }
  return result;
}

/// Marks the rows along directions in which planes of symmetry hold both bodies (PlaneHolding).
std::vector<char> Assembler::rows_without_effect(const std::vector<int>& kept, const Surface& master) const {
  const auto width = static_cast<std::size_t>(directions_.width());
  std::vector<char> result(width * kept.size(), 0);
  if (!directions_.holding()) return result;
  const PlaneHolding master_holding(master);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    std::vector<const Facet*> facets;
    for (const std::size_t m : opposite_[static_cast<std::size_t>(kept[i])]) facets.push_back(&master_facets_[m]);
    for (std::size_t k = 0; k < width; ++k) {
      const auto direction = static_cast<int>(k);
      if (directions_.is_held(kept[i], direction) &&
          holds_both(*directions_.holding(), normals_.multipliers[static_cast<std::size_t>(kept[i])].node,
                     directions_.axes(kept[i]).col(direction), master_holding, master_, facets))
        result[width * i + k] = 1;
    }
  }
  return result;
}

MortarCoupling Assembler::coupling(const Surface& slave, const Surface& master) const {
  std::vector<double> parts(covered_.size());
  std::vector<char> joins(covered_.size()), drops(covered_.size());
  for (std::size_t i = 0; i < covered_.size(); ++i) {
    if (covered_[i] > 0) parts[i] = covered_[i] / full_[i];
    drops[i] = glue_.ties(normals_.multipliers[i].node);
    joins[i] = drops[i] != 0 || parts[i] < min_cover_of_row ||
               std::ranges::binary_search(slave.joining, normals_.multipliers[i].node);
  }
  const RowGathering gathering(neighbours(joins), parts, joins, drops);
  const std::vector<int>& kept = gathering.kept();
  const RowMatrix gather = gathering.matrix(1, [](const auto&, int) { return Matrix3(Matrix3::Identity()); });
  if (kept.empty() && glue_.empty())
    throw ModelError(
        fmt::format("contact between '{}' and '{}': the surfaces do not face each other anywhere; check "
                    "the groups and the distance between them",
                    slave.name, master.name));
  const Index n = covered_.size();
  const Index n_slave = slave_.mesh().nodes.size();
  const Index n_master = master_.mesh().nodes.size();

  MortarCoupling result;
  result.type = type_;
  const Eigen::VectorXd areas = gather * Eigen::Map<const Eigen::VectorXd>(covered_.data(), n);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    result.nodes.push_back(normals_.multipliers[kept[k]]);
    result.area.push_back(areas[k]);
    const Matrix3& axes = directions_.axes(kept[k]);
    if (type_ == ContactType::tied)
      result.axes.push_back(axes);
    else if (directions_.width() > 1)
      result.tangents.push_back({axes.col(1), axes.col(2)});
  }
  if (std::ranges::all_of(result.axes, [](const Matrix3& axes) { return axes == Matrix3::Identity(); }))
    result.axes.clear();
  result.images = images(kept);
  result.sector = slave.sector;
  result.gap_points = gap_points_;
  result.gap_distances = gap_distances_;
  result.gap_weights = gather * sparse(n, gap_points_.size(), gap_);
  const int width = directions_.width();
  const RowMatrix gather_rows =
      gathering.matrix(width, [&](const RowGathering::Neighbour& of, int in) { return turned_directions(of, in); });
  const std::vector<char> without_effect = rows_without_effect(kept, master);
  result.slave_rows = slave_.on_own_nodes(gather_rows * sparse(width * n, 3 * n_slave, on_slave_));
  result.master_rows = master_.on_own_nodes(gather_rows * sparse(width * n, 3 * n_master, on_master_));
  for (RowMatrix* rows : {&result.slave_rows, &result.master_rows})
    rows->prune([&](Index row, Index, double) { return without_effect[static_cast<std::size_t>(row)] == 0; });
  result.geometric_gap = result.on_rows(gather * geometric_);
  glue_.append_to(result);
  return result;
}

}  // namespace

MortarCoupling mortar_coupling(const Surface& slave, const Surface& master, ContactType type,
                               std::span<const mechanics::RigidMotion> sliding, bool friction) {
  Assembler assembler(slave, master, type, sliding, friction, false);
  assembler.integrate();
  return assembler.coupling(slave, master);
}

MortarCoupling tied_coupling(const Surface& slave, const Surface& master) {
  Assembler assembler(slave, master, ContactType::tied, {}, false, true);
  assembler.integrate();
  return assembler.coupling(slave, master);
}

}  // namespace creepcontact::contact
