/// [initial_stress.<body>]

#include <algorithm>

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

constexpr std::array along_coordinates{"xx", "yy", "zz", "xy", "yz", "zx"};
constexpr std::array about_axis{"radial", "tangential", "axial"};

Field<InitialStress> component(std::size_t i, const std::string& description) {
  return field<InitialStress>(
             along_coordinates[i], [i](auto& of) -> auto& { return of.along_coordinates[i]; },
             function({"x", "y", "z"}), description)
      .in("stress");
}

Field<InitialStress> component_about_axis(std::size_t i, const std::string& description) {
  return field<InitialStress>(
             about_axis[i], [i](auto& of) -> auto& { return of.about_axis[i]; }, function({"x", "y", "z"}), description)
      .in("stress");
}

void check(const InitialStress& given, const Item& item, Context& context) {
  const std::vector<std::string> cartesian = given_keys(item, {along_coordinates.begin(), along_coordinates.end()});
  const std::vector<std::string> cylindrical = given_keys(item, {about_axis.begin(), about_axis.end()});
  const int n = static_cast<int>(!cartesian.empty()) + static_cast<int>(!cylindrical.empty()) +
                static_cast<int>(item.has("file"));
  if (n == 0) context.errors.add(item.location, "no stress", "components xx, ..., radial, ..., or 'file'");
  if (n > 1)
    context.errors.add(item.location, "components along different axes, or next to 'file'",
                       "one of: xx, yy, zz, xy, yz, zx; radial, tangential, axial; 'file'");
  if (cylindrical.empty())
    for (const std::string& key : given_keys(item, {"axis", "origin"}))
      context.errors.add(item.child(key).location, "has no meaning here", "with radial, tangential or axial");
  if (given.axis == std::array<double, 3>{})
    context.errors.add(item.child("axis").location, "[0, 0, 0]", "a direction");
}

}  // namespace

Value<InitialStress> initial_stress_table() {
  const auto keys = table<InitialStress>({
      component(0, "normal stress along x; in an axisymmetric model radial"),
      component(1, "normal stress along y"),
      component(2, "normal stress along z; in an axisymmetric model circumferential"),
      component(3, "shear stress"),
      component(4, "shear stress; solids only"),
      component(5, "shear stress; solids only"),
      component_about_axis(0, "normal stress away from the `axis`, instead of the components along x, y, z"),
      component_about_axis(1, "normal stress around the `axis`"),
      component_about_axis(2, "normal stress along the `axis`"),
      field<InitialStress>("axis", &InitialStress::axis, triple(number()),
                           "direction of the axis of `radial`, `tangential` and `axial`, of any length"),
      field<InitialStress>("origin", &InitialStress::origin, triple(number()), "a point of that axis").in("length"),
      field<InitialStress>("file", &InitialStress::file, path(),
                           "stresses at points instead: a table with columns x, y, z, xx, yy, zz, xy, yz, zx, or a "
                           "`.vtu` with the array `stress`, as this program writes it")
          .changeable(),
  });
  return converted<InitialStress>(keys, [](InitialStress given, const Item& item, Context& context) {
    given.location = item.location;
    check(given, item, context);
    return std::optional(std::move(given));
  });
}

}  // namespace creepcontact::config
