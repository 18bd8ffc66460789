#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "probe_kinds.hpp"

namespace creepcontact::results {
namespace {

bool is_spring(const contact::Pair& pair) {
  return pair.gasket && pair.ties_nodes();
}

class SpringProbe final : public Probe {
 public:
  SpringProbe(std::size_t pair, const OnSpring& spring) : pair_(pair), spring_(spring) {}

  double value(Snapshot& snapshot) const override {
    return spring_.evaluate(snapshot.assembly().pairs()[pair_], snapshot.equilibrium());
  }

 private:
  std::size_t pair_;
  OnSpring spring_;
};

}  // namespace

std::unique_ptr<Probe> make_probe(const OnSpring& spring, const ProbeRequest& request) {
  const std::vector<contact::Pair>& pairs = request.model.pairs();
  const auto found = std::ranges::find_if(
      pairs, [&](const contact::Pair& pair) { return is_spring(pair) && pair.name == request.probe.on.name; });
  if (found != pairs.end()) return std::make_unique<SpringProbe>(found - pairs.begin(), spring);
  std::vector<std::string> names;
  for (const contact::Pair& pair : pairs)
    if (is_spring(pair)) names.push_back(pair.name);
  throw ModelError(names.empty() ? fmt::format("'{}' is not a spring: there is no [[springs]]", request.probe.on.name)
                                 : fmt::format("there is no spring '{}'; the springs are: {}", request.probe.on.name,
                                               fmt::join(names, ", ")));
}

}  // namespace creepcontact::results
