#pragma once
/// Expressions compiled by muParser, which keeps the values of the variables: one parser per thread.

#include <muParser.h>

#include <memory>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"

namespace creepcontact {

/// Constants and functions of the program's own, the same in all expressions.
void define_language(mu::Parser& parser);

/// The parser would take `x = 3` for an assignment, which no expression can mean. @throws std::invalid_argument
void reject_assignment(const std::string& text);

struct ParsedExpression {
  /// @throws mu::ParserError, also for names that are not allowed
  ParsedExpression(const std::string& text, const std::vector<std::string>& allowed);
  ParsedExpression(const ParsedExpression&) = delete;
  ParsedExpression& operator=(const ParsedExpression&) = delete;
  double value(const Arguments& at) {
    bound = at;
    return parser.Eval();
  }

  Arguments bound;  // the parser's variables point in here
  mu::Parser parser;
};

/// A parser for each thread, made when the thread first asks for it.
class ThreadParsers {
 public:
  /// Makes that of the calling thread.
  ThreadParsers(std::string text, std::vector<std::string> allowed);
  ParsedExpression& mine() const;

 private:
  std::string text_;
  std::vector<std::string> allowed_;
  mutable std::vector<std::unique_ptr<ParsedExpression>> parsers_;  // each touched by its thread alone
};

}  // namespace creepcontact
