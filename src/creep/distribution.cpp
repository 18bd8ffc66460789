#include "creepcontact/creep/distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "creepcontact/base/error.hpp"

namespace creepcontact::creep {
namespace {

using mechanics::Body;

/// What a process cannot compute from its own elements.
void require_separable(const Body& body) {
  for (const auto& law : body.material().creep)
    if (law->uses_mean_stress() && body.discretization().smooths_over_neighbours())
      throw ConfigError(
          fmt::format("body '{}': a law of material '{}' depends on the mean stress, which these elements smooth over "
                      "their neighbours; that is not yet possible on several processes: use one process, or hex20 or "
                      "hex27 elements",
                      body.name(), body.material().name));
}

/// Whose nodal forces this member has: of the nodes, each belongs to the lowest rank that has an element there.
std::vector<char> loaded_nodes(const Body& body, std::span<const std::int32_t> rank_of_element, int rank) {
  constexpr std::int32_t none = -1;
  std::vector<std::int32_t> owner(body.mesh().nodes.size(), none);
  for (std::size_t e = 0; e < rank_of_element.size(); ++e)
    for (const std::int64_t node : body.discretization().element_nodes(e))
      if (owner[node] == none || owner[node] > rank_of_element[e]) owner[node] = rank_of_element[e];
  // The axial node belongs to all elements.
  if (body.mesh().axial_node >= 0 && !rank_of_element.empty())
    owner[body.mesh().axial_node] = *std::ranges::min_element(rank_of_element);
  std::vector<char> result;
  result.reserve(owner.size());
  for (const std::int32_t of_node : owner) result.push_back(of_node == rank ? 1 : 0);
  return result;
}

void append_points(const Body& body, std::size_t element, std::vector<std::size_t>& points) {
  const mechanics::Discretization& all = body.discretization();
  for (std::size_t p = all.first_point(element); p < all.first_point(element + 1); ++p) points.push_back(p);
}

}  // namespace

Distribution::Distribution(const Assembly& whole) : whole_(whole), whole_layout_(whole) {}

Distribution::Distribution(const Assembly& whole, const Team& team, const RankOfElement& rank_of_element)
    : whole_(whole), whole_layout_(whole) {
  if (team.size() == 1) return;
  std::vector<Body> parts;
  for (std::size_t b = 0; b < whole.bodies().size(); ++b) {
    const Body& body = whole.bodies()[b];
    require_separable(body);
    std::vector<std::size_t> elements;
    std::vector<std::size_t>& own = own_points_.emplace_back();
    std::vector<std::size_t>& all = all_points_.emplace_back();
    for (int rank = 0; rank < team.size(); ++rank)
      for (std::size_t e = 0; e < rank_of_element[b].size(); ++e) {
        if (rank_of_element[b][e] != rank) continue;
        if (rank == team.rank()) {
          elements.push_back(e);
          append_points(body, e, own);
        }
        if (team.rank() == 0) append_points(body, e, all);
      }
    parts.push_back(body.part(elements, loaded_nodes(body, rank_of_element[b], team.rank())));
  }
  own_.emplace(std::move(parts), whole.pairs(), Assembly::Remake{}, team);
  own_->share_heat(whole);
}

std::vector<double> Distribution::gather_points(std::size_t body, std::size_t width,
                                                std::span<const double> own) const {
  if (!own_) return {own.begin(), own.end()};
  const std::vector<double> by_rank = team().gather(own);
  std::vector<double> result(by_rank.size());
  if (!is_root()) return result;
  const std::vector<std::size_t>& points = all_points_[body];
  for (std::size_t i = 0; i < points.size(); ++i)
    std::copy_n(by_rank.begin() + i * width, width, result.begin() + points[i] * width);
  return result;
}

std::vector<double> Distribution::gather_points(std::size_t body, std::span<const double> own) const {
  if (!own_) return {own.begin(), own.end()};
  const std::size_t n = own_points_[body].size();
  const auto width = static_cast<std::size_t>(team().max(n > 0 ? static_cast<double>(own.size() / n) : 0.0));
  const std::vector<double> none(own.empty() ? n * width : 0);
  return gather_points(body, width, own.empty() ? std::span<const double>(none) : own);
}

std::vector<double> Distribution::own_points(std::size_t body, std::span<const double> whole) const {
  if (!own_) return {whole.begin(), whole.end()};
  std::vector<double> result;
  const std::size_t n = whole_.bodies()[body].discretization().n_points();
  if (n == 0 || whole.size() % n != 0) throw std::invalid_argument("not a whole number of values at each point");
  const std::size_t width = whole.size() / n;
  for (const std::size_t p : own_points_[body])
    result.insert(result.end(), whole.begin() + p * width, whole.begin() + (p + 1) * width);
  return result;
}

std::vector<double> Distribution::gather_states(std::span<const double> own) const {
  if (!own_) return {own.begin(), own.end()};
  const StateLayout layout(*own_);
  const std::size_t n_own_vectors = layout.size() > 0 ? own.size() / layout.size() : 0;
  const auto n_vectors = static_cast<std::size_t>(team().max(static_cast<double>(n_own_vectors)));
  std::vector<double> result;
  for (std::size_t v = 0; v < n_vectors; ++v) {
    for (std::size_t b = 0; b < whole_.bodies().size(); ++b) {
      const auto part =
          layout.size() > 0 ? layout.part(b, own.subspan(v * layout.size(), layout.size())) : std::span<const double>();
      const std::vector<double> of_body = gather_points(b, layout.stride(b), part);
      result.insert(result.end(), of_body.begin(), of_body.end());
    }
    if (layout.n_gaskets() == 0) continue;  // the root has them
    const auto gaskets = layout.gaskets(own.subspan(v * layout.size(), layout.size()));
    result.insert(result.end(), gaskets.begin(), gaskets.end());
  }
  return result;
}

std::vector<double> Distribution::own_states(std::span<const double> whole) const {
  if (!own_) return {whole.begin(), whole.end()};
  std::vector<double> result;
  const std::size_t size = whole_layout_.size();
  if (whole.empty()) return result;
  if (size == 0 || whole.size() % size != 0) throw std::invalid_argument("not a whole number of states");
  for (std::size_t v = 0; v < whole.size() / size; ++v) {
    for (std::size_t b = 0; b < whole_.bodies().size(); ++b) {
      if (whole_layout_.stride(b) == 0) continue;
      const std::vector<double> of_body = own_points(b, whole_layout_.part(b, whole.subspan(v * size, size)));
      result.insert(result.end(), of_body.begin(), of_body.end());
    }
    if (!is_root() || whole_layout_.n_gaskets() == 0) continue;
    const auto gaskets = whole_layout_.gaskets(whole.subspan(v * size, size));
    result.insert(result.end(), gaskets.begin(), gaskets.end());
  }
  return result;
}

const Evaluation& Distribution::gather(const Evaluation& own, const BodyLaws& laws, Evaluation& space) const {
  if (!own_) return own;
  space.y = gather_states(own.y);
  std::vector<std::vector<double>> stress;
  for (std::size_t b = 0; b < whole_.bodies().size(); ++b)
    stress.push_back(gather_points(b, 6, own.equilibrium.bodies[b].stress));
  std::vector<PlasticState> plastic(own.equilibrium.plastic.bodies.size());
  for (std::size_t b = 0; b < plastic.size(); ++b)
    for (const auto values : {&PlasticState::strain, &PlasticState::accumulated, &PlasticState::back})
      plastic[b].*values = gather_points(b, own.equilibrium.plastic.bodies[b].*values);
  together(team(), [&] {
    if (!is_root()) return;
    space.time = own.time;
    std::vector<mechanics::BodyConditions> conditions = std::move(space.equilibrium.conditions);
    space.equilibrium = own.equilibrium;
    space.equilibrium.conditions = std::move(conditions);
    whole_.update(own.equilibrium.time, space.equilibrium.conditions);
    for (std::size_t b = 0; b < stress.size(); ++b) space.equilibrium.bodies[b].stress = std::move(stress[b]);
    space.equilibrium.plastic.bodies = std::move(plastic);
    space.laws.resize(stress.size());
    for (std::size_t b = 0; b < stress.size(); ++b)
      laws.points()[b].update(space.equilibrium.conditions[b], space.laws[b]);
    space.valid = own.valid;
    space.has_tangents = false;
  });
  return space;
}

}  // namespace creepcontact::creep
