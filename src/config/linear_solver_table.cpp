/// [linear_solver]

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {

Value<settings::StiffnessSettings> linear_solver_table() {
  using settings::StiffnessSettings;
  return table<StiffnessSettings>({
      field<StiffnessSettings>("method", &StiffnessSettings::method, choice<settings::StiffnessMethod>("method"),
                               "factors of the stiffness; or a multigrid, which needs far less memory in large models, "
                               "more time, and creepcontact-mpi; `\"auto\"`: factors if there is memory for them"),
  });
}

}  // namespace creepcontact::config
