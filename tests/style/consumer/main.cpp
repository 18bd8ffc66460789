// A program of somebody else's on the installed package: exit status 0 if it can use the registries.
#include <creepcontact/material/registry.hpp>
#include <creepcontact/ode/integrator.hpp>

int main() {
  const bool has_law = creepcontact::material::find_creep_law("norton") != nullptr;
  return has_law && !creepcontact::ode::integrators().empty() ? 0 : 1;
}
