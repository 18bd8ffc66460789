/// Random joints with friction, whose path is followed through random loads: slip and dissipated energy never fall,
/// and every state on it obeys Coulomb's law.

#include <algorithm>
#include <cmath>

#include "creep/friction_path.hpp"
#include "fuzz_target.hpp"
#include "unit/creep/friction_joint.hpp"

namespace creepcontact::creep {
namespace {

using friction_joints::Joint;
using friction_joints::Loads;

/// Numbers that bytes stand for; zero after the last one.
class Numbers {
 public:
  Numbers(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  unsigned byte() { return at_ < size_ ? data_[at_++] : 0U; }
  /// In [0, 1].
  double share() { return byte() / 255.0; }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

void require_coulomb(const SlipAdvance& slip, const PathPoint& at) {
  constexpr double rounding = 1e-6;
  const double largest = std::max(at.contact.multiplier.cwiseAbs().maxCoeff(), 1e-300);
  for (const SlipNode& node : slip.nodes()) {
    const double pressure = at.contact.multiplier[node.normal_row];
    const double shear = node.tangential(at.contact.multiplier).norm();
    fuzz::require(pressure >= -rounding * largest, "no node pulls");
    fuzz::require(shear <= node.at(at.contact).friction * std::max(pressure, 0.0) + rounding * largest,
                  "no shear above the limit");
  }
}

void require_monotonic(const std::vector<PathPoint>& points) {
  constexpr double rounding = 1e-9;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const SlipHistory &before = points[k - 1].friction, &now = points[k].friction;
    fuzz::require(now.time > before.time, "substeps lead forwards");
    fuzz::require((now.path - before.path).minCoeff() >= 0, "slip never falls");
    fuzz::require(now.dissipated[0] >= before.dissipated[0] * (1 - rounding) - 1e-14, "friction gives no energy back");
  }
}

void follow(Numbers& numbers) {
  const int n_nodes = 1 + static_cast<int>(numbers.byte() % 8);
  const int n_tangents = 1 + static_cast<int>(numbers.byte() % 2);
  Joint joint(n_nodes, n_tangents, numbers.byte());
  joint.mu = numbers.share();
  const SlipAdvance slip(joint.problem, joint.pairs);
  Loads loads(joint, numbers.byte());
  for (const SlipNode& node : slip.nodes()) {
    loads.first[node.normal_row] -= 2 * numbers.share();
    loads.last[node.normal_row] -= 2 * numbers.share();
    node.tangential(loads.first) *= 4 * numbers.share();
    node.tangential(loads.last) *= 4 * numbers.share();
  }
  const double bend = numbers.share() - 0.5;  // so that the loads may turn back
  const auto at = [&](double part) { return loads.at(part + 4 * bend * part * (1 - part)); };
  const PathPoint begin = joint.at_rest(at(0)), once = joint.next(slip, begin, at(1), 1);
  FrictionPath path(
      joint.problem, slip, {}, [&](double part) { return joint.load(at(part)); },
      [&](const contact::ContactLoad& load, const contact::ContactState& from, double) {
        return joint.solver->solve(load, from);
      });
  const auto points = path.follow(begin, once);
  fuzz::require(points.has_value(), "held bodies always have a path");
  require_monotonic(*points);
  for (const PathPoint& point : *points) require_coulomb(slip, point);
}

}  // namespace
}  // namespace creepcontact::creep

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  creep::Numbers numbers(data, size);
  fuzz::may_refuse([&] { creep::follow(numbers); });
  return 0;
}
