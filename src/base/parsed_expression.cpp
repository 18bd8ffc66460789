#include "parsed_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "function_definition.hpp"
#include "thread_number.hpp"

namespace creepcontact {
namespace {

struct Variable {
  const char* name;
  double Arguments::*member;
};
constexpr std::array<Variable, 10> known_variables{{{"x", &Arguments::x},
                                                    {"y", &Arguments::y},
                                                    {"z", &Arguments::z},
                                                    {"t", &Arguments::t},
                                                    {"T", &Arguments::T},
                                                    {"q", &Arguments::q},
                                                    {"eps", &Arguments::eps},
                                                    {"U", &Arguments::U},
                                                    {"p", &Arguments::p},
                                                    {"gap", &Arguments::gap}}};

/// Remainder with the sign of b.
double modulo(double a, double b) {
  const double remainder = std::fmod(a, b);
  return remainder != 0 && (remainder < 0) != (b < 0) ? remainder + b : remainder;
}
double round_down(double a) {
  return std::floor(a);
}

}  // namespace

void define_language(mu::Parser& parser) {
  // The parser's own constants have 13 digits.
  for (const char* pi : {"pi", "_pi"}) parser.DefineConst(pi, std::numbers::pi);
  parser.DefineConst("_e", std::numbers::e);
  parser.DefineFun("mod", modulo);
  parser.DefineFun("floor", round_down);
}

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

double Arguments::*known_variable(const std::string& name) {
  const auto* found = std::find_if(known_variables.begin(), known_variables.end(),
                                   [&](const Variable& variable) { return name == variable.name; });
  if (found == known_variables.end()) throw std::invalid_argument(fmt::format("'{}' is not a variable", name));
  return found->member;
}

ParsedExpression::ParsedExpression(const std::string& text, const std::vector<std::string>& allowed) {
  define_language(parser);
  for (const auto& name : allowed) parser.DefineVar(name, &(bound.*known_variable(name)));
  parser.SetExpr(text);
  parser.Eval();  // every error shows here: looking for variables tolerates unknown names
}

ThreadParsers::ThreadParsers(std::string text, std::vector<std::string> allowed)
    : text_(std::move(text)), allowed_(std::move(allowed)), parsers_(max_threads) {
  mine();
}

ParsedExpression& ThreadParsers::mine() const {
  auto& own = parsers_[thread_number()];
  if (!own) own = std::make_unique<ParsedExpression>(text_, allowed_);
  return *own;
}

}  // namespace creepcontact
