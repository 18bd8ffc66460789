#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <set>

#include "creepcontact/base/log.hpp"
#include "kinks.hpp"
#include "model_parts.hpp"
#include "turning_points.hpp"

namespace creepcontact::model {
namespace {

std::vector<Function> listed(const std::array<Function, 3>& components) {
  return {components.begin(), components.end()};
}

/// Those of a kind of load.
struct LoadFunctions {
  std::vector<Function> operator()(const config::Pressure& pressure) const { return {pressure.value}; }
  std::vector<Function> operator()(const config::Traction& traction) const { return listed(traction.value); }
  std::vector<Function> operator()(const config::PointForce& force) const { return listed(force.value); }
  std::vector<Function> operator()(const config::BodyForce& force) const { return listed(force.value); }
  std::vector<Function> operator()(const config::Rotation& rotation) const {
    return {rotation.angular_velocity, rotation.density};
  }
};

/// Every function of the configuration that may depend on the time.
std::vector<Function> functions_of_time(const config::Config& config) {
  std::vector<Function> all;
  for (const config::Support& support : config.supports) {
    for (const auto& value : support.displacement)
      if (value) all.push_back(*value);
    if (support.normal) all.push_back(*support.normal);
  }
  for (const config::Load& load : config.loads) {
    const std::vector<Function> functions = std::visit(LoadFunctions{}, load.kind);
    all.insert(all.end(), functions.begin(), functions.end());
  }
  if (config.temperature && config.temperature->file.empty()) all.push_back(config.temperature->value);
  for (const config::Contact& contact : config.contacts) all.push_back(contact.gap);
  return all;
}

/// Places inside the box around the bodies, on no plane of symmetry.
std::vector<Vector3> sample_places(const Bodies& bodies) {
  Eigen::AlignedBox3d box;
  for (const mechanics::Body& body : bodies)
    for (const Vector3& node : body.mesh().nodes) box.extend(node);
  std::vector<Vector3> places;
  for (const Vector3& share :
       {Vector3(0.31, 0.57, 0.43), Vector3(0.73, 0.21, 0.83), Vector3(0.11, 0.91, 0.67), Vector3(0.89, 0.67, 0.13)})
    places.emplace_back(box.min() + share.cwiseProduct(box.sizes()));
  return places;
}

/// Each stands for all within its tolerance, the first given counts.
class Times {
 public:
  void add(double time, double tolerance) {
    const auto after = times_.lower_bound(time - tolerance);
    if (after == times_.end() || *after > time + tolerance) times_.insert(time);
  }
  const std::set<double>& all() const { return times_; }

 private:
  std::set<double> times_;
};

}  // namespace

std::vector<double> breakpoints(const config::Config& config, const Bodies& bodies,
                                const std::optional<mechanics::TemperatureField>& temperature) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon(), near_kink = 1e-11;
  const double end = config.time.end;
  const std::vector<Function> functions = functions_of_time(config);
  const std::vector<Vector3> places = sample_places(bodies);
  // Jumps are known to the last bit, kinks nearly so; turning points to a sample. What is known better comes first.
  Times times;
  std::vector<Kinks> found;
  for (const Function& function : functions) {
    found.push_back(kinks(function, end, places));
    for (const double t : found.back().jumps) times.add(t, rounding * t);
    if (found.back().too_many)
      log::warning(
          "'{}' has more kinks or jumps in time than can be found; name the times that matter in time.breakpoints, or "
          "use a table with a period",
          function.text());
  }
  for (const double t : config.time.breakpoints) times.add(t, rounding * t);
  for (const Function& function : functions)
    for (const double t : function.breakpoints(end)) times.add(t, rounding * t);
  for (const config::Material& material : config.materials)
    for (const config::CreepMechanism& mechanism : material.creep)
      for (const config::CreepParameter& parameter : mechanism.parameters)
        for (const Function& value : parameter.values)
          for (const double t : value.breakpoints(end)) times.add(t, rounding * t);
  if (temperature)
    for (const double t : temperature->breakpoints(end)) times.add(t, rounding * t);
  for (const Kinks& of_function : found)
    for (const double t : of_function.kinks) times.add(t, near_kink * t);
  for (const Function& function : functions)
    for (const double t : turning_points(function, end)) times.add(t, turning_point_error(end));
  std::vector<double> result;
  for (const double t : times.all())
    if (t > 0 && t < end) result.push_back(t);
  return result;
}

}  // namespace creepcontact::model
