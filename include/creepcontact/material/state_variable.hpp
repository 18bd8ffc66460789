#pragma once
/// Output variables that creep laws have in addition to the creep strain.

#include <limits>
#include <vector>

#include "creepcontact/base/units.hpp"

namespace creepcontact::material {

/// An output variable computed by laws from the state of a point. A law with a variable of its own declares it and
/// names it in its LawInfo; probes, field files and lists follow.
struct StateVariable {
  /// How the values of several such laws of a material are combined.
  enum class OfSeveralLaws { largest, sum };
  const char* name;
  const char* description;
  const char* label;       ///< for axes of plots
  bool is_tensor = false;  ///< six numbers in Mandel order instead of one
  OfSeveralLaws of_several = OfSeveralLaws::largest;
  double minimum = 0, maximum = std::numeric_limits<double>::infinity();  ///< of a scalar; extrapolation stays within
  Dimension dimension = Dimension::none;                                  ///< of the output
  /// True: laws give the reciprocal of the output, which is smooth where the output may be infinite.
  bool is_reciprocal = false;

  int width() const { return is_tensor ? 6 : 1; }
};

inline constexpr StateVariable damage{
    .name = "damage",
    .description = "damage of `kachanov_rabotnov`, `omega` or `hayhurst`, 0 to 1; 0 where there is none",
    .label = "damage",
    .maximum = 1};
inline constexpr StateVariable life_fraction{
    .name = "life_fraction",
    .description = "fraction of the creep life used up, from rupture data; 0 where there are none",
    .label = "life fraction"};
inline constexpr StateVariable fatigue_fraction{
    .name = "fatigue_fraction",
    .description = "fraction of the fatigue life used up by whole cycles, from fatigue data; 0 where there are none",
    .label = "fatigue fraction"};
inline constexpr StateVariable creep_fatigue{
    .name = "creep_fatigue",
    .description =
        "share of the interaction diagram that `life_fraction` and `fatigue_fraction` have used up: 1 on its "
        "line; 0 where there are no fatigue data",
    .label = "creep-fatigue usage"};

/// What Plasticity gives; no creep law does.
inline constexpr StateVariable plastic_strain{.name = "plastic_strain",
                                              .description = "plastic strain of `plasticity`, tensor components",
                                              .label = "plastic strain",
                                              .is_tensor = true};
inline constexpr StateVariable plastic_strain_equivalent{
    .name = "plastic_strain_equivalent",
    .description = "accumulated equivalent plastic strain of `plasticity`",
    .label = "plastic strain (equiv.)"};

inline constexpr StateVariable back_stress{
    .name = "back_stress",
    .description =
        "centre X of the elastic range: sum of the back stresses of `chaboche` or `plasticity`; tensor components; 0 "
        "where there are none",
    .label = "back stress",
    .is_tensor = true,
    .of_several = StateVariable::OfSeveralLaws::sum,
    .dimension = Dimension::stress};
inline constexpr StateVariable yield_stress{.name = "yield_stress",
                                            .description = "yield stress of `plasticity`, with its hardening so far",
                                            .label = "yield stress",
                                            .dimension = Dimension::stress};

/// Laws with rupture give 1/(time to rupture).
inline constexpr StateVariable remaining_life{
    .name = "remaining_life",
    .description =
        "time to rupture if stress and temperature stay as they are, from `kachanov_rabotnov`, `omega` and "
        "rupture data; 1e30 where no life is consumed",
    .label = "remaining life",
    .dimension = Dimension::time,
    .is_reciprocal = true};

/// The state variables of all laws, each once.
const std::vector<const StateVariable*>& state_variables();

}  // namespace creepcontact::material
