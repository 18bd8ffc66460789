/// [[equations]]: tied rows between two bodies, or within one.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <compare>
#include <deque>
#include <limits>
#include <map>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/contact/geometry/equation_rows.hpp"
#include "creepcontact/linalg/independent_rows.hpp"
#include "model_links.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

using contact::RowMatrix;

/// Times between which an equation holds, and whether its value counts from what is reached at the first.
struct Window {
  double from = -std::numeric_limits<double>::infinity(), until = std::numeric_limits<double>::infinity();
  bool is_relative = false;
  auto operator<=>(const Window&) const = default;  // NOLINT(modernize-use-nullptr): it sees a 0 in the default
};
constexpr Window always{};

/// An equation, or a support of one node, with its nodes found.
struct Found {
  const Function* value = nullptr;
  const config::Location* location = nullptr;
  std::size_t slave = 0, master = 0;
  contact::LinearEquation equation;
  Window window = always;
};

/// The node of each term in a body. If several bodies share a node, a body that another term needs is preferred.
Found find_nodes(const config::Equation& equation, const Bodies& bodies) {
  std::vector<std::vector<NodeOfBody>> owners;  // by term
  std::vector<std::size_t> chosen;
  const auto is_chosen = [&](const NodeOfBody& at) { return std::ranges::find(chosen, at.body) != chosen.end(); };
  for (const config::Equation::Term& term : equation.terms) {
    const auto& at = owners.emplace_back(nodes_numbered(bodies, term.node));
    if (at.empty()) throw ModelError(fmt::format("no body has the node {} of the mesh file", term.node));
    if (at.size() == 1 && !is_chosen(at.front())) chosen.push_back(at.front().body);
  }
  for (const auto& at : owners)
    if (std::ranges::none_of(at, is_chosen)) chosen.push_back(at.front().body);
  if (chosen.size() > 2)
    throw ModelError(fmt::format("its nodes belong to {} bodies ('{}', '{}', '{}', ...); an equation joins two bodies",
                                 chosen.size(), bodies[chosen[0]].name(), bodies[chosen[1]].name(),
                                 bodies[chosen[2]].name()));
  Found result{&equation.value, &equation.location, chosen.front(), chosen.back(), {}, always};
  for (std::size_t i = 0; i < owners.size(); ++i) {
    const NodeOfBody at = *std::ranges::find_if(owners[i], is_chosen);
    auto& terms = at.body == result.slave ? result.equation.slave : result.equation.master;
    terms.push_back({at.node, vector(equation.terms[i].coefficient)});
  }
  return result;
}

/// A support that acts for a time: one equation per node and direction.
std::vector<Found> find_nodes(const config::Support& support, std::size_t body, const mesh::Mesh& mesh,
                              std::deque<Function>& values) {
  std::vector<Found> result;
  const Window window{support.from.value_or(always.from), support.until.value_or(always.until), support.relative};
  for (const mechanics::Support& made : make_supports(support, mesh)) {
    if (made.value.depends_on_position())
      throw ModelError("a support with 'from' or 'until' has a displacement that is a function of t alone");
    const Function& value = values.emplace_back(made.value);
    for (std::size_t i = 0; i < made.nodes.size(); ++i) {
      const Vector3 direction = made.directions[made.directions.size() == 1 ? 0 : i].normalized();
      result.push_back({&value, &support.on.location, body, body, {{{made.nodes[i], direction}}, {}}, window});
    }
  }
  return result;
}

contact::TiedBody tied(const mechanics::Body& body) {
  return {&body.mesh(), &body.constraints()};
}

class Equations {
 public:
  /// @param found  at least one, all of the same window
  Equations(const config::Config& config, const Bodies& bodies, std::vector<Found> found)
      : config_(config), bodies_(bodies), found_(std::move(found)), window_(found_.front().window) {}

  void append(std::vector<contact::Pair>& pairs, ErrorCollector& errors) {
    const std::vector<std::size_t> kept = independent(errors);
    using Key = std::tuple<std::size_t, std::size_t, std::string>;  // slave, master, value
    std::map<Key, std::vector<std::size_t>> groups;
    for (const std::size_t i : kept) groups[{found_[i].slave, found_[i].master, found_[i].value->text()}].push_back(i);
    for (const auto& [key, members] : groups) {
      const auto& [slave, master, text] = key;
      std::vector<contact::LinearEquation> equations;
      equations.reserve(members.size());
      for (const std::size_t i : members) equations.push_back(found_[i].equation);
      const double area = nodal_area(bodies_[slave]);
      contact::Pair pair;
      pair.name = window_ != always ? fmt::format("supports of '{}' for a time", bodies_[slave].name())
                  : slave == master
                      ? fmt::format("equations within '{}'", bodies_[slave].name())
                      : fmt::format("equations between '{}' and '{}'", bodies_[slave].name(), bodies_[master].name());
      pair.slave_body = slave;
      pair.master_body = master;
      pair.coupling = contact::equation_rows(tied(bodies_[slave]), tied(bodies_[master]), equations, area);
      pair.gap = *found_[members.front()].value;
      pair.from = window_.from;
      pair.until = window_.until;
      pair.is_relative = window_.is_relative;
      pair.gap_per_value = contact::gap_per_value(equations, area);
      pairs.push_back(std::move(pair));
    }
  }

 private:
  /// Without those that follow from supports and other equations.
  std::vector<std::size_t> independent(ErrorCollector& errors) {
    std::vector<Eigen::Triplet<double>> entries;
    std::int64_t first_free = 0;
    full_.assign(bodies_.size(), {});
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      full_[b] = rows_on(b);
      const RowMatrix reduced = bodies_[b].constraints().reduce_rows(full_[b]);
      for (int r = 0; r < reduced.outerSize(); ++r)
        for (RowMatrix::InnerIterator it(reduced, r); it; ++it)
          entries.emplace_back(r, static_cast<int>(first_free + it.col()), it.value());
      first_free += bodies_[b].constraints().n_free();
    }
    RowMatrix all(std::ssize(found_), first_free);
    all.setFromTriplets(entries.begin(), entries.end());
    const linalg::IndependentRows rows = linalg::independent_rows(all);
    require_consistent(rows, errors);
    if (!rows.dependent.empty())
      log::info("{} of {} equations follow from supports and other equations", rows.dependent.size(), found_.size());
    return {rows.independent.begin(), rows.independent.end()};
  }

  RowMatrix rows_on(std::size_t body) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      const auto add = [&](const std::vector<contact::EquationTerm>& terms) {
        for (const contact::EquationTerm& term : terms)
          for (int k = 0; k < 3; ++k)
            entries.emplace_back(static_cast<int>(i), 3 * static_cast<int>(term.node) + k, term.coefficient[k]);
      };
      if (found_[i].slave == body) add(found_[i].equation.slave);
      if (found_[i].master == body) add(found_[i].equation.master);
    }
    RowMatrix matrix(std::ssize(found_), 3 * std::ssize(bodies_[body].mesh().nodes));
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  /// What the free displacements must fulfil: the value less what supports prescribe.
  Eigen::VectorXd right_hand_sides(double t) const {
    Eigen::VectorXd result(std::ssize(found_));
    for (std::size_t i = 0; i < found_.size(); ++i) result[static_cast<Index>(i)] = (*found_[i].value)({.t = t});
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      std::vector<double> prescribed(3 * bodies_[b].mesh().nodes.size());
      if (!bodies_[b].constraints().prescribed(t, prescribed)) continue;
      result -= full_[b] * Eigen::Map<const Eigen::VectorXd>(prescribed.data(), std::ssize(prescribed));
    }
    return result;
  }

  void require_consistent(const linalg::IndependentRows& rows, ErrorCollector& errors) const {
    constexpr double rounding = 1e-8;
    std::set<int> reported;
    for (const double t : config_.time.output) {
      if (t < window_.from || t >= window_.until || window_.is_relative) continue;
      const Eigen::VectorXd values = right_hand_sides(t);
      for (std::size_t i = 0; i < rows.dependent.size(); ++i) {
        double implied = 0, size = std::abs(values[rows.dependent[i]]);
        for (std::size_t j = 0; j < rows.independent.size(); ++j) {
          const double part =
              rows.combination(static_cast<Index>(i), static_cast<Index>(j)) * values[rows.independent[j]];
          implied += part;
          size += std::abs(part);
        }
        const double excess = implied - values[rows.dependent[i]];
        if (std::abs(excess) <= rounding * size || !reported.insert(rows.dependent[i]).second) continue;
        const Found& equation = found_[static_cast<std::size_t>(rows.dependent[i])];
        const double value = (*equation.value)({.t = t});
        errors.collect(*equation.location, [&] {
          throw ModelError(fmt::format(
              "it contradicts supports or other equations: from these the sum is {:.6g} at t = {:.6g}, and not {:.6g}",
              value + excess, t, value));
        });
      }
    }
  }

  const config::Config& config_;
  const Bodies& bodies_;
  std::vector<Found> found_;
  Window window_;
  std::vector<RowMatrix> full_;  // per body: all equations on its displacements
};

}  // namespace

double nodal_area(const mechanics::Body& body) {
  Eigen::AlignedBox3d box;
  for (const Vector3& x : body.mesh().nodes) box.extend(x);
  return std::pow(box.diagonal().norm() / std::cbrt(static_cast<double>(body.mesh().nodes.size())), 2);
}

void append_equations(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
                      const Bodies& bodies, const std::vector<MotionEquation>& motions,
                      std::vector<contact::Pair>& pairs, ErrorCollector& errors) {
  std::map<Window, std::vector<Found>> found;
  std::deque<Function> values;
  for (const config::Equation& equation : config.equations)
    errors.collect(equation.location, [&] { found[always].push_back(find_nodes(equation, bodies)); });
  for (const MotionEquation& motion : motions)
    found[always].push_back({&motion.value, motion.location, motion.slave, motion.master, motion.equation, always});
  for (const config::Support& support : config.supports) {
    if (support.acts_always()) continue;
    errors.collect(support.on.location, [&] {
      for (const std::size_t b : bodies_on(config, whole, meshes, support.on.name, support.body, -1))
        for (Found& one : find_nodes(support, b, meshes[b], values)) found[one.window].push_back(std::move(one));
    });
  }
  if (!errors.empty()) return;
  for (auto& [window, equations] : found) Equations(config, bodies, std::move(equations)).append(pairs, errors);
}

}  // namespace creepcontact::model
