#include "section_checks.hpp"

#include <fmt/format.h>

#include <string>

#include "creepcontact/base/overload.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

using settings::Analysis;

/// @param work  called with the item of every entry and the entry itself
template <class T, class Work>
void for_each_entry(const Item& root, const std::string& key, T& entries, const Work& work) {
  const Item list = root.child(key);
  if (!list.node || !list.node->as_array() || list.node->as_array()->size() != entries.size()) return;
  for (std::size_t i = 0; i < entries.size(); ++i) work(list.element(i), entries[i]);
}

class SectionChecks {
 public:
  SectionChecks(const Config& config, Diagnostics& errors)
      : analysis_(config.analysis), name_(settings::name_of(config.analysis)), errors_(errors) {}

  void check_keys(const Config& config, const Item& root) {
    const bool is_plane = analysis_ != Analysis::solid && analysis_ != Analysis::axisymmetric;
    const Item thickness = root.child("mesh").child("thickness");
    if (thickness.node && !is_plane)
      errors_.add(thickness.location,
                  analysis_ == Analysis::axisymmetric
                      ? "an axisymmetric model has no thickness: it is the full circumference"
                      : "a solid has no thickness",
                  "in plane analyses only");
    for (const Body& body : config.bodies)
      if (body.thickness && analysis_ != Analysis::plane_stress)
        errors_.add(root.child("bodies").child(body.name).child("thickness").location,
                    "bodies may differ in thickness in plane stress only",
                    is_plane ? "mesh.thickness, for all bodies" : "with analysis = \"plane_stress\"");
    for (const Body& body : config.bodies)
      if (body.axial_force && !config.generalized_plane_strain.per_body)
        errors_.add(root.child("bodies").child(body.name).child("axial_force").location,
                    "an axial force on one body, where the bodies have no axial strain of their own",
                    "with analysis = \"generalized_plane_strain\" and generalized_plane_strain.per_body = true");
    const Item revolve = root.child("output").child("revolve");
    if (revolve.node && analysis_ != Analysis::axisymmetric)
      errors_.add(revolve.location, fmt::format("a section with analysis = \"{}\" is not revolved", name_),
                  "with analysis = \"axisymmetric\"");
    if (revolve.node && !config.output.fields)
      errors_.add(revolve.location, "no field files are written ('fields' = false)", "with 'fields' = true");
    if (config.temperature && !is_solid())
      for (const std::string& key : given_keys(root.child("temperature"), {"axis", "origin"}))
        errors_.add(root.child("temperature").child(key).location,
                    fmt::format("has no meaning with analysis = \"{}\"", name_), "with solids alone");
    check_initial_stress(config, root);
    const Item axial = root.child("generalized_plane_strain");
    if (axial.node && analysis_ != Analysis::generalized_plane_strain)
      errors_.add(axial.location, fmt::format("has no meaning with analysis = \"{}\"", name_),
                  "with analysis = \"generalized_plane_strain\"");
  }

  void check_initial_stress(const Config& config, const Item& root) {
    if (is_solid()) return;
    for (const InitialStress& stress : config.initial_stress) {
      const Item table = root.child("initial_stress").child(stress.name);
      for (const std::string& key : given_keys(table, {"yz", "zx", "radial", "tangential", "axial", "axis"}))
        errors_.add(table.child(key).location, fmt::format("has no meaning with analysis = \"{}\"", name_),
                    "xx, yy, zz, xy");
      if (analysis_ == Analysis::plane_stress && !stress.along_coordinates[2].is_zero())
        errors_.add(table.child("zz").location, "stress across the plane in plane stress", "0");
    }
  }

  void check_support(const Item& item, const Support& support) {
    if (is_solid()) return;
    const Item displacement = item.child("displacement");
    const auto refuse = [&](const char* key, const char* allowed) {
      errors_.add(displacement.child(key).location,
                  fmt::format("analysis = \"{}\" has no displacement along z that a support could hold", name_),
                  allowed);
    };
    if (support.displacement[2]) refuse("z", "x, y or normal");
    if (support.cylindrical[2]) refuse("axial", "x, y or normal");
    if (support.direction && (*support.direction)[2] != 0) refuse("along", "a direction in the plane");
    for (const std::string& key : given_keys(displacement, {"radial", "tangential"})) {
      if (analysis_ == Analysis::axisymmetric)
        errors_.add(displacement.child(key).location, "has no meaning in an axisymmetric model",
                    "x, which is the radial displacement, y or normal");
      else if (support.axis[0] != 0 || support.axis[1] != 0)
        errors_.add(item.child("axis").location, fmt::format("the axis of a section is [0, 0, 1]"), "[0, 0, 1]");
    }
  }

  void check_equation(const Item& item, const Equation& equation) {
    if (is_solid()) return;
    for (const Equation::Term& term : equation.terms)
      if (term.coefficient[2] != 0)
        errors_.add(item.child("terms").location,
                    fmt::format("node {}: analysis = \"{}\" has no displacement along z", term.node, name_),
                    "coefficients x and y");
  }

  void check_load(const Item& item, const Load& load) {
    if (is_solid()) return;
    std::visit(
        Overload{
            [](const Pressure&) {},
            [&](const Traction& traction) { require_in_plane(item.child("traction"), traction.value[2].is_zero()); },
            [&](const PointForce& force) {
              require_in_plane(item.child("force"), force.value[2].is_zero());
              if (force.at) require_in_plane(item.child("at"), (*force.at)[2] == 0);
            },
            [&](const BodyForce& force) { require_in_plane(item.child("body_force"), force.value[2].is_zero()); },
            [&](const Rotation& rotation) { check_rotation(item.child("rotation"), rotation); }},
        load.kind);
  }

  void check_rotation(const Item& item, const Rotation& rotation) {
    if (analysis_ == Analysis::axisymmetric)
      require_axis(item, rotation.axis, rotation.origin);
    else if (is_triple(item.child("axis")) && (rotation.axis[0] != 0 || rotation.axis[1] != 0))
      errors_.add(item.child("axis").location,
                  fmt::format("[{}, {}, {}] with analysis = \"{}\": the centrifugal force would change along z",
                              rotation.axis[0], rotation.axis[1], rotation.axis[2], name_),
                  "[0, 0, 1], or leave it out: the axis is z");
  }

  void check_probe(const Item& item, const Probe& probe) {
    if (is_solid()) return;
    if (probe.at) require_in_plane(item.child("at"), (*probe.at)[2] == 0);
    if (probe.section) check_plane(item, probe);
    if (analysis_ == Analysis::axisymmetric && !probe.section) require_axis(item, probe.axis, probe.origin);
  }

 private:
  /// The plane of a probe cuts the section along a line.
  void check_plane(const Item& item, const Probe& probe) {
    const Item section = item.child("section"), normal_item = section.child("normal");
    const std::array<double, 3>& normal = probe.section->normal;
    if (normal == std::array<double, 3>{}) return;  // reported
    if (analysis_ != Analysis::axisymmetric) {
      if (normal[2] != 0)
        errors_.add(normal_item.location, fmt::format("a z other than 0 with analysis = \"{}\"", name_),
                    "[x, y, 0]: a plane across the section");
      return;
    }
    if (normal[0] != 0 || normal[2] != 0)
      errors_.add(normal_item.location, "is not along the axis of the axisymmetric model", "[0, 1, 0] or [0, -1, 0]");
    if (probe.quantity != "section_force_y")
      errors_.add(item.child("quantity").location,
                  fmt::format("'{}' of the full circumference is 0 by symmetry", probe.quantity), "section_force_y");
  }

  bool is_solid() const { return analysis_ == Analysis::solid; }

  void require_in_plane(const Item& item, bool is_in_plane) {
    if (is_in_plane) return;
    errors_.add(item.location, fmt::format("a z other than 0 with analysis = \"{}\"", name_),
                "[x, y, 0]: a section lies in the plane z = 0");
  }

  /// False for what is wrong already, and reported.
  static bool is_triple(const Item& item) {
    return !item.node || (item.node->as_array() && item.node->as_array()->size() == 3);
  }

  void require_axis(const Item& item, const std::array<double, 3>& axis, const std::array<double, 3>& origin) {
    if (!is_triple(item.child("axis")) || !is_triple(item.child("origin"))) return;
    if (axis[0] != 0 || axis[1] == 0 || axis[2] != 0)
      errors_.add(item.child("axis").location,
                  fmt::format("[{}, {}, {}] is not the axis of the axisymmetric model", axis[0], axis[1], axis[2]),
                  "[0, 1, 0], or leave it out: the axis is y");
    if (origin[0] != 0 || origin[2] != 0)
      errors_.add(item.child("origin").location, "is not on the axis of the axisymmetric model, x = 0",
                  "[0, y, 0], or leave it out");
  }

  Analysis analysis_;
  std::string name_;
  Diagnostics& errors_;
};

}  // namespace

void set_section_defaults(const Item& root, Config& config) {
  if (config.analysis != Analysis::axisymmetric) return;
  for_each_entry(root, "probes", config.probes, [](const Item& item, Probe& probe) {
    if (!item.has("axis")) probe.axis = y_axis;
  });
  for_each_entry(root, "loads", config.loads, [](const Item& item, Load& load) {
    std::visit(Overload{[](Pressure&) {}, [](Traction&) {}, [](PointForce&) {}, [](BodyForce&) {},
                        [&](Rotation& rotation) {
                          if (!item.child("rotation").has("axis")) rotation.axis = y_axis;
                        }},
               load.kind);
  });
}

void check_sections(const Config& config, const Item& root, Diagnostics& errors) {
  SectionChecks checks(config, errors);
  checks.check_keys(config, root);
  for_each_entry(root, "supports", config.supports,
                 [&](const Item& item, const Support& support) { checks.check_support(item, support); });
  for_each_entry(root, "equations", config.equations,
                 [&](const Item& item, const Equation& equation) { checks.check_equation(item, equation); });
  for_each_entry(root, "loads", config.loads,
                 [&](const Item& item, const Load& load) { checks.check_load(item, load); });
  for_each_entry(root, "probes", config.probes,
                 [&](const Item& item, const Probe& probe) { checks.check_probe(item, probe); });
}

}  // namespace creepcontact::config
