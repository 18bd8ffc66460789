#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <set>

#include "creepcontact/base/log.hpp"
#include "discontinuities.hpp"
#include "extrema.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

/// Places inside the box around the bodies, on no plane of symmetry.
std::vector<Vector3> sample_positions(const Bodies& bodies) {
  Eigen::AlignedBox3d box;
  for (const mechanics::Body& body : bodies)
    for (const Vector3& node : body.mesh().nodes) box.extend(node);
  std::vector<Vector3> positions;
  for (const Vector3& share :
       {Vector3(0.31, 0.57, 0.43), Vector3(0.73, 0.21, 0.83), Vector3(0.11, 0.91, 0.67), Vector3(0.89, 0.67, 0.13)})
    positions.emplace_back(box.min() + share.cwiseProduct(box.sizes()));
  return positions;
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
  std::vector<Function> functions;  // which may jump, have kinks and extrema anywhere
  for (const config::ConfiguredFunction& function : config.functions)
    if (function.may_depend_on("t") && function.is_of_position_and_time()) functions.push_back(function.value);
  const std::vector<Vector3> positions = sample_positions(bodies);
  // Jumps are known to the last bit, kinks nearly so; turning points to a sample. What is known better comes first.
  Times times;
  std::vector<Discontinuities> found;
  for (const Function& function : functions) {
    found.push_back(find_discontinuities(function, end, positions));
    for (const double t : found.back().jumps) times.add(t, rounding * t);
    if (found.back().too_many)
      log::warning(
          "'{}' has too many kinks or jumps in time to find them all; list the important times in time.breakpoints, or "
          "use a table with a period",
          function.text());
  }
  for (const config::Support& support : config.supports)
    for (const auto& time : {support.from, support.until})
      if (time) times.add(*time, rounding * *time);
  for (const double t : config.time.breakpoints) times.add(t, rounding * t);
  for (const config::Contact& contact : config.contacts)
    if (contact.preload) times.add(contact.preload->time, rounding * contact.preload->time);
  for (const config::ConfiguredFunction& function : config.functions)
    for (const double t : function.value.breakpoints(end)) times.add(t, rounding * t);
  if (temperature)
    for (const double t : temperature->breakpoints(end)) times.add(t, rounding * t);
  for (const Discontinuities& of_function : found)
    for (const double t : of_function.kinks) times.add(t, near_kink * t);
  for (const Function& function : functions)
    for (const double t : extrema(function, end)) times.add(t, extremum_error(end));
  std::vector<double> result;
  for (const double t : times.all())
    if (t > 0 && t < end) result.push_back(t);
  return result;
}

}  // namespace creepcontact::model
