#include "creepcontact/base/named_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "parsed_expression.hpp"

namespace creepcontact {

struct NamedExpression::Parsed {
  mu::Parser parser;
  std::vector<double> values;  // the parser's variables point in here
  std::vector<std::size_t> used;
};

bool NamedExpression::can_be_variable(const std::string& name) {
  const auto is_word = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0 ||
      !std::ranges::all_of(name, is_word))
    return false;
  static const mu::Parser language = [] {
    mu::Parser parser;
    define_language(parser);
    return parser;
  }();
  return !language.GetFunDef().contains(name) && !language.GetConst().contains(name);
}

NamedExpression::NamedExpression(const std::string& text, const std::vector<std::string>& names)
    : parsed_(std::make_shared<Parsed>()) {
  reject_assignment(text);
  parsed_->values.assign(names.size(), 1.0);
  mu::Parser& parser = parsed_->parser;
  try {
    define_language(parser);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (can_be_variable(names[i])) parser.DefineVar(names[i], &parsed_->values[i]);
    parser.SetExpr(text);
    parser.Eval();
    if (parser.GetNumResults() != 1)
      throw std::invalid_argument(
          fmt::format("'{}': {} values separated by commas; only one is allowed", text, parser.GetNumResults()));
    const auto variables = parser.GetUsedVar();
    for (std::size_t i = 0; i < names.size(); ++i)
      if (variables.contains(names[i])) parsed_->used.push_back(i);
    parser.Eval();  // compiles again: looking for variables dropped the byte code
  } catch (const mu::ParserError& error) {
    const std::string message = fmt::format("'{}': {} (position {})", text, error.GetMsg(), error.GetPos());
    const std::string& token = error.GetToken();
    const bool is_name = !token.empty() && (std::isalpha(static_cast<unsigned char>(token.front())) != 0);
    if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN && is_name) throw UnknownName(message, token);
    throw std::invalid_argument(message);
  }
}

const std::vector<std::size_t>& NamedExpression::used() const {
  return parsed_->used;
}

double NamedExpression::operator()(std::span<const double> values) const {
  std::ranges::copy(values, parsed_->values.begin());
  return parsed_->parser.Eval();
}

}  // namespace creepcontact
