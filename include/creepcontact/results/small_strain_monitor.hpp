#pragma once
/// Strains and rotations that the theory of small displacements does not cover.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/mechanics/element_rotation.hpp"

namespace creepcontact::results {

/// Keeps the largest strain and the largest rotation of a run, from 5 % and from 10 degrees on. Calls are collective.
class SmallStrainMonitor {
 public:
  /// @param system  of the own part of the model; must outlive the object
  explicit SmallStrainMonitor(const creep::CreepSystem& system);

  /// Cost: a pass through the points and the elements.
  void observe(double time, const creep::Evaluation& at);

  /// One of the strain and one of the rotation, if they are not small.
  std::vector<std::string> warnings() const;
  /// True of a text of warnings(), of this or of an earlier part of a run.
  static bool is_warning(const std::string& text);
  void save(creep::Memory& memory) const;
  void restore(const creep::Memory& memory);

 private:
  /// The largest value, with its body, place and time.
  struct Largest {
    double value = 0, body = 0, time = 0;
    std::array<double, 3> place{};
    static constexpr auto members = std::tuple{Member{"value", &Largest::value}, Member{"body", &Largest::body},
                                               Member{"time", &Largest::time}, Member{"place", &Largest::place}};
  };
  /// @param place  called where this member has the value
  template <typename Place>
  void take(Largest& largest, double limit, double value, std::size_t body, double time, const Place& place);
  std::string where(const Largest& largest) const;

  const creep::CreepSystem& system_;
  std::vector<mechanics::ElementRotations> rotations_;  // per body
  Largest strain_, rotation_;
  static constexpr auto saved_members =
      std::tuple{Member{"strain", &SmallStrainMonitor::strain_}, Member{"rotation", &SmallStrainMonitor::rotation_}};
};

}  // namespace creepcontact::results
