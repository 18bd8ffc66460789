#include "creepcontact/results/contact_width.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/closed_nodes.hpp"

namespace creepcontact::results {
namespace {

constexpr int min_width = 4;             // elements across
constexpr double min_force_share = 0.1;  // of the force: zones that carry less

/// Rows that can be reached from the first ones, each with its distance in steps.
std::vector<std::pair<int, int>> reached(const contact::ContactGrid& grid, const std::vector<int>& first,
                                         std::vector<char>& is_free) {
  std::vector<std::pair<int, int>> rows;
  const auto add = [&](int row, int distance) {
    if (!is_free[row]) return;
    is_free[row] = 0;
    rows.emplace_back(row, distance);
  };
  for (const int row : first) add(row, 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {  // NOLINT(modernize-loop-convert): rows grow within
    const auto [row, distance] = rows[i];
    for (const int other : grid.around(row)) add(other, distance + 1);
  }
  return rows;
}

}  // namespace

std::optional<int> elements_across(const contact::ContactGrid& grid, const Eigen::VectorXd& force_of_row) {
  const auto n_rows = static_cast<int>(grid.positions.size());
  std::vector<char> closed(grid.positions.size());
  for (int row = 0; row < n_rows; ++row) closed[row] = force_of_row[row] > 0 ? 1 : 0;
  const auto is_open = [&](int row) { return closed[row] == 0; };
  const std::vector<char> all_closed = closed;
  const double least = min_force_share * force_of_row.sum();

  std::optional<int> narrowest;
  for (int row = 0; row < n_rows; ++row) {
    if (is_open(row)) continue;
    const std::vector<std::pair<int, int>> zone = reached(grid, {row}, closed);  // which takes it out of `closed`
    double force = 0;
    std::vector<int> edge;
    std::vector<char> in_zone(grid.positions.size());
    for (const auto& [member, distance] : zone) {
      force += force_of_row[member];
      in_zone[member] = 1;
      if (std::ranges::any_of(grid.around(member), [&](int o) { return all_closed[o] == 0; })) edge.push_back(member);
    }
    if (edge.empty() || force < least) continue;
    const int deepest = reached(grid, edge, in_zone).back().second;
    narrowest = std::min(narrowest.value_or(2 * deepest - 1), 2 * deepest - 1);
  }
  return narrowest;
}

std::optional<int> elements_across(const creep::Assembly& assembly, const contact::Pair& pair,
                                   const creep::Equilibrium& at) {
  constexpr double closed_without_force = std::numeric_limits<double>::min();
  const std::vector<char> closed = contact::closed_nodes(pair, at.contact);
  const auto multipliers = at.contact.multiplier.segment(pair.first_row, pair.coupling.n_rows());
  Eigen::VectorXd force = Eigen::VectorXd::Zero(std::ssize(closed));
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (closed[i] != 0)
      force[static_cast<Index>(i)] =
          std::max(closed_without_force, pair.coupling.area[i] * pair.coupling.pressure(i, multipliers));
  const contact::ContactGrid grid(pair, assembly.bodies()[pair.slave_body].mesh());
  return elements_across(grid, grid.of_all(force));
}

std::string narrow_contact_text(const contact::Pair& pair, int width, const std::string& when) {
  if (width >= min_width) return "";
  return fmt::format(
      "contact '{}': {} the contact zone is about {} element{} wide at its narrowest (elements "
      "of the slave surface '{}'), too few for the pressures and stresses near it. Refine '{}' there: at "
      "least {} elements are needed, eight are better",
      pair.name, when, width, width == 1 ? "" : "s", pair.slave_surface, pair.slave_surface, min_width);
}

std::vector<std::string> narrow_contacts(const creep::Assembly& assembly, const creep::Equilibrium& at,
                                         const std::string& when) {
  std::vector<std::string> lines;
  for (const contact::Pair& pair : assembly.pairs()) {
    if (pair.coupling.type == contact::ContactType::tied) continue;
    const std::optional<int> width = elements_across(assembly, pair, at);
    if (!width) continue;
    if (std::string text = narrow_contact_text(pair, *width, when); !text.empty()) lines.push_back(std::move(text));
  }
  return lines;
}

}  // namespace creepcontact::results
