#pragma once
/// An expression of the values of probes and the time: probes with `expression`, conditions of events.

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/named_expression.hpp"
#include "creepcontact/results/probes.hpp"

namespace creepcontact::results {

class ProbeExpression {
 public:
  /// @param probes  of the configuration.
  /// @param all  made of them, in the same order, those in use at least; they must outlive the object.
  /// @throws std::invalid_argument if the text is not an expression of them (reading the configuration has checked it)
  ProbeExpression(const std::string& text, std::span<const config::Probe> probes,
                  std::span<const std::unique_ptr<Probe>> all);

  /// The value of the expression; a condition gives 1 or 0. Collective.
  double value(Snapshot& snapshot) const;
  /// The probes that the text names, zeros for the others. Evaluates each once per snapshot. Collective.
  std::vector<double> values(Snapshot& snapshot) const;
  /// value() for given values of the probes that the text names; the others have any value.
  double value(std::span<const double> probe_values, double time) const;

  /// Numbers of the probes that a text names.
  static std::vector<std::size_t> used(const std::string& text, std::span<const config::Probe> probes);

 private:
  static std::vector<std::string> names(std::span<const config::Probe> probes);

  NamedExpression parsed_;
  std::vector<std::pair<std::size_t, const Probe*>> used_;  // number and probe
  std::size_t n_probes_;
};

}  // namespace creepcontact::results
