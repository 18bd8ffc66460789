#include "schwarz_options.hpp"

#include "creepcontact/ode/anderson_iteration.hpp"

namespace creepcontact::model {
namespace {

/// The sweeps of one set are an affine map: more differences than a handful change little.
constexpr int anderson_depth = 5;

class Anderson final : public contact::FixedPointSolver {
 public:
  explicit Anderson(std::size_t size) : iteration_(size, anderson_depth) {}
  void solve(std::span<double> x, const Step& step) override { iteration_.run(x, step); }

 private:
  ode::AndersonIteration iteration_;
};

}  // namespace

contact::SchwarzOptions schwarz_options(const config::ContactSolver& config,
                                        const std::vector<mechanics::Body>& bodies) {
  contact::SchwarzOptions options;
  options.alpha.assign(bodies.size(), config.alpha.all);
  for (const config::Alpha::OfBody& alpha : config.alpha.of_body)
    options.alpha[find_body(bodies, alpha.body.name)] = alpha.value;
  options.damping = config.damping;
  options.acceleration = config.acceleration;
  options.tolerance = config.tolerance;
  options.max_iterations = config.max_iterations;
  options.anderson = [](std::size_t size) { return std::make_unique<Anderson>(size); };
  return options;
}

}  // namespace creepcontact::model
