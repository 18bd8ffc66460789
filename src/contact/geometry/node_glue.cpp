#include "node_glue.hpp"

#include <algorithm>

#include "creepcontact/base/index.hpp"
#include "creepcontact/mesh/point_tree.hpp"

namespace creepcontact::contact {
namespace {

constexpr double same_place = 1e-5;  // of the size of a facet

Vector3 mean_position(const Facet& facet) {
  Vector3 sum = Vector3::Zero();
  for (int i = 0; i < facet.n_nodes(); ++i) sum += facet.node_position(i);
  return sum / static_cast<double>(facet.n_nodes());
}

/// The node of `other` at the place of each node of `facet`; empty if the facets do not match.
std::vector<std::int64_t> opposite_nodes(const Facet& facet, const Facet& other) {
  std::vector<std::int64_t> result;
  if (&facet.element() != &other.element()) return result;
  if (facet.area_vector_at_centre().dot(other.area_vector_at_centre()) >= 0) return result;
  for (int i = 0; i < facet.n_nodes(); ++i)
    for (int j = 0; j < other.n_nodes(); ++j)
      if ((facet.node_position(i) - other.node_position(j)).norm() <= same_place * facet.diameter()) {
        result.push_back(other.nodes()[static_cast<std::size_t>(j)]);
        break;
      }
  if (std::ssize(result) != facet.n_nodes()) result.clear();
  return result;
}

/// Integrals of the hat functions of the corners over the surface of the body.
std::vector<double> hat_integrals(const Facet& facet) {
  std::vector<double> result(static_cast<std::size_t>(facet.n_corners()), 0.0);
  const fem::QuadratureRule& rule = facet.element().rule();
  ShapeValues hats(facet.n_corners());
  for (int q = 0; q < rule.size(); ++q) {
    const Vector3 xi = rule.points.row(q).transpose();
    facet.corner_element().shape(xi, hats);
    const double area = rule.weights[q] * facet.area_vector(xi).norm() * facet.area_ratio(facet.position(xi));
    for (int i = 0; i < facet.n_corners(); ++i) result[static_cast<std::size_t>(i)] += area * hats[i];
  }
  return result;
}

/// Local corners between which a local node lies; for a corner itself alone.
std::vector<int> corners_of(const Facet& facet, int node) {
  const int n = facet.n_corners();
  if (node < n) return {node};
  if (node < 2 * n) return {node - n, (node - n + 1) % n};
  std::vector<int> all;
  for (int i = 0; i < n; ++i) all.push_back(i);
  return all;
}

/// Positive parts of the area of a facet that its nodes have: of each corner's hat function one half remains there, the
/// rest goes to the nodes next to it.
std::vector<double> node_areas(const Facet& facet, const std::vector<double>& hats) {
  const int n = facet.n_corners();
  std::vector<double> result(static_cast<std::size_t>(facet.n_nodes()), 0.0);
  for (int i = 0; i < facet.n_nodes(); ++i) {
    double share = 1;  // of the hat of each corner around
    if (facet.n_nodes() > n) share = i < n ? 0.5 : i >= 2 * n ? 0.125 : facet.n_nodes() > 2 * n ? 0.1875 : 0.25;
    for (const int corner : corners_of(facet, i))
      result[static_cast<std::size_t>(i)] += share * hats[static_cast<std::size_t>(corner)];
  }
  return result;
}

}  // namespace

NodeGlue::NodeGlue(const Side& slave, const SurfaceNormals& slave_normals, const Side& master) {
  const Masters masters = match(slave, master);
  if (masters.empty()) return;
  number_ties(masters, slave, master);
  for (std::size_t f = 0; f < is_matched_.size(); ++f)
    if (is_matched_[f] != 0) add_facet(f, slave.facets[f], slave_normals);
  for (Tie& tie : ties_) tie.normal.normalize();
  set_axes(slave, master);
}

NodeGlue::Masters NodeGlue::match(const Side& slave, const Side& master) {
  Masters masters;
  std::vector<Vector3> centres;
  for (const Facet& facet : master.facets) centres.push_back(mean_position(facet));
  if (centres.empty()) return masters;
  const mesh::PointTree tree(centres);
  is_matched_.assign(slave.continued.n_own_faces(), 0);
  for (std::size_t f = 0; f < is_matched_.size(); ++f) {
    const Facet& facet = slave.facets[f];
    const mesh::Neighbour nearest = tree.nearest(mean_position(facet), 1).front();
    if (nearest.distance > same_place * facet.diameter()) continue;
    const std::vector<std::int64_t> opposite = opposite_nodes(facet, master.facets[nearest.point]);
    if (opposite.empty()) continue;
    const auto is_other = [&](std::size_t i) {  // where the master is open along a line
      const auto known = masters.find(facet.nodes()[i]);
      return known != masters.end() && known->second != opposite[i];
    };
    bool contradicts = false;
    for (std::size_t i = 0; i < opposite.size(); ++i) contradicts = contradicts || is_other(i);
    if (contradicts) continue;
    is_matched_[f] = 1;
    for (std::size_t i = 0; i < opposite.size(); ++i) masters[facet.nodes()[i]] = opposite[i];
  }
  return masters;
}

void NodeGlue::number_ties(const Masters& masters, const Side& slave, const Side& master) {
  const auto followed = [&](std::int64_t node) -> const mechanics::NodeLinks::Turned* {
    const auto* link = slave.continued.link_or_null(node);
    const auto of = link != nullptr ? masters.find(link->of) : masters.end();
    if (of == masters.end()) return nullptr;
    const auto* opposite = master.continued.link_or_null(masters.at(node));
    return opposite != nullptr && opposite->of == of->second ? link : nullptr;
  };
  for (const auto& [node, opposite] : masters) {
    if (followed(node) != nullptr) continue;
    tied_[node] = {ties_.size(), nullptr};
    const auto [own, rotation] = master.continued.own_node(opposite);
    Tie tie;
    tie.slave = node;
    tie.master = own;
    tie.master_turned = rotation;
    ties_.push_back(tie);
  }
  // Where both sides follow other nodes by cyclic symmetry the tie of those is theirs.
  for (const auto& [node, opposite] : masters)
    if (const auto* link = followed(node)) tied_[node] = {tied_.at(link->of).tie, link};
}

void NodeGlue::add_facet(std::size_t f, const Facet& facet, const SurfaceNormals& normals) {
  const std::vector<double> hat_areas = hat_integrals(facet), areas = node_areas(facet, hat_areas);
  const auto id = [&](int i) { return facet.nodes()[static_cast<std::size_t>(i)]; };
  const int n = facet.n_corners();
  std::map<std::int64_t, std::map<std::int64_t, double>> hats;
  std::vector<std::int64_t> seen;  // in a strip, nodes occur on both layers
  for (int i = 0; i < facet.n_nodes(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Holder& holder = tied_.at(id(i));
    Tie& tie = ties_[holder.tie];
    tie.area += areas[at];
    if (i < n) tie.hat_area += hat_areas[at];
    const Vector3& normal = normals.normal_of_node[f][at];
    if (holder.link == nullptr)
      tie.normal += areas[at] * normal;
    else
      normal_of_follower_[id(i)] = normal;
    if (std::ranges::find(seen, id(i)) != seen.end()) continue;
    seen.push_back(id(i));
    ShapeValues values(n);
    facet.corner_element().shape(facet.element().nodes().row(i).transpose(), values);
    for (int corner = 0; corner < n; ++corner)
      if (values[corner] != 0) hats[id(corner)][id(i)] += values[corner];
    if (i < n) continue;
    std::vector<std::int64_t>& around = corners_around_[id(i)];
    around.clear();
    for (const int corner : corners_of(facet, i)) around.push_back(id(corner));
  }
  for (const auto& [corner, of_nodes] : hats)
    for (const auto& [node, value] : of_nodes) hats_[corner][node] = value;  // the same from all facets at an edge
}

void NodeGlue::set_axes(const Side& slave, const Side& master) {
  for (Tie& tie : ties_) {
    const Matrix3& turned = tie.master_turned;
    tie.free = free_axes(free_part(*slave.surface.constraints, tie.slave) +
                         turned * free_part(*master.surface.constraints, tie.master) * turned.transpose());
    tie.position = slave.surface.mesh->nodes[static_cast<std::size_t>(tie.slave)];
    const Sector* sector = slave.surface.sector ? &*slave.surface.sector : nullptr;
    Vector3 opposite = master.surface.mesh->nodes[static_cast<std::size_t>(tie.master)];
    if (sector != nullptr) opposite = sector->origin + turned * (opposite - sector->origin);
    tie.distance = tie.normal.dot(opposite - tie.position);
  }
}

void NodeGlue::append_to(MortarCoupling& coupling) const {
  if (empty()) return;
  const std::size_t n_mortar = coupling.nodes.size(), n = n_mortar + ties_.size();
  std::vector<Eigen::Triplet<double>> slave_rows, master_rows, tractions, gap_weights;
  const auto add_all = [](const RowMatrix& from, std::vector<Eigen::Triplet<double>>& to) {
    for (int row = 0; row < from.outerSize(); ++row)
      for (RowMatrix::InnerIterator it(from, row); it; ++it)
        to.emplace_back(row, static_cast<int>(it.col()), it.value());
  };
  /// block on three rows and columns
  const auto add_block = [](std::size_t row, std::size_t column, const Matrix3& block,
                            std::vector<Eigen::Triplet<double>>& to) {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        if (block(a, b) != 0)
          to.emplace_back(3 * static_cast<int>(row) + a, 3 * static_cast<int>(column) + b, block(a, b));
  };
  add_all(coupling.slave_rows, slave_rows);
  add_all(coupling.master_rows, master_rows);
  add_all(coupling.gap_weights, gap_weights);
  if (coupling.axes.empty()) coupling.axes.assign(n_mortar, Matrix3::Identity());
  for (std::size_t i = 0; i < n_mortar; ++i) add_block(i, i, coupling.axes[i], tractions);

  for (std::size_t k = 0; k < ties_.size(); ++k) {
    const Tie& tie = ties_[k];
    Matrix3 directions = tie.area * tie.free.axes;
    for (int a = 0; a < 3; ++a)
      if (!tie.free.is_free[static_cast<std::size_t>(a)]) directions.col(a).setZero();
    add_block(n_mortar + k, static_cast<std::size_t>(tie.slave), -directions.transpose(), slave_rows);
    add_block(n_mortar + k, static_cast<std::size_t>(tie.master), directions.transpose() * tie.master_turned,
              master_rows);
    coupling.nodes.push_back({tie.slave, tie.normal});
    coupling.area.push_back(tie.area);
    coupling.axes.push_back(tie.free.axes);
    coupling.ties.push_back({tie.slave, tie.master, tie.area});
    gap_weights.emplace_back(static_cast<int>(n_mortar + k), static_cast<int>(coupling.gap_points.size()), tie.area);
    coupling.gap_points.push_back(tie.position);
    coupling.gap_distances.push_back(tie.distance);
  }

  // Tractions at corners: nodal forces tested with the hat function of the corner, as multipliers of the mortar method
  // are. Those of the nodes between are means.
  using Parts = std::map<std::size_t, Matrix3>;  // factors of the multipliers of ties
  std::vector<Parts> of_tie(ties_.size());
  for (const auto& [corner, of_nodes] : hats_) {
    const Holder& holder = tied_.at(corner);
    for (const auto& [node, value] : of_nodes) {
      const Holder& at = tied_.at(node);
      if (at.link != nullptr) continue;  // the tie of the node that it follows has the force of both
      Matrix3& part = of_tie[holder.tie].try_emplace(at.tie, Matrix3::Zero()).first->second;
      part += value * ties_[at.tie].area / ties_[holder.tie].hat_area * holder.rotation().transpose() *
              ties_[at.tie].free.axes;
    }
  }
  for (const auto& [node, corners] : corners_around_) {
    const Holder& holder = tied_.at(node);
    if (holder.link != nullptr || ties_[holder.tie].hat_area > 0) continue;
    Parts& mean = of_tie[holder.tie];
    for (const std::int64_t corner : corners) {
      const Holder& at = tied_.at(corner);
      for (const auto& [tie, part] : of_tie[at.tie])
        mean.try_emplace(tie, Matrix3::Zero()).first->second +=
            at.rotation() * part / static_cast<double>(corners.size());
    }
  }
  for (std::size_t k = 0; k < ties_.size(); ++k)
    for (const auto& [tie, part] : of_tie[k]) add_block(n_mortar + k, n_mortar + tie, part, tractions);
  for (const auto& [node, holder] : tied_)
    if (holder.link != nullptr)
      coupling.images.push_back({{node, normal_of_follower_.at(node)}, n_mortar + holder.tie});

  const auto matrix = [&](Index rows, Index columns, const std::vector<Eigen::Triplet<double>>& entries) {
    RowMatrix result(rows, columns);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  };
  const Index n_rows = 3 * static_cast<Index>(n);
  coupling.slave_rows = matrix(n_rows, coupling.slave_rows.cols(), slave_rows);
  coupling.master_rows = matrix(n_rows, coupling.master_rows.cols(), master_rows);
  coupling.tractions = matrix(n_rows, n_rows, tractions);
  coupling.gap_weights = matrix(static_cast<Index>(n), std::ssize(coupling.gap_points), gap_weights);
  coupling.geometric_gap = Eigen::VectorXd::Zero(n_rows);
}

}  // namespace creepcontact::contact
