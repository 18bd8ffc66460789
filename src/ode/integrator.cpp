#include "creepcontact/ode/integrator.hpp"

namespace creepcontact::ode {

RestartPoint Integrator::save() const {
  return {.time = time(), .next_step = next_step(), .state = {state().begin(), state().end()}, .memory = {}};
}

void Integrator::restore(const RestartPoint& point) {
  initialize(point.time, point.state, point.next_step);
}

}  // namespace creepcontact::ode
