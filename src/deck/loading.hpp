#pragma once
/// Supports and loads of all steps as courses over the time of one run.

#include <compare>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "course.hpp"
#include "creepcontact/deck/deck.hpp"

namespace creepcontact::deck {

/// Sets and surfaces of a deck as the nodes, elements and faces that they hold.
class Resolver {
 public:
  explicit Resolver(const Deck& deck) : deck_(deck) {}
  /// Returns the nodes of a number or of the name of a set, also "INSTANCE.SET"; none if there is no such set.
  Numbers nodes(const std::string& target) const;
  Numbers elements(const std::string& target) const;

 private:
  const Deck& deck_;
};

struct ElementFace {
  std::int64_t element = 0;
  int face = 0;
  auto operator<=>(const ElementFace&) const = default;  // NOLINT(modernize-use-nullptr): it sees a 0 in the default
};

/// A *DLOAD on elements as a whole.
struct BodyLoad {
  enum class Kind { centrifugal, gravity };
  Kind kind{};
  std::vector<double> geometry;  ///< point and direction of the axis; direction of gravity
  bool operator==(const BodyLoad&) const = default;
};

/// Times between which a support acts; not given: always.
struct Window {
  std::optional<double> from, until;
  bool is_relative = false;                         ///< the displacement counts from what is reached at `from`
  auto operator<=>(const Window&) const = default;  // NOLINT(modernize-use-nullptr): it sees a 0 in the default
};

/// Heat that is exchanged through a face with what is beyond it.
struct Exchange {
  Course factor;  ///< film coefficient or emissivity
  Course beyond;  ///< temperature of the fluid or of the surroundings
};

/// What makes temperatures, in decks that compute them.
struct HeatLoading {
  std::map<std::int64_t, Course> temperatures;  ///< that are given, by node
  std::map<ElementFace, Exchange> films, radiation;
  std::map<ElementFace, Course> fluxes;
  struct Source {
    Numbers elements;
    Course course;
  };
  std::vector<Source> sources;
  std::map<std::int64_t, Course> point_flows;
  double time_of_states = 0;  ///< of the run, that steady states and *STATIC steps take next to transient ones
};

struct Loading {
  double end = 0;
  std::vector<double> step_ends;
  /// Supports by node and direction: 1, 2, 3, and 4, 5, 6 for rotations and moments, which solids do not have. Along
  /// the directions of *TRANSFORM.
  std::map<std::int64_t, std::map<int, Course>> supports;
  std::map<std::int64_t, std::map<int, Course>> forces;
  /// The times of supports, by node and direction, that act in some steps only.
  std::map<std::pair<std::int64_t, int>, std::vector<Window>> windows;
  struct Lock {
    double time = 0;   ///< from which on the node stays where it is
    double force = 0;  ///< on it until then
  };
  std::map<std::int64_t, Lock> locked;  ///< reference nodes of bolts
  std::map<ElementFace, Course> pressures;
  struct Body {
    BodyLoad load;
    Numbers elements;
    Course course;  ///< of omega^2, or of the acceleration
  };
  std::vector<Body> bodies;
  /// Temperatures of the nodes to which a step gives one. The others keep the initial one.
  std::map<std::int64_t, Course> temperatures;
  double initial_temperature = 0;
  /// Initial temperatures that differ from node to node: `temperatures` are then differences from these, and the
  /// initial one is 0. Nodes that are not among them begin at 0.
  std::map<std::int64_t, double> initial_temperatures;
  HeatLoading heat;
};

/// Joins the steps: *STATIC steps and steady states ramp, *VISCO and transient steps begin with their loads. If the
/// deck has steps that take time, the others, in which nothing creeps or warms up, take none or time_of_static_step().
/// @param lockable  reference nodes that FIXED may hold where they are
/// @param impossible  gets what cannot be done; @param left_out  what is not taken into account
Loading join_steps(const Deck& deck, const std::set<std::int64_t>& lockable, std::vector<Note>& impossible,
                   std::vector<Note>& left_out);

}  // namespace creepcontact::deck
