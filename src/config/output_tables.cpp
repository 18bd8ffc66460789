/// [output]

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

/// `fields`: whether field files are written, and at which times.
struct FieldFiles {
  bool written = true;
  std::optional<std::vector<double>> times;
};

Value<FieldFiles> field_files() {
  const auto either = boolean();
  const auto times = list(converted<double>(number(at_least(0)), [](double time, const Item& item, Context& context) {
    if (context.end > 0 && time > context.end)
      context.errors.add(item.location, fmt::format("number {} is beyond time.end", time),
                         Range{.min = 0, .max = context.end}.describe("times"));
    return std::optional(time);
  }));
  Value<FieldFiles> value{.type = "true, false or a list of times",
                          .read = {},
                          .brief = "`true`, `false` or a list of times",
                          .words = either.words,
                          .json = [=] {
                            return schema_of_any({either.json(), times.json()});
                          }};
  value.read = [=, type = value.type](const Item& item, Context& context) -> std::optional<FieldFiles> {
    if (const auto* written = item.node->as_boolean()) return FieldFiles{written->get(), {}};
    if (!item.node->is_array()) {
      context.errors.add(item.location, describe(*item.node), type);
      return std::nullopt;
    }
    auto found = times.read(item, context);
    if (!found) return std::nullopt;
    std::sort(found->begin(), found->end());
    found->erase(std::unique(found->begin(), found->end()), found->end());
    const bool any = !found->empty();
    return FieldFiles{any, std::move(*found)};
  };
  value.visit = [=](const FieldFiles& files, Visitor& to) {
    if (files.times) return times.visit(*files.times, to);
    either.visit(files.written, to);
  };
  return value;
}

enum class Separator { comma, semicolon, tab };
constexpr auto names_of(Separator) {
  return std::to_array<settings::EnumName<Separator>>(
      {{",", Separator::comma}, {";", Separator::semicolon}, {"tab", Separator::tab}});
}

enum class Decimal { point, comma };
constexpr auto names_of(Decimal) {
  return std::to_array<settings::EnumName<Decimal>>({{".", Decimal::point}, {",", Decimal::comma}});
}

struct OutputKeys : Output {
  FieldFiles field_files;
  Separator separator = Separator::comma;
  Decimal decimal = Decimal::point;
};

std::optional<Output> make_output(OutputKeys keys, const Item& item, Context& context) {
  keys.fields = keys.field_files.written;
  keys.field_times = std::move(keys.field_files.times);
  if (keys.decimal == Decimal::comma && !item.has("separator")) keys.separator = Separator::semicolon;
  if (keys.decimal == Decimal::comma && keys.separator == Separator::comma)
    context.errors.add(item.child("decimal").location, "a decimal comma between cells separated by commas",
                       "with separator = \";\" or \"tab\"");
  keys.csv.separator = keys.separator == Separator::comma ? ',' : keys.separator == Separator::semicolon ? ';' : '\t';
  keys.csv.decimal = keys.decimal == Decimal::comma ? ',' : '.';
  return Output(std::move(keys));
}

OutputKeys keys_of_output(const Output& output) {
  OutputKeys keys{output, {output.fields, output.field_times}};
  if (output.csv.separator != ',') keys.separator = output.csv.separator == ';' ? Separator::semicolon : Separator::tab;
  if (output.csv.decimal == ',') keys.decimal = Decimal::comma;
  return keys;
}

}  // namespace

Value<Output> output_table() {
  const auto keys = table<OutputKeys>({
      field<OutputKeys>("directory", &OutputKeys::directory, path(), "directory of the results")
          .otherwise("`results/<name of the configuration>`"),
      field<OutputKeys>("fields", &OutputKeys::field_files, field_files(),
                        "write `fields.pvd`, `contact.pvd` and their `.vtu` files: at all output times, at none, or at "
                        "these times alone, which are then output times too")
          .in("time"),
      field<OutputKeys>("frd", &OutputKeys::frd, boolean(),
                        "write the fields as `fields.frd` too, for CalculiX GraphiX and PrePoMax, with the numbers of "
                        "nodes and elements of the mesh file"),
      field<OutputKeys>("revolve", &OutputKeys::revolve, integer(3, 360),
                        "axisymmetric models: write the full solid too, of so many segments, as `revolved.pvd`")
          .otherwise("the section alone"),
      field<OutputKeys>(
          "unit_names", &OutputKeys::unit_names, boolean(),
          "add units to the names of the arrays in the field files, as in `stress [MPa]`, where `units` gives them"),
      field<OutputKeys>("separator", &OutputKeys::separator, choice<Separator>("separator"),
                        "what separates the cells of `history.csv`, `steps.csv` and the log of contact iterations")
          .otherwise("`\",\"`, or `\";\"` with a decimal comma"),
      field<OutputKeys>("decimal", &OutputKeys::decimal, choice<Decimal>("decimal sign"),
                        "decimal sign of their numbers"),
      field<OutputKeys>("checkpoint_seconds", &OutputKeys::checkpoint_seconds, number(at_least(0)),
                        "wall time between checkpoints for `--resume`; 0: one after every step")
          .in("seconds"),
  });
  return converted<Output>(keys, make_output, keys_of_output);
}

}  // namespace creepcontact::config
