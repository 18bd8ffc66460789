#pragma once
/// The main results of a run in a few numbers: contact forces and von Mises stresses at the start, at their largest and
/// at the end, and the contacts that opened.

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/results/step_values.hpp"

namespace creepcontact::results {

/// The largest von Mises stress relative to the yield strength at its temperature; nullopt without a yield strength.
/// @param stress  n_points x 6
std::optional<double> largest_yield_share(const mechanics::Body& body, const mechanics::BodyConditions& at,
                                          const std::vector<double>& stress);

/// Start and end are those of output times; extremes and openings are those of all states that it sees.
class Outcome {
 public:
  /// @param assembly  must outlive the object
  explicit Outcome(const creep::Assembly& assembly);

  /// The numbers of a state that count here. @param assembly  with the bodies of `at`, which may be those of a part
  /// @param team  the processes that share them; collective
  static StepValues values(const creep::Assembly& assembly, double time, const creep::Equilibrium& at,
                           const Team& team);

  /// An output time; they come in increasing order.
  void output(double time, const creep::Equilibrium& at);
  /// A state between output times. Does nothing before the first output.
  void observe(const StepValues& values);
  /// Warns once per contact that has slid by more than an element, and keeps the width of contact zones.
  void observe_closure(double time, const creep::Equilibrium& at, std::size_t p);
  void observe_contacts(double time, const creep::Equilibrium& at);

  /// What to say of contacts that few elements resolve where they carry most, and that are open at the last output:
  /// their state there says nothing of it. Found within a tenth of the largest force.
  std::vector<std::string> narrow_contacts() const;
  /// Time of the last output; 0 before the first one.
  double last_output() const { return last_output_; }
  /// Warns at the end of a run of unilateral contacts that never carried a force.
  void warn_of_open_contacts() const;

  /// Normal forces of unilateral and preloaded contacts, largest von Mises stress of each body (at integration points).
  /// What is round-off is 0 there. @param cycle  length of the cycles of the loads, if they have any
  void fill(io::Summary& summary, std::optional<double> cycle) const;
  void save(creep::Memory& memory) const;
  void restore(const creep::Memory& memory);

 private:
  void observe_slip(double time, const creep::Equilibrium& at, std::size_t pair);
  /// Force of a pair below which nothing but rounding is left.
  double no_force(std::size_t pair) const;
  /// Contact forces of one state of the run, in order of time.
  void follow(double time, std::size_t pair, double force);

  /// When a contact carried a force.
  struct Opening {
    double since;    ///< first time of the present state without force; NaN: it carries one, or has never done
    double carried;  ///< last time with a force; NaN: never
    double count;    ///< how often the force was lost
    static constexpr auto members = std::tuple{Member{"since", &Opening::since}, Member{"carried", &Opening::carried},
                                               Member{"count", &Opening::count}};
  };
  /// Width of a contact zone in elements, and when it was taken.
  struct Width {
    double elements, time, force;  ///< elements 0: not known
    static constexpr auto members =
        std::tuple{Member{"elements", &Width::elements}, Member{"time", &Width::time}, Member{"force", &Width::force}};
  };

  const creep::Assembly& assembly_;
  bool started_ = false;
  double last_output_ = 0;
  std::vector<io::Summary::Course> forces_;    // of every contact pair
  std::vector<Width> widths_;                  // likewise
  std::vector<Opening> openings_;              // likewise
  std::vector<double> rounding_;               // likewise: force that the round-off of the bodies may make
  std::vector<io::Summary::Course> stresses_;  // of every body
  std::vector<io::Summary::Course> shares_;    // likewise: largest_yield_share()
  std::vector<StepValues::Flow> flow_;         // likewise; empty if nothing may yield
  std::vector<double> moduli_;                 // likewise: Young's modulus
  std::vector<double> dissipated_, slip_;      // of every contact pair at the last output; NaN: no friction
  std::vector<double> interference_;           // likewise; NaN: no preload
  std::vector<char> slid_far_;                 // by pair: warned of
  std::vector<char> beyond_;                   // likewise, of a gasket closed beyond its curve
  static constexpr auto saved_members =
      std::tuple{Member{"started", &Outcome::started_},   Member{"last_output", &Outcome::last_output_},
                 Member{"forces", &Outcome::forces_},     Member{"widths", &Outcome::widths_},
                 Member{"openings", &Outcome::openings_}, Member{"stresses", &Outcome::stresses_},
                 Member{"shares", &Outcome::shares_},     Member{"flow", &Outcome::flow_}};
};

}  // namespace creepcontact::results
