#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "function_definition.hpp"
#include "parsed_expression.hpp"

namespace creepcontact {
namespace {

struct Constant final : Function::Definition {
  Constant(double given, std::string written) : Definition(std::move(written)), number(given) {}
  double value(const Arguments&) const override { return number; }
  double number;
};

struct Expression final : Function::Definition {
  Expression(const std::string& written, const std::vector<std::string>& allowed)
      : Definition(written), parsers(written, allowed) {}
  double value(const Arguments& at) const override { return parsers.mine().value(at); }
  ThreadParsers parsers;
};

struct Composition final : Function::Definition {
  Composition(std::string written, std::vector<Function> of,
              std::function<double(const std::vector<double>&)> combination)
      : Definition(std::move(written)), parts(std::move(of)), combine(std::move(combination)) {}
  double value(const Arguments& at) const override {
    std::vector<double> values;
    for (const Function& part : parts) values.push_back(part(at));
    return combine(values);
  }
  std::vector<double> breakpoints(double end) const override {
    std::set<double> times;
    for (const Function& part : parts)
      for (const double t : part.breakpoints(end)) times.insert(t);
    return {times.begin(), times.end()};
  }
  std::optional<Interval> table_range(const std::string& variable) const override {
    for (const Function& part : parts)
      if (const auto range = part.table_range(variable)) return range;
    return std::nullopt;
  }

  std::vector<Function> parts;
  std::function<double(const std::vector<double>&)> combine;
};

struct Batched final : Function::Definition {
  Batched(std::string written, std::shared_ptr<const BatchedFunction> given)
      : Definition(std::move(written)), evaluation(std::move(given)) {}
  double value(const Arguments& at) const override {
    double result = 0;
    evaluation->evaluate({&at, 1}, {&result, 1});
    return result;
  }
  const BatchedFunction* batch() const override { return evaluation.get(); }
  std::shared_ptr<const BatchedFunction> evaluation;
};

[[noreturn]] void throw_parser_error(const std::string& text, const std::vector<std::string>& allowed,
                                     const mu::ParserError& error) {
  throw std::invalid_argument(fmt::format("'{}': {} (position {}; allowed variables: {})", text, error.GetMsg(),
                                          error.GetPos(),
                                          allowed.empty() ? "none" : fmt::format("{}", fmt::join(allowed, ", "))));
}

}  // namespace

Function::Function(double constant) : definition_(std::make_shared<Constant>(constant, fmt::format("{}", constant))) {}

Function Function::expression(const std::string& text, const std::vector<std::string>& allowed) {
  reject_assignment(text);
  try {
    auto made = std::make_shared<Expression>(text, allowed);
    mu::Parser& parser = made->parsers.mine().parser;
    for (const auto& [name, address] : parser.GetUsedVar()) made->variables.insert(name);
    const double value = parser.Eval();  // compiles again: looking for variables dropped the byte code
    if (parser.GetNumResults() != 1)
      throw std::invalid_argument(
          fmt::format("'{}': {} values separated by commas; only one is allowed", text, parser.GetNumResults()));
    if (!made->variables.empty()) return Function(std::move(made));
    if (!std::isfinite(value)) throw std::invalid_argument(fmt::format("'{}': the value is {}", text, value));
    return Function(std::make_shared<Constant>(value, text));
  } catch (const mu::ParserError& error) {
    throw_parser_error(text, allowed, error);
  }
}

Function Function::composed(const std::string& text, std::vector<Function> parts,
                            std::function<double(const std::vector<double>&)> value) {
  auto made = std::make_shared<Composition>(text, std::move(parts), std::move(value));
  for (const Function& part : made->parts)
    made->variables.insert(part.definition_->variables.begin(), part.definition_->variables.end());
  return Function(std::move(made));
}

Function Function::batched(const std::string& text, const std::vector<std::string>& variables,
                           std::shared_ptr<const BatchedFunction> evaluation) {
  auto made = std::make_shared<Batched>(text, std::move(evaluation));
  made->variables.insert(variables.begin(), variables.end());
  return Function(std::move(made));
}

const BatchedFunction* Function::batch() const {
  return definition_->batch();
}

double Function::operator()(const Arguments& at) const {
  return definition_->value(at);
}

bool Function::is_constant() const {
  return definition_->variables.empty();
}
bool Function::is_zero() const {
  return is_constant() && definition_->value({}) == 0.0;
}
bool Function::depends_on_position() const {
  const auto& used = definition_->variables;
  return used.contains("x") || used.contains("y") || used.contains("z");
}
bool Function::depends_on_time() const {
  return definition_->variables.contains("t");
}
bool Function::depends_on_temperature() const {
  return definition_->variables.contains("T");
}
bool Function::depends_on_strain() const {
  return definition_->variables.contains("eps");
}
bool Function::depends_on_contact() const {
  const auto& used = definition_->variables;
  return used.contains("p") || used.contains("gap");
}
std::vector<double> Function::breakpoints() const {
  return definition_->breakpoints(std::numeric_limits<double>::infinity());
}
std::vector<double> Function::breakpoints(double end) const {
  return definition_->breakpoints(end);
}
std::optional<double> Function::period() const {
  return definition_->period();
}
std::optional<Interval> Function::table_range(const std::string& variable) const {
  return definition_->table_range(variable);
}
const std::string& Function::text() const {
  return definition_->text;
}

std::string texts(const std::vector<Function>& functions) {
  std::vector<std::string> all;
  all.reserve(functions.size());
  for (const Function& function : functions) all.push_back(function.text());
  return fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace creepcontact
