#include "cvt/formula.h"

#include <clocale>
#include <cmath>
#include <cstddef>
#include <locale>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "ucvt/error.h"

namespace ucvt {
namespace {

const ModelPoint on_sphere{0.48, 0.6, 0.64};

/// What the constructor says of a formula; empty when it takes it.
std::string complaint(const std::string& formula, double kappa = 1) {
  try {
    const DensityFormula density(formula, kappa);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

TEST(DensityFormula, KnowsTheModelCoordinates) {
  for (const double kappa : {1.0, 0.0, -1.0}) {
    const DensityFormula f("x + 10*y + 100*z", kappa);
    EXPECT_DOUBLE_EQ(f({0.25, 0.5, 2}), 205.25) << kappa;
    EXPECT_FALSE(f.is_constant());
  }
}

TEST(DensityFormula, KnowsLongitudeAndLatitudeOnTheSphere) {
  EXPECT_DOUBLE_EQ(DensityFormula("lon", 1)(on_sphere), std::atan2(0.6, 0.48));
  EXPECT_DOUBLE_EQ(DensityFormula("1 + lat", 1)(on_sphere), 1 + std::asin(0.64));
  EXPECT_DOUBLE_EQ(DensityFormula("2 + lat", 1)({0, 0, -1}), 2 - std::numbers::pi / 2);
  EXPECT_NE(complaint("klein_x"), "");
}

TEST(DensityFormula, KnowsCentralCoordinatesElsewhere) {
  for (const double kappa : {0.0, -1.0}) {
    EXPECT_DOUBLE_EQ(DensityFormula("klein_x + 10*klein_y", kappa)({0.5, 1, 2}), 5.25);
    EXPECT_NE(complaint("lat", kappa), "");
  }
}

TEST(DensityFormula, KnowsTheUsualFunctionsAndConstants) {
  const double x = on_sphere[0], y = on_sphere[1];
  const auto value = [](const char* formula) { return DensityFormula(formula, 1)(on_sphere); };
  const double wave = std::sin(std::numbers::pi * x) * std::sin(std::numbers::pi * y);
  EXPECT_NEAR(value("exp(-20*x^2 - 20*y^2) + 0.05*sin(pi*x)^2*sin(pi*y)^2"),
              std::exp(-20 * x * x - 20 * y * y) + 0.05 * wave * wave, 1e-15);
  EXPECT_DOUBLE_EQ(value("e^x"), std::exp(x));
  EXPECT_DOUBLE_EQ(value("max(x, y) + min(x, y) + abs(-x) + sqrt(y)"), 2 * x + y + std::sqrt(y));
  EXPECT_DOUBLE_EQ(value("x > 0.4 && y <= 0.6 ? 3 : 2e-3"), 3);
  EXPECT_DOUBLE_EQ(value("2 - x^2"), 2 - x * x);
}

TEST(DensityFormula, SaysWhatIsWrongAndWhere) {
  const std::string names = "; variables are x, y, z, lon, lat";
  EXPECT_EQ(complaint("x + q"), "density: unknown name 'q' at position 5" + names);
  EXPECT_EQ(complaint("1 + foo(x)"), "density: unknown name 'foo' at position 5" + names);
  EXPECT_EQ(complaint("lat + 1", -1),
            "density: unknown name 'lat' at position 1; variables are x, y, z, klein_x, klein_y");
  EXPECT_EQ(complaint("3 $ 4"),
            "density: cannot read '$' at position 3; use numbers such as 0.5 or 2e-3, names and "
            "the operators + - * / ^");
  EXPECT_EQ(complaint("2 +"), "density: the formula stops short at position 4; complete it");
  EXPECT_EQ(complaint("+"), "density: the formula stops short at position 2; complete it");
  EXPECT_EQ(complaint("_pi"),
            "density: cannot read '_pi' at position 1; use numbers such as 0.5 "
            "or 2e-3, names and the operators + - * / ^");
  EXPECT_EQ(complaint("sin(x"),
            "density: a parenthesis is still open at position 6; close it with ')'");
  EXPECT_EQ(complaint("sin(x))"),
            "density: unexpected parenthesis ')' at position 7; write an operator before '(', and "
            "as many ')' as '('");
  EXPECT_EQ(complaint("2x"),
            "density: unexpected 'x' at position 2; write an operator such as * before it");
  EXPECT_EQ(complaint("sin(x, y)"),
            "density: too many arguments for 'sin' at position 9; as in sin(x), atan2(y, x), "
            "max(x, y)");
  EXPECT_EQ(complaint("x = 3"),
            "density: unexpected '=' at position 3; give the value alone; == compares");
  EXPECT_EQ(complaint("1 + 0,5"),
            "density: the formula has 2 values; a comma belongs between the arguments of a "
            "function; decimals have a point");
  EXPECT_EQ(complaint(""),
            "density: the formula is empty; give one such as 'exp(-x^2 - y^2)', or none for "
            "uniform");
}

TEST(DensityFormula, RefusesWhateverIsNoFormulaInOneLine) {
  for (const char* formula :
       {"+",      "()",    "x ? 1", "1 : 2", "x y",   "x**2",    "\"a\"",
        "1.5.2",  "1e400", "2e",    "abs x", "max()", "sin",     "1 + \xc3\xa9",
        "x\n+ q", "x @ y", "rnd()", ",",     " ",     "x + \x01"}) {
    const std::string said = complaint(formula);
    EXPECT_EQ(said.rfind("density: ", 0), 0u) << formula;
    EXPECT_NE(said.find("; "), std::string::npos) << said;
    EXPECT_EQ(
        said.find_first_not_of(" !\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[]^_"
                               "abcdefghijklmnopqrstuvwxyz"),
        std::string::npos)
        << said;
  }
}

TEST(DensityFormula, RefusesValuesThatAreNoDensity) {
  const auto complaint_at = [](const char* formula, const ModelPoint& p) -> std::string {
    try {
      const double value = DensityFormula(formula, 1)(p);
      return "accepted " + std::to_string(value);
    } catch (const InvalidInput& error) {
      return error.what();
    }
  };
  EXPECT_EQ(complaint_at("x - 1", on_sphere),
            "density: -0.52 at (x, y, z) = (0.48, 0.6, 0.64); it must be finite and not negative");
  for (const char* formula : {"1/(x - x)", "sqrt(-z)", "log(-y)"}) {
    EXPECT_NE(complaint_at(formula, on_sphere).find("must be finite"), std::string::npos);
  }
  EXPECT_DOUBLE_EQ(DensityFormula("x - x", 1)(on_sphere), 0);
}

TEST(DensityFormula, TellsConstants) {
  for (const char* formula : {"1", "2*pi - e", "exp(0)", "max(1, 2)"}) {
    EXPECT_TRUE(DensityFormula(formula, 0).is_constant()) << formula;
  }
  EXPECT_DOUBLE_EQ(DensityFormula("2*pi", 0)({0.1, 0.2, 1}), 2 * std::numbers::pi);
  for (const char* formula : {"x", "1 + 0*z", "klein_y^2"}) {
    EXPECT_FALSE(DensityFormula(formula, 0).is_constant()) << formula;
  }
  for (const char* formula : {"0", "-1", "1/0", "sqrt(-1)"}) {
    EXPECT_NE(complaint(formula).find("it must be finite and positive"), std::string::npos);
  }
}

/// Writes decimals with a comma, as many countries do.
struct CommaPoint : std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
};

TEST(DensityFormula, ReadsDecimalsAlikeInEveryLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPoint));
  const double value = DensityFormula("x + 0.25", 0)({1, 0, 1});
  const std::string said = complaint("-0.5");
  std::locale::global(before);
  EXPECT_DOUBLE_EQ(value, 1.25);
  EXPECT_NE(said.find("-0.5"), std::string::npos) << said;
}

TEST(DensityFormula, MayBeCalledFromManyThreads) {
  const DensityFormula f("exp(-x^2) + sin(lon)^2 + (y > 0 ? lat^2 : z^2)", 1), copy = f;
  const auto point = [](std::size_t i) {
    const double t = 0.001 * static_cast<double>(i), r = std::cos(3 * t);
    return ModelPoint{r * std::cos(t), r * std::sin(t), std::sin(3 * t)};
  };
  constexpr std::size_t n = 20000;
  std::vector<double> serial(n), parallel(n);
  for (std::size_t i = 0; i < n; ++i) {
    serial[i] = f(point(i));
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 50), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      parallel[i] = copy(point(i));
    }
  });
  EXPECT_EQ(serial, parallel);
}

}  // namespace
}  // namespace ucvt
