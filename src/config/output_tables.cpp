/// [output]

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {

Value<Output> output_table() {
  return table<Output>({
      field<Output>("directory", &Output::directory, path(), "directory of the results")
          .otherwise("`results/<name of the configuration>`"),
      field<Output>("fields", &Output::fields, boolean(), "write `fields.pvd`, `contact.pvd` and their `.vtu` files"),
      field<Output>("revolve", &Output::revolve, integer(3, 360),
                    "axisymmetric models: write the full solid too, of so many segments, as `revolved.pvd`")
          .otherwise("the section alone"),
      field<Output>(
          "unit_names", &Output::unit_names, boolean(),
          "add units to the names of the arrays in the field files, as in `stress [MPa]`, where `units` gives them"),
      field<Output>("checkpoint_seconds", &Output::checkpoint_seconds, number(at_least(0)),
                    "wall time between checkpoints for `--resume`; 0: one after every step")
          .in("seconds"),
  });
}

}  // namespace creepcontact::config
