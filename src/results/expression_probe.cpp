#include "creepcontact/results/probe_expression.hpp"
#include "probe_kinds.hpp"

namespace creepcontact::results {
namespace {

class ExpressionProbe final : public Probe {
 public:
  explicit ExpressionProbe(ProbeExpression expression) : expression_(std::move(expression)) {}
  double value(Snapshot& snapshot) const override { return expression_.value(snapshot); }

 private:
  ProbeExpression expression_;
};

}  // namespace

ProbeExpression::ProbeExpression(const std::string& text, std::span<const config::Probe> probes,
                                 std::span<const std::unique_ptr<Probe>> all)
    : parsed_(text, names(probes)), n_probes_(probes.size()) {
  for (const std::size_t number : parsed_.used())
    if (number < all.size()) used_.emplace_back(number, all[number].get());
}

std::vector<std::string> ProbeExpression::names(std::span<const config::Probe> probes) {
  std::vector<std::string> result;
  // A probe of the name t would hide the time.
  for (const config::Probe& probe : probes) result.push_back(probe.name == "t" ? "" : probe.name);
  result.emplace_back("t");
  return result;
}

std::vector<std::size_t> ProbeExpression::used(const std::string& text, std::span<const config::Probe> probes) {
  std::vector<std::size_t> found = NamedExpression(text, names(probes)).used();
  std::erase(found, probes.size());  // the time
  return found;
}

std::vector<double> ProbeExpression::values(Snapshot& snapshot) const {
  std::vector<double> values(n_probes_, 0.0);
  for (const auto& [number, probe] : used_) values[number] = snapshot.value(*probe);
  return values;
}

double ProbeExpression::value(Snapshot& snapshot) const {
  return value(values(snapshot), snapshot.time());
}

double ProbeExpression::value(std::span<const double> probe_values, double time) const {
  std::vector<double> values(probe_values.begin(), probe_values.end());
  values.push_back(time);
  return parsed_(values);
}

std::unique_ptr<Probe> expression_probe(const config::Probe& probe, std::span<const config::Probe> probes,
                                        std::span<const std::unique_ptr<Probe>> all) {
  return std::make_unique<ExpressionProbe>(ProbeExpression(probe.expression.name, probes, all));
}

}  // namespace creepcontact::results
