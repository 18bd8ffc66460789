#include <algorithm>
#include <utility>

#include "creepcontact/model/step_guard.hpp"

namespace creepcontact::model {
namespace {

constexpr std::size_t max_places = 4096;  // of a course: a step looks at three of them
constexpr double typical_strain = 1e-3;   // elastic, and of creep: where expressions of q and eps are looked at

std::vector<Vector3> some_nodes(const std::vector<mechanics::Body>& bodies) {
  std::size_t n_nodes = 0;
  for (const mechanics::Body& body : bodies) n_nodes += body.mesh().nodes.size();
  const std::size_t stride = 1 + n_nodes / max_places;
  std::vector<Vector3> places;
  std::size_t i = 0;
  for (const mechanics::Body& body : bodies)
    for (const Vector3& node : body.mesh().nodes)
      if (i++ % stride == 0) places.push_back(node);
  return places;
}

}  // namespace

std::vector<CourseInTime> courses_in_time(const config::Config& config, const Model& model) {
  const std::vector<Vector3> places = some_nodes(model.bodies());
  const std::optional<mechanics::TemperatureField>& temperature = model.temperature;
  const bool warms = temperature && temperature->depends_on_time();
  std::vector<CourseInTime> courses;
  for (const config::ConfiguredFunction& function : config.functions) {
    const Function& value = function.value;
    if (!value.depends_on_time() && !(warms && value.depends_on_temperature())) continue;
    const bool needs_temperature = temperature && value.depends_on_temperature();
    const bool has_place = value.depends_on_position() || (needs_temperature && temperature->depends_on_position());
    double stress = 0;
    for (const config::Material& material : config.materials)
      if (function.key.starts_with("materials." + material.name + "."))
        stress = typical_strain * material.young_modulus({});
    courses.push_back({.key = function.key,
                       .value =
                           [value, temperature, needs_temperature, stress](const Vector3& x, double t) {
                             Arguments at{.x = x[0], .y = x[1], .z = x[2], .t = t, .q = stress, .eps = typical_strain};
                             if (needs_temperature) at.T = (*temperature)(at);
                             return value(at);
                           },
                       .places = has_place ? places : std::vector<Vector3>{places.front()}});
  }
  if (warms && !config.temperature->files.empty())
    courses.push_back(
        {.key = "temperature.file",
         .value = [field = *temperature](const Vector3& x,
                                         double t) { return field({.x = x[0], .y = x[1], .z = x[2], .t = t}); },
         .places = places});
  return courses;
}

}  // namespace creepcontact::model
