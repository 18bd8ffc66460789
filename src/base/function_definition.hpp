#pragma once
/// What a function is made of; expressions, tables and constants each derive from it.

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/function.hpp"

namespace creepcontact {

struct Function::Definition {
  explicit Definition(std::string written) : text(std::move(written)) {}
  Definition(const Definition&) = delete;
  Definition& operator=(const Definition&) = delete;
  virtual ~Definition() = default;
  virtual double value(const Arguments& at) const = 0;
  /// Up to `end`.
  virtual std::vector<double> breakpoints(double /*end*/) const { return {}; }
  virtual const BatchedFunction* batch() const { return nullptr; }
  virtual std::optional<double> period() const { return std::nullopt; }
  virtual std::optional<Interval> table_range(const std::string& /*variable*/) const { return std::nullopt; }

  std::string text;
  std::set<std::string> variables;  // that really occur
};

/// The member of the arguments that a name denotes. @throws std::invalid_argument
double Arguments::*known_variable(const std::string& name);

}  // namespace creepcontact
