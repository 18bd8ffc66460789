#pragma once
/// Contacts that lose their pressure at the speed of heat, as an unstable joint does, and not at that of creep.

#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "creepcontact/base/memory.hpp"

namespace creepcontact::run {

/// The normal force of one contact over the accepted steps.
class SuddenLoss {
 public:
  struct Loss {
    double time = 0;   ///< at which nothing is left
    double force = 0;  ///< that was left before
    double share = 0;  ///< of the largest force
    double since = 0;  ///< the last time with half of it
    static constexpr auto members = std::tuple{Member{"time", &Loss::time}, Member{"force", &Loss::force},
                                               Member{"share", &Loss::share}, Member{"since", &Loss::since}};
  };

  /// @param heating_time  in which heat comes through the bodies @param load_changes  times, ascending: what is lost
  /// just after one is not called sudden
  SuddenLoss(double heating_time, std::vector<double> load_changes);

  /// Times come in ascending order. @returns the loss, if the contact is lost now
  std::optional<Loss> observe(double time, double force);

  /// What the next steps need to know of those before.
  struct Past {
    struct Entry {
      double time = 0, force = 0;
      static constexpr auto members = std::tuple{Member{"time", &Entry::time}, Member{"force", &Entry::force}};
    };
    std::vector<Entry> entries;  ///< those of the last two windows, and one before
    double largest = 0;
    static constexpr auto members = std::tuple{Member{"entries", &Past::entries}, Member{"largest", &Past::largest}};
  };
  const Past& past() const { return past_; }
  void go_on_from(Past past) { past_ = std::move(past); }

 private:
  double force_at(double time) const;

  double window_;
  std::vector<double> load_changes_;
  Past past_;
};

}  // namespace creepcontact::run
