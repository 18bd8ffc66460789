#include "warning_order.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace creepcontact::run {
namespace {

struct Phrase {
  std::string_view text;
  int rank;
};

constexpr int of_accuracy = 1;  // of warnings without one of these phrases
/// The first that a warning has decides.
constexpr std::array phrases{
    // The results are those of another model.
    Phrase{"units", 0}, Phrase{"assumes small strain", 0}, Phrase{"carried no load", 0}, Phrase{"used up", 0},
    Phrase{"passed the line of the interaction diagram", 0}, Phrase{"yields under its preload", 0},
    Phrase{"no steady state", 0}, Phrase{"several states", 0}, Phrase{"will oscillate", 0}, Phrase{"overlap by", 0},
    Phrase{"more than an element", 0}, Phrase{"no equilibrium is found", 0}, Phrase{"has no effect", 0},
    Phrase{"left out", 0}, Phrase{"are taken as small", 0},
    // Files and pictures.
    Phrase{"of the interrupted run", 3}, Phrase{"picture", 3}, Phrase{"not kept", 3}, Phrase{"Gmsh", 3},
    // Time.
    Phrase{"iterations per solve", 2}, Phrase{"steps were rejected", 2}, Phrase{"keeps them short", 2},
    Phrase{"iterations of the implicit steps failed", 2}, Phrase{"dense_limit_mb", 2}, Phrase{"needs less", 2},
    Phrase{"BLAS", 2}};

int rank_of(const std::string& warning) {
  const auto found = std::ranges::find_if(
      phrases, [&](const Phrase& phrase) { return warning.find(phrase.text) != std::string::npos; });
  return found == phrases.end() ? of_accuracy : found->rank;
}

}  // namespace

std::vector<std::string> by_consequence(std::vector<std::string> warnings) {
  std::ranges::stable_sort(warnings, {}, rank_of);
  return warnings;
}

}  // namespace creepcontact::run
