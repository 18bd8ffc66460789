#pragma once
/// Settings of contact and of its solvers: the defaults are declared here and nowhere else.

#include "creepcontact/settings/enum_names.hpp"

namespace creepcontact::settings {

enum class ContactType { unilateral, tied };
constexpr auto names_of(ContactType) {
  return std::to_array<EnumName<ContactType>>({{"unilateral", ContactType::unilateral}, {"tied", ContactType::tied}});
}

enum class ContactMethod { schwarz, active_set };
constexpr auto names_of(ContactMethod) {
  return std::to_array<EnumName<ContactMethod>>(
      {{"schwarz", ContactMethod::schwarz}, {"active_set", ContactMethod::active_set}});
}

/// Acceleration of the Schwarz iteration. cg: conjugate gradients preconditioned by a half-sweep.
enum class Acceleration { none, aitken, anderson, cg };
constexpr auto names_of(Acceleration) {
  return std::to_array<EnumName<Acceleration>>({{"none", Acceleration::none},
                                                {"aitken", Acceleration::aitken},
                                                {"anderson", Acceleration::anderson},
                                                {"cg", Acceleration::cg}});
}

/// Solution of contact with friction.
enum class FrictionMethod { newton, tresca };
constexpr auto names_of(FrictionMethod) {
  return std::to_array<EnumName<FrictionMethod>>(
      {{"newton", FrictionMethod::newton}, {"tresca", FrictionMethod::tresca}});
}

struct ContactSettings {
  ContactMethod method = ContactMethod::schwarz;
  double damping = 1.0;  ///< fraction of each Schwarz sweep that is applied, in (0, 1]
  Acceleration acceleration = Acceleration::cg;
  double tolerance = 1e-10;  ///< error of the multipliers relative to the largest one
  int max_iterations = 200;  ///< on one active set
  FrictionMethod friction = FrictionMethod::newton;
  int initial_substeps = 32;     ///< with friction: proportional steps in which the loads of t = 0 are applied
  double dense_limit_mb = 2000;  ///< memory for the matrices of the contact zones; beyond it they are not formed
};

}  // namespace creepcontact::settings
