#pragma once
/// The law of Norton and Bailey: creep strain A q^n t^m at constant stress, with time or strain hardening where the
/// stress changes (time_hardening.hpp, strain_hardening.hpp).
/// Sources: F. H. Norton (1929); R. W. Bailey, Proc. Inst. Mech. Eng. 131 (1935).

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {

LawInfo norton_bailey_info();

}  // namespace creepcontact::material
