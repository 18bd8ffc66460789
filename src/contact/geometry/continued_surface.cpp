#include "continued_surface.hpp"

#include <Eigen/Geometry>

#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {

ContinuedSurface::ContinuedSurface(const Surface& surface) : own_(surface) {
  if (!surface.sector) return;
  for (const mechanics::NodeLinks::Turned& link : surface.constraints->links().turned) {
    if (link.node == link.of) continue;  // on the axis
    link_of_[link.node] = &link;
    follower_of_[link.of] = link.node;
  }
  continued_.emplace();
  continued_->mesh.section = surface.mesh->section;
  continued_->mesh.nodes = surface.mesh->nodes;
  continued_->faces = surface.faces;
  for (std::size_t i = 0; i < surface.mesh->nodes.size(); ++i)
    continued_->nodes.push_back({static_cast<std::int64_t>(i), 0});
  for (const int turns : surface.sector->neighbours()) add_sector(turns);

  std::vector<mechanics::Support> held(3);
  for (std::size_t i = 0; i < continued_->nodes.size(); ++i) {
    const auto& [own, turns] = continued_->nodes[i];
    const Matrix3 axes = surface.sector->turns(turns) * surface.constraints->frame(own);
    for (int k = 0; k < surface.constraints->n_held(own); ++k) {
      held[static_cast<std::size_t>(k)].nodes.push_back(static_cast<std::int64_t>(i));
      held[static_cast<std::size_t>(k)].directions.emplace_back(axes.col(k));
    }
  }
  std::erase_if(held, [](const mechanics::Support& support) { return support.nodes.empty(); });
  continued_->constraints.emplace(continued_->mesh.nodes, held);
}

void ContinuedSurface::add_sector(int turns) {
  for (mesh::Face face : own_.faces) {
    for (std::int64_t& node : face.nodes) node = number({node, turns});
    continued_->faces.push_back(std::move(face));
  }
}

std::int64_t ContinuedSurface::number(Node node) {
  const auto [own, turns] = node;
  const int count = own_.sector->count;
  if (turns == 0) return own;
  if (const auto link = link_of_.find(own); link != link_of_.end()) {
    const int next = (turns + 1) % count;
    if (next == 0 || next == count - 1) return number({link->second->of, next});
  } else if (const auto follower = follower_of_.find(own); follower != follower_of_.end() && turns == 1) {
    return follower->second;
  }
  const auto [place, is_new] = number_of_.try_emplace({turns, own}, std::ssize(continued_->nodes));
  if (is_new) {
    continued_->nodes.push_back(node);
    continued_->mesh.nodes.push_back(own_.sector->turned(own_.mesh->nodes[own], turns));
  }
  return place->second;
}

RowMatrix ContinuedSurface::on_own_nodes(const RowMatrix& rows) const {
  if (!continued_) return rows;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < continued_->nodes.size(); ++i) {
    const auto& [own, turns] = continued_->nodes[i];
    const Matrix3 turned = own_.sector->turns(turns);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        if (turned(a, b) != 0)
          entries.emplace_back(3 * static_cast<int>(i) + a, 3 * static_cast<int>(own) + b, turned(a, b));
  }
  RowMatrix images(rows.cols(), 3 * std::ssize(own_.mesh->nodes));
  images.setFromTriplets(entries.begin(), entries.end());
  return rows * images;
}

std::pair<std::int64_t, Matrix3> ContinuedSurface::own_node(std::int64_t node) const {
  if (!continued_) return {node, Matrix3::Identity()};
  const auto& [own, turns] = continued_->nodes[static_cast<std::size_t>(node)];
  return {own, own_.sector->turns(turns)};
}

const mechanics::NodeLinks::Turned* ContinuedSurface::link_or_null(std::int64_t node) const {
  const auto found = link_of_.find(node);
  return found == link_of_.end() ? nullptr : found->second;
}

}  // namespace creepcontact::contact
