#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/tangents.hpp"
#include "separable_load.hpp"

namespace creepcontact::mechanics {

namespace {

/// Shape functions and derivatives of a face type at the points of its rule.
struct FaceTable {
  std::vector<Eigen::VectorXd> shapes;
  std::vector<Eigen::MatrixX3d> gradients;
  Eigen::VectorXd weights;
};

FaceTable make_table(mesh::CellType type) {
  const auto& reference = fem::reference_element(type);
  FaceTable table{{}, {}, reference.rule().weights};
  for (Index p = 0; p < table.weights.size(); ++p) {
    const Vector3 xi = reference.rule().points.row(p).transpose();
    reference.shape(xi, table.shapes.emplace_back(reference.n_nodes()));
    reference.gradient(xi, table.gradients.emplace_back(reference.n_nodes(), 3));
  }
  return table;
}

/// Over faces: the field is the inward normal (pressure), or a direction.
class SurfaceIntegral final : public SpatialIntegral {
 public:
  /// @param direction  zero: the inward normal
  SurfaceIntegral(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces, const Vector3& direction)
      : faces_(faces), direction_(direction) {
    for (const mesh::Face& face : faces) nodes_.insert(nodes_.end(), face.nodes.begin(), face.nodes.end());
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    for (const mesh::Face& face : faces) {
      if (!tables_.contains(face.type)) tables_.emplace(face.type, make_table(face.type));
      add_points(mesh, face);
    }
  }

  const std::vector<std::int64_t>& nodes() const override { return nodes_; }

  void add(const Function& f, double t, std::span<double> values) const override {
    for (const Point& point : points_) {
      const Vector3 force = evaluate(f, point.position, t) * point.field;
      for (Index a = 0; a < point.shape->size(); ++a) {
        const std::size_t local = local_nodes_[point.first_node + a];
        Eigen::Map<Vector3>(&values[3 * local]) += (*point.shape)[a] * force;
      }
    }
  }

  std::vector<FieldPoint> points_beyond(const Cut& cut) const override {
    std::vector<FieldPoint> beyond;
    for (const mesh::Face& face : faces_) {
      const Cut::Side side = cut.side(face);
      if (side == Cut::Side::behind) continue;
      const fem::ReferenceElement& element = fem::reference_element(face.type);
      const fem::QuadratureRule rule =
          side == Cut::Side::both ? cut.rule_beyond(face.type, face.nodes) : element.rule();
      Eigen::Matrix3Xd x(3, element.n_nodes());
      for (int a = 0; a < element.n_nodes(); ++a) x.col(a) = cut.mesh().nodes[face.nodes[a]];
      Eigen::VectorXd shape(element.n_nodes());
      Eigen::MatrixX3d gradient(element.n_nodes(), 3);
      for (Index q = 0; q < rule.size(); ++q) {
        const Vector3 xi = rule.points.row(q).transpose();
        element.shape(xi, shape);
        element.gradient(xi, gradient);
        const Vector3 position = x * shape;
        beyond.push_back({position, field(rule.weights[q] * cut.mesh().section.depth(position) *
                                          fem::area_vector(element, x, gradient))});
      }
    }
    return beyond;
  }

 private:
  struct Point {
    Vector3 position;
    Vector3 field;                 // direction times area
    const Eigen::VectorXd* shape;  // owned by tables_
    std::size_t first_node;        // of the face, in local_nodes_
  };

  /// @param area  vector of it, outward
  Vector3 field(const Vector3& area) const {
    return direction_.isZero() ? Vector3(-area) : Vector3(area.norm() * direction_);
  }

  void add_points(const mesh::Mesh& mesh, const mesh::Face& face) {
    const std::size_t first_node = local_nodes_.size();
    Eigen::Matrix3Xd x(3, face.nodes.size());
    for (std::size_t a = 0; a < face.nodes.size(); ++a) {
      x.col(a) = mesh.nodes[face.nodes[a]];
      const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), face.nodes[a]);
      local_nodes_.push_back(found - nodes_.begin());
    }
    const FaceTable& table = tables_.at(face.type);
    for (std::size_t p = 0; p < table.shapes.size(); ++p) {
      const Vector3 position = x * table.shapes[p];
      const Vector3 area = table.weights[p] * mesh.section.depth(position) *
                           fem::area_vector(fem::reference_element(face.type), x, table.gradients[p]);
      points_.push_back({position, field(area), &table.shapes[p], first_node});
    }
  }

  std::vector<mesh::Face> faces_;
  Vector3 direction_;  // zero: the inward normal
  std::vector<std::int64_t> nodes_;
  std::vector<std::size_t> local_nodes_;  // of all faces, one after the other, as positions in nodes_
  std::map<mesh::CellType, FaceTable> tables_;
  std::vector<Point> points_;
};

/// A force at one node along one direction.
class NodalForce final : public SpatialIntegral {
 public:
  NodalForce(const mesh::Mesh& mesh, std::int64_t node, const Vector3& direction)
      : nodes_{node}, position_(mesh.nodes[node]), direction_(direction) {}

  const std::vector<std::int64_t>& nodes() const override { return nodes_; }
  void add(const Function& f, double t, std::span<double> values) const override {
    Eigen::Map<Vector3>(values.data()) += evaluate(f, position_, t) * direction_;
  }
  std::vector<FieldPoint> points_beyond(const Cut& cut) const override {
    if (nodes_[0] == cut.mesh().axial_node) return {};  // along z, in the planes that may cut a section
    return {{position_, cut.node_share(nodes_[0]) * direction_}};
  }

 private:
  std::vector<std::int64_t> nodes_;
  Vector3 position_, direction_;
};

/// Forces at several nodes, a fixed vector each.
class NodalForces final : public SpatialIntegral {
 public:
  NodalForces(std::vector<std::int64_t> nodes, std::vector<Vector3> forces)
      : nodes_(std::move(nodes)), forces_(std::move(forces)) {}
  const std::vector<std::int64_t>& nodes() const override { return nodes_; }
  void add(const Function& f, double t, std::span<double> values) const override {
    const double factor = f({.t = t});
    for (std::size_t i = 0; i < nodes_.size(); ++i) Eigen::Map<Vector3>(&values[3 * i]) += factor * forces_[i];
  }
  std::vector<FieldPoint> points_beyond(const Cut& cut) const override {
    std::vector<FieldPoint> points;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      points.push_back({cut.mesh().nodes[nodes_[i]], cut.node_share(nodes_[i]) * forces_[i]});
    return points;
  }

 private:
  std::vector<std::int64_t> nodes_;
  std::vector<Vector3> forces_;
};

}  // namespace

std::unique_ptr<Load> pressure_load(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces, Function pressure) {
  return std::make_unique<SeparableLoad>(std::make_unique<SurfaceIntegral>(mesh, faces, Vector3::Zero()),
                                         std::move(pressure));
}

std::unique_ptr<Load> traction_load(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces,
                                    std::array<Function, 3> traction) {
  std::vector<std::unique_ptr<Load>> parts;
  for (int i = 0; i < 3; ++i) {
    Function& component = traction[i];
    if (component.is_zero()) continue;
    parts.push_back(std::make_unique<SeparableLoad>(std::make_unique<SurfaceIntegral>(mesh, faces, Vector3::Unit(i)),
                                                    std::move(component)));
  }
  return std::make_unique<SumOfLoads>(std::move(parts));
}

std::unique_ptr<Load> axial_load(const mesh::Mesh& mesh, Function force) {
  const Vector3 per_displacement = mesh.section.thickness / mesh.section.axial_length * Vector3::UnitZ();
  return std::make_unique<SeparableLoad>(std::make_unique<NodalForce>(mesh, mesh.axial_node, per_displacement),
                                         std::move(force));
}

std::unique_ptr<Load> point_load(const mesh::Mesh& mesh, std::int64_t node, std::array<Function, 3> force) {
  std::vector<std::unique_ptr<Load>> parts;
  parts.reserve(3);
  for (int i = 0; i < 3; ++i) {
    parts.push_back(std::make_unique<SeparableLoad>(std::make_unique<NodalForce>(mesh, node, Vector3::Unit(i)),
                                                    std::move(force[i])));
  }
  return std::make_unique<SumOfLoads>(std::move(parts));
}

std::unique_ptr<Load> nodal_load(std::vector<std::int64_t> nodes, std::vector<Vector3> forces, Function factor) {
  return std::make_unique<SeparableLoad>(std::make_unique<NodalForces>(std::move(nodes), std::move(forces)),
                                         std::move(factor));
}

}  // namespace creepcontact::mechanics
