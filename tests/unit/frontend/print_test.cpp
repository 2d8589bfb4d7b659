// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// parse(print(ast)) == ast, for the whole language.

#include "tests/unit/frontend/compile.h"

#include <random>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;
using testing_support::readSource;

void expectRoundTrip(const std::string& text) {
  FrontendRun first(text);
  const auto ast = first.parse();
  ASSERT_TRUE(ast.has_value()) << first.said();
  const std::string printed = ast::print(*ast);
  FrontendRun second(printed);
  const auto again = second.parse();
  ASSERT_TRUE(again.has_value()) << second.said() << printed;
  EXPECT_TRUE(*again == *ast) << printed;
  EXPECT_EQ(ast::print(*again), printed);
}

TEST(Print, FilesComeBackEqual) {
  for (const char* path :
       {"missions/figure2.mission", "missions/figure5.mission", "missions/library/standard.mission",
        "tests/golden/parse/ok_language.mission", "tests/golden/parse/ok_layout.mission",
        "tests/golden/parse/ok_soft_keywords.mission", "tests/golden/parse/ok_numbers.mission",
        "tests/golden/parse/ok_parentheses.mission"}) {
    SCOPED_TRACE(path);
    expectRoundTrip(readSource(path));
  }
}

TEST(Print, DifferentMissionsDiffer) {
  const auto parsed = [](const std::string& expr) {
    return *FrontendRun("mission m const a = " + expr).parse();
  };
  EXPECT_TRUE(parsed("1 + 2") == parsed(" (1) /* one */ +\n2"));
  for (const char* other : {"1 - 2", "1 + 3", "1 + 2 m", "(1 + 2) + 3", "true", "-(1 + 2)",
                            "f(1, 2)", "[1, 2]", "a[1]"}) {
    EXPECT_FALSE(parsed("1 + 2") == parsed(other)) << other;
  }
}

/// A random expression, without regard to types.
std::string randomExpr(std::mt19937& random, int depth) {
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  static const char* const kLeaves[] = {"5",   "depth", ".5 degC/m", "39.2 N 73.9 W", "true",
                                        "3 W", "2 min", "track[1]",  "1e3 %"};
  static const char* const kOps[] = {
      "+", "-", "*", "/", "<", "<=", ">", ">=", "==", "!=", "&&", "||"};
  if (depth == 0) {
    return kLeaves[pick(std::size(kLeaves))];
  }
  switch (pick(6)) {
    case 0:
      return "-" + randomExpr(random, depth - 1);
    case 1:
      return "!" + randomExpr(random, depth - 1);
    case 2:
      return "min(" + randomExpr(random, depth - 1) + ", " + randomExpr(random, depth - 1) +
             " of depth)";
    case 3:
      return "[" + randomExpr(random, depth - 1) + "]";
    default:
      return "(" + randomExpr(random, depth - 1) + ") " + kOps[pick(std::size(kOps))] + " (" +
             randomExpr(random, depth - 1) + ")";
  }
}

TEST(Print, RandomExpressionsComeBackEqual) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    expectRoundTrip("mission m\nconst a = " + randomExpr(random, i % 6) + "\n");
  }
}

TEST(Print, NoParenthesisTooMany) {
  const auto printed = [](const std::string& expr) {
    const auto file = FrontendRun("mission m const a = " + expr).parse();
    return ast::print(std::get<ast::Const>(file->items.at(1)).value);
  };
  EXPECT_EQ(printed("((1 + (2 * 3)) - 4)"), "1 + 2 * 3 - 4");
  EXPECT_EQ(printed("1 - (2 - 3)"), "1 - (2 - 3)");
  EXPECT_EQ(printed("!((a && b) || !(c < 5 m))"), "!(a && b || !(c < 5 m))");
  EXPECT_EQ(printed("5 m / (min(2, 3))"), "5 m / min(2, 3)");
  EXPECT_EQ(printed("(-a) * -(b + c)"), "-a * -(b + c)");
}

}  // namespace
}  // namespace glider::frontend
