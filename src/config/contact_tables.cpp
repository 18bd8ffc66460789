/// [[contacts]] and [contact_solver]

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

struct Gap {
  bool geometric = false;
  Function function = 0.0;
};

Value<Gap> gap_value() {
  const Value<Function> given = function(position_and_time);
  Value<Gap> value{.type = given.type + ", or \"geometric\"",
                   .read = {},
                   .brief = given.brief + ", or `\"geometric\"`",
                   .words = words_of({"geometric"}),
                   .json = [given] {
                     return schema_of_any({given.json(), schema_of_words({"geometric"})});
                   }};
  value.read = [given](const Item& item, Context& context) -> std::optional<Gap> {
    if (item.node->value<std::string>() == "geometric") return Gap{.geometric = true};
    const auto found = given.read(item, context);
    if (!found) return std::nullopt;
    return Gap{false, *found};
  };
  value.visit = [given](const Gap& gap, Visitor& to) {
    if (!gap.geometric) return given.visit(gap.function, to);
    to.leaf([] { return toml_of(std::string("geometric")); });
  };
  return value;
}

Value<Alpha> alpha_value(Range range) {
  const Value<double> number_of_body = number(range);
  const auto single = word_or_number("diagonal", range);
  const std::string type = single.type + ", or a table with one number per body";
  Value<Alpha> value{
      .type = type,
      .read = {},
      .brief = single.brief + ", or a table with one such number per body",
      .words = single.words,
      .json = [=] {
        return schema_of_any({single.json(), {{"type", "object"}, {"additionalProperties", range.json()}}});
      }};
  value.read = [=](const Item& item, Context& context) -> std::optional<Alpha> {
    Alpha alpha;
    if (const toml::table* bodies = item.node->as_table()) {
      for (const auto& [key, node] : *bodies) {
        const Item entry = item.child(key.str());
        const auto found = number_of_body.read(entry, context);
        if (found) alpha.of_body.push_back({{std::string(key.str()), entry.location}, *found});
      }
      return alpha;
    }
    const auto found = single.read(item, context);
    if (!found) return std::nullopt;
    alpha.all = *found;
    return alpha;
  };
  value.visit = [=](const Alpha& alpha, Visitor& to) {
    if (alpha.of_body.empty()) return single.visit(alpha.all, to);
    to.table([&] {
      for (const Alpha::OfBody& one : alpha.of_body)
        to.key(user_key(one.body.name), [&](Visitor& inner) { number_of_body.visit(one.value, inner); });
    });
  };
  return value;
}

Value<Preload> preload_table() {
  return written_inline(table<Preload>({
      field<Preload>("force", &Preload::force, number(greater(0)),
                     "pressure times area of a unilateral contact, tension across a tied one, of the modelled part",
                     Presence::required)
          .in("force"),
      field<Preload>("at", &Preload::time, number(at_least(0)),
                     "time at which it is applied, with the loads of that time; the interference found is kept")
          .in("time"),
  }));
}

struct ContactKeys : Contact {
  std::string slave_name = "auto";
  Gap initial_gap{geometric_gap, gap};
};

std::optional<Contact> make_contact(ContactKeys keys, const Item& item, Context& context) {
  keys.location = item.location;
  keys.geometric_gap = keys.initial_gap.geometric;
  keys.gap = keys.initial_gap.function;
  const bool has_gap = keys.geometric_gap || !keys.gap.is_zero();
  if (keys.type == ContactType::tied && has_gap)
    context.errors.add(item.child("gap").location,
                       "has no effect on a tied contact, which joins the surfaces as they are in the mesh",
                       "no gap, or type = \"unilateral\"");
  if (keys.preload && has_gap)
    context.errors.add(item.child("gap").location, "contradicts 'preload', which finds the interference itself",
                       "either gap or preload");
  if (keys.type == ContactType::tied && !keys.friction.is_zero())
    context.errors.add(item.child("friction").location, "has no effect on a tied contact, which never slides",
                       "no friction, or type = \"unilateral\"");
  if (keys.type == ContactType::tied && keys.gasket.given())
    context.errors.add(item.child("gasket").location, "has no effect on a tied contact, which joins the surfaces",
                       "no gasket, or type = \"unilateral\"");
  if (!keys.between[0].given()) return std::nullopt;  // reported
  const std::string& first = keys.between[0].name;
  const std::string& second = keys.between[1].name;
  if (keys.name.empty()) keys.name = default_name(keys);
  if (keys.slave_name == first) keys.slave = 0;
  if (keys.slave_name == second) keys.slave = 1;
  if (keys.slave < 0 && keys.slave_name != "auto") {
    context.errors.add_unknown(item.child("slave").location, fmt::format("unknown surface '{}'", keys.slave_name),
                               keys.slave_name, {"auto", first, second});
  }
  return Contact(std::move(keys));
}

ContactKeys keys_of_contact(const Contact& contact) {
  ContactKeys keys{contact};
  if (contact.slave >= 0) keys.slave_name = contact.between.at(static_cast<std::size_t>(contact.slave)).name;
  if (contact.name == default_name(contact)) keys.name.clear();
  return keys;
}

}  // namespace

std::string default_name(const Contact& contact) {
  return contact.between[0].name + '-' + contact.between[1].name;
}

Value<std::array<Reference, 2>> two_surfaces() {
  const std::string type = "two physical surfaces (in sections curves)";
  Value<std::array<Reference, 2>> value{
      .type = type, .read = {}, .json = [] { return schema_of_list(reference("a physical surface").json(), 2); }};
  value.read = [type](const Item& item, Context& context) -> std::optional<std::array<Reference, 2>> {
    const toml::array* array = item.node->as_array();
    if (!array || array->size() != 2) {
      context.errors.add(item.location, describe(*item.node), type);
      return std::nullopt;
    }
    const auto found = list(reference("a physical surface")).read(item, context);
    if (!found) return std::nullopt;
    if ((*found)[0].name == (*found)[1].name) {
      context.errors.add(item.location, fmt::format("'{}' is given twice", (*found)[0].name), type);
    }
    return std::array{(*found)[0], (*found)[1]};
  };
  value.visit = [](const std::array<Reference, 2>& both, Visitor& to) {
    list(reference("a physical surface")).visit({both[0], both[1]}, to);
  };
  return value;
}

Value<Contact> contact_table() {
  const auto type = choice<ContactType>("contact type");
  auto slave = name("\"auto\" or one of the two surfaces");
  slave.brief = "`\"auto\"` or one of the two surfaces";
  slave.words = words_of({"auto"});
  const auto keys = table<ContactKeys>({
      field<ContactKeys>("name", &ContactKeys::name, name("a name"), "unique name, used in messages and reports")
          .otherwise("the two surfaces"),
      field<ContactKeys>("between", &ContactKeys::between, two_surfaces(), "the two surfaces, of two different bodies",
                         Presence::required),
      field<ContactKeys>("type", &ContactKeys::type, type,
                         "`\"unilateral\"`: may open and slide; `\"tied\"`: does neither"),
      field<ContactKeys>("slave", &ContactKeys::slave_name, slave,
                         "the slave surface: the contact pressures (multipliers) are unknowns at its nodes"),
      field<ContactKeys>("gap", &ContactKeys::initial_gap, gap_value(),
                         "initial normal distance; negative: interference; `\"geometric\"`: measured from the mesh; "
                         "unilateral contacts only")
          .in("length"),
      field<ContactKeys>("preload", &ContactKeys::preload, preload_table(),
                         "normal force instead of `gap`, as of a bolt; on a tied contact, which is then a cut through "
                         "the shank, a tension"),
      field<ContactKeys>("gasket", &ContactKeys::gasket, reference("a gasket"),
                         "name of the gasket between the surfaces, in `[gaskets]`; `gap` counts from its uncompressed "
                         "face")
          .otherwise("none: the surfaces touch"),
      field<ContactKeys>("friction", &ContactKeys::friction, function({"x", "y", "z", "t", "T"}, at_least(0)),
                         "coefficient of Coulomb friction; unilateral contacts only"),
      field<ContactKeys>("conductance", &ContactKeys::conductance, conductance_value(),
                         "with `[heat]`: heat per area, degree and time that crosses the contact; `\"perfect\"`: as if "
                         "the bodies were one; `\"insulated\"`: none")
          .in("power/(area temperature)")
          .otherwise("required with `[heat]` unless the contact is tied, which is perfect"),
  });
  return converted<Contact>(keys, make_contact, keys_of_contact);
}

Value<ContactSolver> contact_solver_table() {
  const auto method = choice<settings::ContactMethod>("method");
  const auto acceleration = choice<settings::Acceleration>("acceleration");
  const Range relaxation{.min = 0, .max = 1, .open_min = true};
  return table<ContactSolver>({
      field<ContactSolver>("method", &ContactSolver::method, method,
                           "alternating Schwarz, or direct solves on an active set"),
      field<ContactSolver>(
          "alpha", &ContactSolver::alpha, alpha_value(relaxation),
          "Schwarz: iteration parameter of all bodies; `\"diagonal\"`: weights from their stiffness; or one value per "
          "body: `{ shaft = 0.3, disc = 0.6 }`, with `\"diagonal\"` for bodies left out"),
      field<ContactSolver>("damping", &ContactSolver::damping, number(relaxation),
                           "Schwarz: fraction of the change computed by each sweep that is applied"),
      field<ContactSolver>("acceleration", &ContactSolver::acceleration, acceleration,
                           "Schwarz: plain sweeps, sweeps with Anderson acceleration, or conjugate gradients"),
      field<ContactSolver>("tolerance", &ContactSolver::tolerance, number(greater(0)),
                           "largest relative error of the multipliers (contact pressures)")
          .changeable(),
      field<ContactSolver>("max_iterations", &ContactSolver::max_iterations, integer(1, 1'000'000),
                           "largest number of iterations on one active set")
          .changeable(),
      field<ContactSolver>("friction", &ContactSolver::friction, choice<settings::FrictionMethod>("method"),
                           "with friction: semismooth Newton method, or Tresca's law iterated by the Schwarz method; "
                           "sweeps (`acceleration` other than `\"cg\"`) always take the latter"),
      field<ContactSolver>("initial_substeps", &ContactSolver::initial_substeps, integer(1, 10'000),
                           "with friction, and where something yields: number of proportional steps in which the loads "
                           "of t = 0 are applied"),
      field<ContactSolver>("dense_limit_mb", &ContactSolver::dense_limit_mb, number(at_least(0)),
                           "memory [MB] allowed for the matrices of the contact zones; if they need more, contact is "
                           "solved without them, by iterations with the factorised stiffness")
          .changeable()
          .in("MB"),
  });
}

}  // namespace creepcontact::config
