#include "creepcontact/contact/condensed_interface.hpp"

namespace creepcontact::contact {

CondensedInterface::CondensedInterface(std::span<const mechanics::Body> bodies, std::span<const Pair> pairs,
                                       const RigidBodyModes& rigid_body_modes, InterfaceRows::Conditions at,
                                       double dense_bytes, const Admission& admit,
                                       const linalg::StiffnessSolverFactory& make_solver, const Team& team)
    : rows_(bodies, pairs, rigid_body_modes),
      flexibility_(bodies, rows_, at, dense_bytes, make_solver, team),
      balance_(rows_, flexibility_.immovable()) {
  if (admit) together(team, [&] { admit(*this, is_dense() ? this->dense_bytes() : 0.0); });
  flexibility_.factorize(at);
}

}  // namespace creepcontact::contact
