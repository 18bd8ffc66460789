#include "creepcontact/contact/geometry/mortar.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <span>

#include "contact_geometry.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;
using HatMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;
using HatVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;

constexpr double min_cover_of_dual_facet = 1e-3;  // below it the dual hats would oscillate wildly: standard ones
constexpr double min_cover_of_row = 0.1;          // of a multiplier's area

/// Sums of one slave facet before its dual hats are known: rows are standard hats.
struct FacetSums {
  HatMatrix mass;      // integral hat_i hat_j over the covered part
  HatVector integral;  // integral hat_i over the covered part
};

/// Plates of different thickness touch over the smaller one.
Strip common_strip(const Surface& slave, const Surface& master) {
  Strip strip = strip_of(*slave.mesh, slave.faces);
  strip.section.thickness = std::min(strip.section.thickness, master.mesh->section.thickness);
  return strip;
}

class Assembler {
 public:
  Assembler(const Surface& slave, const Surface& master, ContactType type,
            std::span<const mechanics::RigidMotion> sliding)
      : type_(type),
        slave_facets_(make_facets(*slave.mesh, slave.faces, common_strip(slave, master))),
        master_facets_(make_facets(*master.mesh, master.faces, common_strip(slave, master))),
        normals_(surface_normals(slave_facets_, *slave.constraints)),
        segmentation_(slave_facets_, master_facets_),
        geometry_(slave_facets_, normals_, master_facets_, surface_normals(master_facets_, *master.constraints),
                  sliding) {
    covered_.assign(normals_.multipliers.size(), 0.0);
    full_.assign(normals_.multipliers.size(), 0.0);
    geometric_.setZero(normals_.multipliers.size());
  }

  void integrate() {
    for (std::size_t f = 0; f < slave_facets_.size(); ++f) {
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
      for (int i = 0; i < facet.n_corners(); ++i) full_[multiplier(f, i)] += area * hats[i];
    }
  }

  void add_facet(std::size_t f, const std::vector<Segment>& segments);
  void add_gap(std::size_t f, const HatVector& weighted, const ContactPoint& point);
  HatMatrix dual_transformation(std::size_t f, const std::vector<Segment>& segments) const;

  static HatVector hat_values(const Facet& facet, const Vector3& xi) {
    HatVector hats(facet.n_corners());
    facet.corner_element().shape(xi, hats);
    return hats;
  }
  std::size_t multiplier(std::size_t f, int corner) const { return normals_.multiplier_of_corner[f][corner]; }

  ContactType type_;
  std::vector<Facet> slave_facets_, master_facets_;
  SurfaceNormals normals_;
  Segmentation segmentation_;
  ContactGeometry geometry_;
  std::vector<double> covered_, full_;  // area of each multiplier: the covered part, and all
  // Rows are multipliers; columns node components along the normal (unilateral), or nodes (tied).
  Triplets slave_, master_, gap_;
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
  return HatMatrix(sums.mass.ldlt().solve(HatMatrix(sums.integral.asDiagonal()))).transpose();
}

/// Integral of hats times shape functions (times the normal) over one segment.
class Products {
 public:
  Products(const Facet& side, double sign, ContactType type, int n_hats)
      : side_(side), sign_(sign), width_(type == ContactType::tied ? 1 : 3), shape_(side.n_nodes()) {
    sums_.setZero(n_hats, Index{width_} * side.n_nodes());
  }

  void add(const Vector3& xi, const HatVector& weighted_hats, const Vector3& normal) {
    side_.element().shape(xi, shape_);
    for (int j = 0; j < side_.n_nodes(); ++j)
      for (int a = 0; a < width_; ++a)
        sums_.col(width_ * j + a) += (sign_ * shape_[j] * (width_ == 1 ? 1.0 : normal[a])) * weighted_hats;
  }

  void emit(std::span<const int> rows, Triplets& triplets) const {
    for (int i = 0; i < sums_.rows(); ++i)
      for (int j = 0; j < side_.n_nodes(); ++j)
        for (int a = 0; a < width_; ++a)
          triplets.emplace_back(rows[i], width_ * static_cast<int>(side_.nodes()[j]) + a, sums_(i, width_ * j + a));
  }

 private:
  const Facet& side_;
  double sign_;
  int width_;
  ShapeValues shape_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 27> sums_;
};

void Assembler::add_facet(std::size_t f, const std::vector<Segment>& segments) {
  const Facet& facet = slave_facets_[f];
  const std::span<const int> rows = normals_.multiplier_of_corner[f];
  const HatMatrix dual = dual_transformation(f, segments);
  Products on_slave(facet, -1.0, type_, facet.n_corners());
  for (const Segment& segment : segments) {
    const Facet& master = master_facets_[segment.master];
    Products on_master(master, 1.0, type_, facet.n_corners());
    for (const ContactPoint& point : geometry_.points(f, segment)) {
      const HatVector weighted = point.weight * (dual * hat_values(facet, point.slave_xi));
      on_slave.add(point.slave_xi, weighted, point.normal);
      on_master.add(point.master_xi, weighted, point.normal);
      add_gap(f, weighted, point);
    }
    on_master.emit(rows, master_);
  }
  on_slave.emit(rows, slave_);
}

void Assembler::add_gap(std::size_t f, const HatVector& weighted, const ContactPoint& point) {
  const std::span<const int> rows = normals_.multiplier_of_corner[f];
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

/// Rows that are hardly covered are added to the nearest kept row: dropping them breaks the patch test by 2-5 %. The
/// kept row shares a facet with them (forces must not wander); where there is none, the best covered row is kept.
class Gathering {
 public:
  Gathering(const SurfaceNormals& normals, const std::vector<Vector3>& nodes, const std::vector<double>& covered,
            const std::vector<double>& full)
      : neighbours_(covered.size()), target_(covered.size(), -1) {
    for (const std::vector<int>& corners : normals.multiplier_of_corner)
      for (const int i : corners) neighbours_[i].insert(neighbours_[i].end(), corners.begin(), corners.end());
    const auto part = [&](int i) { return covered[i] / full[i]; };
    for (int i = 0; i < std::ssize(covered); ++i)
      if (covered[i] > 0) order_.push_back(i);
    std::stable_sort(order_.begin(), order_.end(), [&](int i, int j) { return part(i) > part(j); });
    const auto position = [&](int i) { return nodes[normals.multipliers[i].node]; };
    for (const int i : order_) {
      target_[i] = i;
      if (part(i) >= min_cover_of_row) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (const int k : neighbours_[i]) {
        const double distance = (position(k) - position(i)).norm();
        if (k == i || target_[k] != k || distance >= nearest) continue;
        nearest = distance;
        target_[i] = k;
      }
    }
    for (std::size_t i = 0; i < target_.size(); ++i)
      if (target_[i] == static_cast<int>(i)) kept_.push_back(target_[i]);
  }

  const std::vector<int>& kept() const { return kept_; }
  /// kept rows x all rows
  RowMatrix matrix() const {
    Triplets entries;
    for (const int i : order_) {
      const auto position = std::lower_bound(kept_.begin(), kept_.end(), target_[i]) - kept_.begin();
      entries.emplace_back(static_cast<int>(position), i, 1.0);
    }
    RowMatrix gather(kept_.size(), target_.size());
    gather.setFromTriplets(entries.begin(), entries.end());
    return gather;
  }

 private:
  std::vector<std::vector<int>> neighbours_;  // share a facet
  std::vector<int> target_;                   // the row that each is added to; itself if kept, -1 if not covered
  std::vector<int> order_, kept_;
};

RowMatrix sparse(Index rows, Index columns, const Triplets& entries) {
  RowMatrix matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// One row per multiplier and one column per node -> three rows per multiplier (x, y, z), three columns per node.
RowMatrix by_component(const RowMatrix& plain) {
  Triplets entries;
  for (int r = 0; r < plain.outerSize(); ++r)
    for (RowMatrix::InnerIterator it(plain, r); it; ++it)
      for (int a = 0; a < 3; ++a) entries.emplace_back(3 * r + a, 3 * static_cast<int>(it.col()) + a, it.value());
  return sparse(3 * plain.rows(), 3 * plain.cols(), entries);
}

MortarCoupling Assembler::coupling(const Surface& slave, const Surface& master) const {
  const Gathering gathering(normals_, slave.mesh->nodes, covered_, full_);
  const std::vector<int>& kept = gathering.kept();
  const RowMatrix gather = gathering.matrix();
  if (kept.empty())
    throw ModelError(
        fmt::format("contact between '{}' and '{}': the surfaces do not face each other anywhere; check "
                    "the groups and the distance between them",
                    slave.name, master.name));
  const Index n = covered_.size();
  const Index n_slave = slave.mesh->nodes.size();
  const Index n_master = master.mesh->nodes.size();

  MortarCoupling result;
  result.type = type_;
  const Eigen::VectorXd areas = gather * Eigen::Map<const Eigen::VectorXd>(covered_.data(), n);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    result.nodes.push_back(normals_.multipliers[kept[k]]);
    result.area.push_back(areas[k]);
  }
  result.gap_points = gap_points_;
  result.gap_distances = gap_distances_;
  result.gap_weights = gather * sparse(n, gap_points_.size(), gap_);
  const int width = type_ == ContactType::tied ? 1 : 3;
  result.slave_rows = gather * sparse(n, width * n_slave, slave_);
  result.master_rows = gather * sparse(n, width * n_master, master_);
  result.geometric_gap = gather * geometric_;
  if (type_ == ContactType::tied) {
    result.slave_rows = by_component(result.slave_rows);
    result.master_rows = by_component(result.master_rows);
    result.geometric_gap = Eigen::VectorXd::Zero(result.slave_rows.rows());
  }
  return result;
}

}  // namespace

Eigen::VectorXd MortarCoupling::given_gap(const Function& gap, double t) const {
  if (type == ContactType::tied) return Eigen::VectorXd::Zero(n_rows());
  if (!gap.depends_on_position()) return gap({.t = t}) * Eigen::Map<const Eigen::VectorXd>(area.data(), n_rows());
  Eigen::VectorXd values(gap_points.size());
  for (std::size_t p = 0; p < gap_points.size(); ++p) {
    const Vector3& x = gap_points[p];
    values[p] = gap({.x = x.x(), .y = x.y(), .z = x.z(), .t = t});
  }
  return gap_weights * values;
}

MortarCoupling mortar_coupling(const Surface& slave, const Surface& master, ContactType type,
                               std::span<const mechanics::RigidMotion> sliding) {
  Assembler assembler(slave, master, type, sliding);
  assembler.integrate();
  return assembler.coupling(slave, master);
}

}  // namespace creepcontact::contact
