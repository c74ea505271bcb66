#include "cvt/formula.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>
#include <tbb/enumerable_thread_specific.h>

#include "ucvt/error.h"

namespace ucvt {
namespace {

/// The values of the variables, in the order of `names_for`.
using Values = std::array<double, 5>;

std::array<std::string_view, 5> names_for(double kappa) {
  return kappa > 0 ? std::array<std::string_view, 5>{"x", "y", "z", "lon", "lat"}
                   : std::array<std::string_view, 5>{"x", "y", "z", "klein_x", "klein_y"};
}

[[noreturn]] void refuse(const std::string& problem, const std::string& remedy) {
  throw InvalidInput("density: " + problem + "; " + remedy);
}

/// The first word of `token`, printable and not too long, in quotes.
std::string quoted(std::string_view token) {
  constexpr std::size_t longest = 40;
  token = token.substr(0, std::min(token.find_first_of(" \t\r\n"), longest));
  std::string text = "'";
  for (const char c : token) {
    text += c > ' ' && c < '\x7f' ? c : '?';
  }
  return text + "'";
}

/// Says in our words what muParser found; `formula` has the variables `names`.
[[noreturn]] void refuse(const mu::ParserError& error, const std::string& formula, double kappa) {
  const std::size_t at = error.GetPos() < 0
                             ? formula.size()
                             : std::min(formula.size(), static_cast<std::size_t>(error.GetPos()));
  const std::string token = quoted(error.GetToken()), place = fmt::format("at position {}", at + 1);
  switch (error.GetCode()) {
    case mu::ecEMPTY_EXPRESSION:
      refuse("the formula is empty", "give one such as 'exp(-x^2 - y^2)', or none for uniform");
    case mu::ecUNASSIGNABLE_TOKEN:
      if (token.size() > 1 && (std::isalpha(static_cast<unsigned char>(token[1])) != 0)) {
        refuse(fmt::format("unknown name {} {}", token, place),
               fmt::format("variables are {}", fmt::join(names_for(kappa), ", ")));
      }
      refuse(fmt::format("cannot read {} {}", token, place),
             "use numbers such as 0.5 or 2e-3, names and the operators + - * / ^");
    case mu::ecUNEXPECTED_EOF:
    case mu::ecINTERNAL_ERROR:
    case mu::ecMISSING_ELSE_CLAUSE:
      refuse(fmt::format("the formula stops short {}", place), "complete it");
    case mu::ecMISSING_PARENS:
      refuse(fmt::format("a parenthesis is still open {}", place), "close it with ')'");
    case mu::ecUNEXPECTED_PARENS:
      refuse(fmt::format("unexpected parenthesis {} {}", token, place),
             "write an operator before '(', and as many ')' as '('");
    case mu::ecUNEXPECTED_VAL:
    case mu::ecUNEXPECTED_VAR:
    case mu::ecUNEXPECTED_FUN:
      refuse(fmt::format("unexpected {} {}", token, place),
             "write an operator such as * before it");
    case mu::ecTOO_MANY_PARAMS:
    case mu::ecTOO_FEW_PARAMS:
      refuse(fmt::format("too {} arguments for {} {}",
                         error.GetCode() == mu::ecTOO_MANY_PARAMS ? "many" : "few", token, place),
             "as in sin(x), atan2(y, x), max(x, y)");
    default:
      refuse(fmt::format("unexpected {} {}", token, place), "write a formula such as 1 + x^2*y");
  }
}

/// muParser would take '=' as an assignment to a variable.
void refuse_assignment(const std::string& formula) {
  const auto is_comparison = [&](std::size_t i) {
    return (i > 0 && std::string_view("<>=!").find(formula[i - 1]) != std::string_view::npos) ||
           (i + 1 < formula.size() && formula[i + 1] == '=');
  };
  for (std::size_t i = 0; i < formula.size(); ++i) {
    if (formula[i] == '=' && !is_comparison(i)) {
      refuse(fmt::format("unexpected '=' at position {}", i + 1),
             "give the value alone; == compares");
    }
  }
}

/// One thread's parser and the variables that it reads.
class Parser {
 public:
  Parser(const std::string& formula, double kappa) : sphere_(kappa > 0) {
    parser_.ClearConst();
    parser_.DefineConst("pi", std::numbers::pi);
    parser_.DefineConst("e", std::numbers::e);
    const auto names = names_for(kappa);
    for (std::size_t i = 0; i < names.size(); ++i) {
      parser_.DefineVar(std::string(names[i]), &values_[i]);
    }
    parser_.SetExpr(formula);
    parser_.Eval();  // finds the mistakes, which GetUsedVar sees differently
    const auto& used = parser_.GetUsedVar();
    uses_any_ = !used.empty();
    uses_angles_ = sphere_ && (used.count("lon") + used.count("lat")) > 0;
  }
  Parser(const Parser&) = delete;  // muParser holds pointers to values_
  Parser& operator=(const Parser&) = delete;
  ~Parser() = default;

  double operator()(const ModelPoint& p) {
    std::copy(p.begin(), p.end(), values_.begin());
    if (uses_angles_) {
      values_[3] = std::atan2(p[1], p[0]);
      values_[4] = std::atan2(p[2], std::hypot(p[0], p[1]));
    } else if (!sphere_) {
      values_[3] = p[0] / p[2];
      values_[4] = p[1] / p[2];
    }
    return parser_.Eval();
  }
  [[nodiscard]] bool uses_variables() const { return uses_any_; }
  [[nodiscard]] int results() const { return parser_.GetNumResults(); }

 private:
  Values values_{};
  mu::Parser parser_;
  bool sphere_, uses_any_ = false, uses_angles_ = false;
};

bool is_density(double value) {
  return std::isfinite(value) && value >= 0;
}

}  // namespace

/// muParser keeps its stack in the parser, so every thread gets its own, made on first use.
class DensityFormula::Parsers {
 public:
  Parsers(const std::string& formula, double kappa)
      : parsers_([formula, kappa] { return std::make_unique<Parser>(formula, kappa); }) {
    refuse_assignment(formula);
    try {
      Parser& parser = *parsers_.local();
      const double value = parser({0, 0, 1});
      if (parser.results() > 1) {
        refuse(fmt::format("the formula has {} values", parser.results()),
               "a comma belongs between the arguments of a function; decimals have a point");
      }
      if (!parser.uses_variables()) {
        constant_ = value;
      }
    } catch (const mu::ParserError& error) {
      refuse(error, formula, kappa);
    }
    if (constant_ && !(is_density(*constant_) && *constant_ > 0)) {
      refuse(fmt::format("the constant is {}", *constant_), "it must be finite and positive");
    }
  }
  double operator()(const ModelPoint& p) { return constant_ ? *constant_ : (*parsers_.local())(p); }
  [[nodiscard]] bool is_constant() const { return constant_.has_value(); }

 private:
  tbb::enumerable_thread_specific<std::unique_ptr<Parser>> parsers_;
  std::optional<double> constant_;
};

DensityFormula::DensityFormula(const std::string& formula, double kappa)
    : parsers_(std::make_shared<Parsers>(formula, kappa)) {}

double DensityFormula::operator()(const ModelPoint& p) const {
  const double value = (*parsers_)(p);
  if (!is_density(value)) {
    refuse(fmt::format("{} at (x, y, z) = ({:.6g}, {:.6g}, {:.6g})", value, p[0], p[1], p[2]),
           "it must be finite and not negative");
  }
  return value;
}

bool DensityFormula::is_constant() const {
  return parsers_->is_constant();
}

}  // namespace ucvt
