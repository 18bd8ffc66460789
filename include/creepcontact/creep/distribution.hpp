#pragma once
/// A model whose elements are spread over the processes of a team. Each process has the whole assembly, with all nodes,
/// constraints, loads and contacts; integrates the states of its own elements; and holds its part of the factors.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/body_laws.hpp"

namespace creepcontact::creep {

/// The member of the team that has each element, per body. All members have equal lists.
using RankOfElement = std::vector<std::vector<std::int32_t>>;

/// In a team of one nothing is spread: the own part is the whole. Immutable.
class Distribution {
 public:
  /// @param whole, team  must outlive the object
  /// @throws ConfigError naming what cannot be spread
  Distribution(const Assembly& whole, const Team& team, const RankOfElement& rank_of_element);
  /// The distribution of a team of one: the whole.
  explicit Distribution(const Assembly& whole);

  const Team& team() const { return own().team(); }
  const Assembly& whole() const { return whole_; }
  /// The bodies with the elements of this member (Body::part), and all contacts.
  const Assembly& own() const { return own_ ? *own_ : whole_; }
  /// True in the process that has what is gathered, and writes results.
  bool is_root() const { return team().rank() == 0; }

  /// Values at the points of all members, in the order of the whole body; empty but on member 0. Collective.
  /// @param own  n_points x width of the own part
  std::vector<double> gather_points(std::size_t body, std::size_t width, std::span<const double> own) const;
  /// gather_points() where some members may have no values: theirs are zero.
  std::vector<double> gather_points(std::size_t body, std::span<const double> own) const;
  /// The own part of such values. @param whole  on all members
  std::vector<double> own_points(std::size_t body, std::span<const double> whole) const;
  /// gather_points() for vectors like the state y, one or several in turn.
  std::vector<double> gather_states(std::span<const double> own) const;
  /// The own part of such vectors. @param whole  on all members
  std::vector<double> own_states(std::span<const double> whole) const;

  /// The evaluation of the whole assembly; meaningful on member 0 alone. Collective.
  /// @param laws  of the whole assembly @param space  for the result @returns `own` itself in a team of one
  const Evaluation& gather(const Evaluation& own, const BodyLaws& laws, Evaluation& space) const;

 private:
  const Assembly& whole_;
  std::optional<Assembly> own_;
  StateLayout whole_layout_;
  std::vector<std::vector<std::size_t>> own_points_;  // per body, numbered as in the whole one
  std::vector<std::vector<std::size_t>> all_points_;  // those of all members in turn; on member 0
};

}  // namespace creepcontact::creep
