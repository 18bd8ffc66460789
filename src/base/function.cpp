#include "creepcontact/base/function.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

namespace creepcontact {

/// What a function is made of. Expressions override value(); constants and tables are complete as they stand.
struct Function::Definition {
  explicit Definition(std::string written) : text(std::move(written)) {}
  Definition(const Definition&) = delete;
  Definition& operator=(const Definition&) = delete;
  virtual ~Definition() = default;
  virtual double value(const Arguments& at) const = 0;

  std::string text;
  std::set<std::string> variables;  // that really occur
  std::vector<double> breakpoints;
};

namespace {

struct Variable {
  const char* name;
  double Arguments::*member;
};
constexpr std::array<Variable, 7> known_variables{{{"x", &Arguments::x},
                                                   {"y", &Arguments::y},
                                                   {"z", &Arguments::z},
                                                   {"t", &Arguments::t},
                                                   {"T", &Arguments::T},
                                                   {"q", &Arguments::q},
                                                   {"eps", &Arguments::eps}}};

const Variable& known_variable(const std::string& name) {
  const auto* found = std::find_if(known_variables.begin(), known_variables.end(),
                                   [&](const Variable& variable) { return name == variable.name; });
  if (found == known_variables.end()) throw std::invalid_argument(fmt::format("'{}' is no variable", name));
  return *found;
}

struct Constant final : Function::Definition {
  Constant(double given, std::string written) : Definition(std::move(written)), number(given) {}
  double value(const Arguments&) const override { return number; }
  double number;
};

struct Expression final : Function::Definition {
  using Definition::Definition;
  double value(const Arguments& at) const override {
    bound = at;
    return parser.Eval();
  }
  mutable Arguments bound;  // the parser's variables point in here
  mu::Parser parser;
};

struct Table final : Function::Definition {
  Table(const std::string& variable, std::vector<double> points, std::vector<double> ordinates)
      : Definition(fmt::format("{{ {} = {}, values = {} }}", variable, points, ordinates)),
        argument(known_variable(variable).member),
        abscissae(std::move(points)),
        values(std::move(ordinates)) {
    variables.insert(variable);
    if (variable == "t") std::unique_copy(abscissae.begin(), abscissae.end(), std::back_inserter(breakpoints));
  }

  double value(const Arguments& at) const override {
    const double s = at.*argument;
    // The negation sends a NaN to the first branch instead of past the end.
    if (!(s >= abscissae.front())) return std::isnan(s) ? s : values.front();
    if (s >= abscissae.back()) return values.back();
    const auto i =
        static_cast<std::size_t>(std::upper_bound(abscissae.begin(), abscissae.end(), s) - abscissae.begin());
    const double weight = (s - abscissae[i - 1]) / (abscissae[i] - abscissae[i - 1]);
    return (1 - weight) * values[i - 1] + weight * values[i];
  }

  double Arguments::*argument;
  std::vector<double> abscissae, values;
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

  std::vector<Function> parts;
  std::function<double(const std::vector<double>&)> combine;
};

/// The parser would take `x = 3` for an assignment, which no function value can mean.
void reject_assignment(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
    } else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos) {
      throw std::invalid_argument(
          fmt::format("'{}': assignment at position {}; a comparison is written '=='", text, i));
    }
  }
}

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
  auto made = std::make_shared<Expression>(text);
  try {
    // The parser's own constants have 13 digits.
    for (const char* pi : {"pi", "_pi"}) made->parser.DefineConst(pi, std::numbers::pi);
    made->parser.DefineConst("_e", std::numbers::e);
    for (const auto& name : allowed) made->parser.DefineVar(name, &(made->bound.*known_variable(name).member));
    made->parser.SetExpr(text);
    made->parser.Eval();  // every error shows here: looking for variables tolerates unknown names
    for (const auto& [name, address] : made->parser.GetUsedVar()) made->variables.insert(name);
    const double value = made->parser.Eval();  // compiles anew: looking for variables dropped the byte code
    if (made->parser.GetNumResults() != 1)
      throw std::invalid_argument(
          fmt::format("'{}': {} values separated by commas; one is wanted", text, made->parser.GetNumResults()));
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
  std::set<double> times;
  for (const Function& part : made->parts) {
    made->variables.insert(part.definition_->variables.begin(), part.definition_->variables.end());
    times.insert(part.definition_->breakpoints.begin(), part.definition_->breakpoints.end());
  }
  made->breakpoints.assign(times.begin(), times.end());
  return Function(std::move(made));
}

std::size_t Function::misplaced_point(const std::string& variable, const std::vector<double>& abscissae) {
  for (std::size_t i = 1; i < abscissae.size(); ++i) {
    const bool jump = variable == "t" && abscissae[i] == abscissae[i - 1] && (i < 2 || abscissae[i - 2] < abscissae[i]);
    if (!(abscissae[i] > abscissae[i - 1]) && !jump) return i;
  }
  return abscissae.size();
}

Function Function::table(const std::string& variable, std::vector<double> abscissae, std::vector<double> values) {
  if (variable != "t" && variable != "T")
    throw std::invalid_argument(fmt::format("a table is in 't' or 'T', not in '{}'", variable));
  if (abscissae.empty()) throw std::invalid_argument(fmt::format("the table in {} has no points", variable));
  if (abscissae.size() != values.size())
    throw std::invalid_argument(
        fmt::format("the table has {} points in {} but {} values", abscissae.size(), variable, values.size()));
  const auto finite = [](double number) { return std::isfinite(number); };
  if (!std::all_of(abscissae.begin(), abscissae.end(), finite) || !std::all_of(values.begin(), values.end(), finite))
    throw std::invalid_argument(fmt::format("the table in {} holds a number that is not finite", variable));
  if (const std::size_t i = misplaced_point(variable, abscissae); i < abscissae.size())
    throw std::invalid_argument(fmt::format("the points of the table in {} must increase: {} follows {} (entry {}){}",
                                            variable, abscissae[i], abscissae[i - 1], i + 1,
                                            variable == "t" ? "; a jump is the same time twice" : ""));
  if (std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); }))
    return values.front();
  return Function(std::make_shared<Table>(variable, std::move(abscissae), std::move(values)));
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
bool Function::depends_on_place() const {
  const auto& used = definition_->variables;
  return used.contains("x") || used.contains("y") || used.contains("z");
}
bool Function::depends_on_time() const {
  return definition_->variables.contains("t");
}
bool Function::depends_on_temperature() const {
  return definition_->variables.contains("T");
}
std::vector<double> Function::breakpoints() const {
  return definition_->breakpoints;
}
const std::string& Function::text() const {
  return definition_->text;
}

}  // namespace creepcontact
