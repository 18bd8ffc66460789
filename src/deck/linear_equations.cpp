#include "linear_equations.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace creepcontact::deck {
namespace {

/// coefficient . u(node)
struct Term {
  std::int64_t node = 0;
  Vector3 coefficient;
};

class EquationReader {
 public:
  EquationReader(const Deck& deck, const Resolver& resolver, const NodeFrames& frames, std::vector<Note>& impossible)
      : deck_(deck), resolver_(resolver), frames_(frames), impossible_(impossible) {}

  std::vector<DeckEquation> read() {
    for (const RawCard& raw : deck_.cards) {
      if (raw.card.name == "EQUATION") equation(raw);
      if (raw.card.name == "MPC") constraint(raw);
    }
    return std::move(equations_);
  }

 private:
  void refuse(const RawCard& raw, const std::string& why, std::size_t line = 0) {
    impossible_.push_back({line < raw.places.size() ? raw.places[line] : raw.card.place, raw.card.name, why});
  }

  bool exists(std::int64_t node) const { return deck_.node_of_number.contains(node); }
  const Vector3& position(std::int64_t node) const { return deck_.positions[deck_.node_of_number.at(node)]; }

  void add(const RawCard& raw, const std::vector<Term>& terms) {
    DeckEquation equation{{}, {}, raw.card.place, raw.card.name};
    for (const Term& term : terms)
      for (int k = 0; k < 3; ++k)
        if (term.coefficient[k] != 0) equation.terms[{term.node, k}] += term.coefficient[k];
    std::erase_if(equation.terms, [](const auto& term) { return term.second == 0; });
    if (!equation.terms.empty()) equations_.push_back(std::move(equation));
  }

  /// A number of terms, then this many triples of node (or set), degree of freedom and coefficient; and so on.
  void equation(const RawCard& raw) {
    struct SetTerm {
      Numbers nodes;
      int direction = 0;
      double coefficient = 0;
    };
    std::vector<SetTerm> terms;
    std::int64_t expected = 0;
    for (std::size_t line = 0; line < raw.data.size(); ++line) {
      const std::vector<std::string>& fields = raw.data[line];
      if (expected == 0) {
        const auto count = fields.empty() ? std::nullopt : whole_number(fields[0]);
        if (!count || *count < 1) return refuse(raw, "expected the number of terms", line);
        expected = *count;
        continue;
      }
      for (std::size_t i = 0; i < fields.size() && expected > 0; i += 3, --expected) {
        const auto field = [&](std::size_t k) { return i + k < fields.size() ? fields[i + k] : std::string(); };
        const auto direction = whole_number(field(1));
        const auto coefficient = number(field(2));
        SetTerm term{resolver_.nodes(field(0)), 0, coefficient.value_or(0)};
        if (term.nodes.empty()) return refuse(raw, fmt::format("there is no node or set '{}'", field(0)), line);
        if (direction && (*direction == 11 || *direction == 0))
          return refuse(raw, "equations of temperatures (degree of freedom 11) are not known; *TIE of surfaces is",
                        line);
        if (!direction || *direction < 1 || *direction > 3 || !coefficient)
          return refuse(raw, "expected a node, a direction from 1 to 3, and a coefficient", line);
        term.direction = static_cast<int>(*direction);
        terms.push_back(std::move(term));
      }
      if (expected > 0) continue;
      std::size_t n = 1;
      for (const SetTerm& term : terms) n = std::max(n, term.nodes.size());
      if (std::ranges::any_of(terms,
                              [&](const SetTerm& term) { return term.nodes.size() != 1 && term.nodes.size() != n; }))
        return refuse(raw, "sets of different sizes", line);
      for (std::size_t k = 0; k < n; ++k) {
        std::vector<Term> own;
        for (const SetTerm& term : terms) {
          const std::int64_t node = term.nodes[term.nodes.size() == 1 ? 0 : k];
          if (!frames_.has_direction(node, term.direction))
            return refuse(
                raw, fmt::format("node {} is on the axis of its *TRANSFORM, where no direction is radial", node), line);
          own.push_back({node, term.coefficient * frames_.directions(node).col(term.direction - 1)});
        }
        add(raw, own);
      }
      terms.clear();
    }
    if (expected > 0) refuse(raw, "the last equation has fewer terms than it says", raw.places.size() - 1);
  }

  void constraint(const RawCard& raw) {
    std::string type;
    Numbers nodes;
    for (const std::vector<std::string>& line : raw.data)
      for (std::size_t i = 0; i < line.size(); ++i) {
        if (type.empty() && i == 0) {
          type = upper_case(line[0]);
          continue;
        }
        const Numbers found = resolver_.nodes(line[i]);
        if (found.empty()) return refuse(raw, fmt::format("there is no node or set '{}'", line[i]));
        nodes.insert(nodes.end(), found.begin(), found.end());
      }
    if (type == "PLANE") return plane(raw, nodes);
    if (type == "STRAIGHT") return straight(raw, nodes);
    if (type == "TIE" || type == "PIN") return equal(raw, nodes);
    if (type == "MEANROT") return mean_rotation(raw, nodes);
    refuse(raw, fmt::format("{} is not known; PLANE, STRAIGHT, TIE, PIN and MEANROT are, for small displacements",
                            type.empty() ? "a constraint without a type" : type));
  }

  /// The first degree of freedom of the last node is the mean of the angles by which the others turn about their
  /// centre; its position is the direction of the axis (CalculiX, *MPC).
  void mean_rotation(const RawCard& raw, Numbers nodes) {
    constexpr double on_the_axis = 1e-6;  // of the largest distance
    if (nodes.size() < 3) return refuse(raw, "MEANROT: the nodes that turn, and one for their rotation, are needed");
    const std::int64_t pilot = nodes.back();
    nodes.pop_back();
    std::ranges::sort(nodes);  // they are listed once per direction
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    if (position(pilot).isZero(0)) return refuse(raw, "MEANROT: the last node, whose place is the axis, is at zero");
    const Vector3 axis = position(pilot).normalized();
    Vector3 centre = Vector3::Zero();
    for (const std::int64_t node : nodes) centre += position(node) / static_cast<double>(nodes.size());
    double largest = 0;
    for (const std::int64_t node : nodes) largest = std::max(largest, (position(node) - centre).norm());
    std::vector<Term> terms;
    for (const std::int64_t node : nodes) {
      const Vector3 from_centre = position(node) - centre, arm = from_centre - axis * axis.dot(from_centre);
      if (arm.norm() > on_the_axis * largest) terms.push_back({node, axis.cross(arm) / arm.squaredNorm()});
    }
    if (terms.empty()) return refuse(raw, "MEANROT: all nodes are on the axis");
    terms.push_back({pilot, -static_cast<double>(terms.size()) * Vector3::UnitX()});
    add(raw, terms);
  }

  /// Along its normal a plane moves by a linear function of the position, which three nodes give that are not on a
  /// line.
  void plane(const RawCard& raw, Numbers nodes) {
    constexpr double on_a_line = 1e-3;  // of the product of the sides
    if (nodes.size() < 4) return;
    const Vector3 &a = position(nodes[0]), &b = position(nodes[1]);
    const auto sine = [&](std::int64_t node) {
      const Vector3 side = position(node) - a;
      return (b - a).cross(side).norm() / std::max((b - a).norm() * side.norm(), 1e-300);
    };
    const auto third =
        std::ranges::find_if(nodes.begin() + 2, nodes.end(), [&](auto node) { return sine(node) > on_a_line; });
    if (third == nodes.end()) return refuse(raw, "its nodes are on a line");
    std::iter_swap(nodes.begin() + 2, third);
    const Vector3& c = position(nodes[2]);
    const Vector3 area = (b - a).cross(c - a), normal = area.normalized();
    for (std::size_t i = 3; i < nodes.size(); ++i) {
      const Vector3& x = position(nodes[i]);
      const double of_b = (x - a).cross(c - a).dot(area) / area.squaredNorm();
      const double of_c = (b - a).cross(x - a).dot(area) / area.squaredNorm();
      add(raw, {{nodes[i], normal},
                {nodes[0], -(1 - of_b - of_c) * normal},
                {nodes[1], -of_b * normal},
                {nodes[2], -of_c * normal}});
    }
  }

  /// Across its direction a line moves by a linear function of the position, which the first two nodes give.
  void straight(const RawCard& raw, const Numbers& nodes) {
    if (nodes.size() < 3) return;
    const Vector3 &a = position(nodes[0]), &b = position(nodes[1]);
    if (a == b) return refuse(raw, "the first two nodes are at one place");
    const Vector3 along = (b - a).normalized(), first = along.unitOrthogonal();
    for (std::size_t i = 2; i < nodes.size(); ++i) {
      const double part = (position(nodes[i]) - a).dot(along) / (b - a).norm();
      const Vector3 second = along.cross(first);
      for (const Vector3& across : {first, second})
        add(raw, {{nodes[i], across}, {nodes[0], -(1 - part) * across}, {nodes[1], -part * across}});
    }
  }

  void equal(const RawCard& raw, const Numbers& nodes) {
    for (std::size_t i = 1; i < nodes.size(); ++i)
      for (int k = 0; k < 3; ++k)
        add(raw, {{nodes[i], Vector3(Vector3::Unit(k))}, {nodes[0], -Vector3(Vector3::Unit(k))}});
  }

  const Deck& deck_;
  const Resolver& resolver_;
  const NodeFrames& frames_;
  std::vector<Note>& impossible_;
  std::vector<DeckEquation> equations_;
};

using Unknown = std::pair<std::int64_t, int>;

/// Returns the value that is prescribed at a node without elements, if there is one.
const Course* prescribed(const Loading& loading, const Unknown& unknown) {
  const auto node = loading.supports.find(unknown.first);
  if (node == loading.supports.end()) return nullptr;
  const auto found = node->second.find(unknown.second + 1);
  return found == node->second.end() ? nullptr : &found->second;
}

/// equation += factor * other
void add_multiple(DeckEquation& equation, const DeckEquation& other, double factor) {
  constexpr double rounding = 1e-12;
  for (const auto& [unknown, coefficient] : other.terms) {
    double& own = equation.terms[unknown];
    const double size = std::abs(own);
    own += factor * coefficient;
    if (std::abs(own) <= rounding * size) equation.terms.erase(unknown);
  }
  equation.value = equation.value.plus(other.value.scaled(factor));
}

}  // namespace

std::vector<DeckEquation> read_equations(const Deck& deck, const Resolver& resolver, const NodeFrames& frames,
                                         std::vector<Note>& impossible) {
  return EquationReader(deck, resolver, frames, impossible).read();
}

void eliminate_reference_nodes(std::vector<DeckEquation>& equations, const Numbers& used, Loading& loading) {
  std::map<Unknown, std::vector<std::size_t>> of_reference;  // equations of unknowns that no element has
  for (std::size_t i = 0; i < equations.size(); ++i)
    for (const auto& [unknown, coefficient] : equations[i].terms)
      if (!std::ranges::binary_search(used, unknown.first)) of_reference[unknown].push_back(i);
  std::set<std::int64_t> nodes;
  std::vector<char> gone(equations.size(), 0);
  for (const auto& [unknown, first_rows] : of_reference) {
    nodes.insert(unknown.first);
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < equations.size(); ++i)
      if (gone[i] == 0 && equations[i].terms.contains(unknown)) rows.push_back(i);
    if (const Course* value = prescribed(loading, unknown)) {
      for (const std::size_t i : rows) {
        const double coefficient = equations[i].terms.at(unknown);
        equations[i].value = equations[i].value.plus(value->scaled(-coefficient));
        equations[i].terms.erase(unknown);
      }
      continue;
    }
    if (rows.empty()) continue;
    const auto shortest = *std::ranges::min_element(rows, {}, [&](std::size_t i) { return equations[i].terms.size(); });
    const DeckEquation pivot = equations[shortest];
    const double coefficient = pivot.terms.at(unknown);
    gone[shortest] = 1;
    for (const std::size_t i : rows)
      if (i != shortest) add_multiple(equations[i], pivot, -equations[i].terms.at(unknown) / coefficient);
    if (const auto node = loading.forces.find(unknown.first); node != loading.forces.end())
      if (const auto force = node->second.find(unknown.second + 1); force != node->second.end()) {
        const Course own = force->second;
        for (const auto& [other, part] : pivot.terms) {
          if (other == unknown) continue;
          Course& at = loading.forces[other.first][other.second + 1];
          at = at.plus(own.scaled(-part / coefficient));
        }
      }
  }
  for (const std::int64_t node : nodes) {
    loading.supports.erase(node);
    loading.forces.erase(node);
  }
  std::size_t next = 0;
  std::erase_if(equations, [&](const DeckEquation& equation) { return gone[next++] != 0 || equation.terms.empty(); });
}

}  // namespace creepcontact::deck
