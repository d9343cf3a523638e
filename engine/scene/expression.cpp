// SPDX-License-Identifier: BSD-3-Clause
/// muParser behind `Expression`.
#include "engine/scene/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <numbers>

namespace scarp {

struct Expression::Parser {
  Vec3 place{};
  mu::Parser parser;
};

namespace {

[[noreturn]] void fail(const mu::Parser::exception_type& error) {
  throw ExpressionError(fmt::format("at letter {}: {}", error.GetPos() + 1, error.GetMsg()));
}

}  // namespace

Expression::Expression(const std::string& text, const std::string& variables)
    : parser_(std::make_shared<Parser>()) {
  try {
    for (std::size_t a = 0; a < variables.size(); ++a) {
      parser_->parser.DefineVar(variables.substr(a, 1), &parser_->place[a]);
    }
    parser_->parser.DefineConst("pi", std::numbers::pi);
    parser_->parser.SetExpr(text);
  } catch (const mu::Parser::exception_type& error) {
    fail(error);
  }
  (*this)({});  // muParser compiles at the first evaluation
}

double Expression::operator()(const Vec3& place) const {
  parser_->place = place;
  try {
    return parser_->parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    fail(error);
  }
}

}  // namespace scarp
