// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the parser makes of brackets and texts that are not closed, and of the limits of an
// expression.

#include "support/diagnostics/ids/syntax.h"
#include "tests/unit/frontend/compile.h"

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;

// The limits as the messages say them.
constexpr size_t kDeepestNesting = 200;
constexpr size_t kMostOperators = 1000;

std::string withGuard(const std::string& guard) {
  return "mission t\nstate s\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
         "  sensors depth, temp, missiontime\n  events\n    case " +
         guard + " exit\nend\n";
}

/// What was reported, by number, in the order of the text.
std::string reported(const std::string& text) {
  FrontendRun run(text);
  (void)run.parse();
  std::string all;
  for (const support::Diagnostic& d : run.diagnostics.sorted()) {
    all += (all.empty() ? "" : " ") + support::code(d.id);
  }
  return all;
}

std::string repeated(std::string_view text, size_t times) {
  std::string out;
  for (size_t i = 0; i < times; ++i) {
    out += text;
  }
  return out;
}

TEST(Parentheses, NestUpToTheLimit) {
  const auto nested = [](size_t deep) {
    return withGuard(repeated("(", deep) + "depth > 7 m" + repeated(")", deep));
  };
  EXPECT_EQ(reported(nested(kDeepestNesting)), "");
  EXPECT_EQ(reported(nested(kDeepestNesting + 1)),
            support::code(support::diagnostics::nestedTooDeep));
}

TEST(Parentheses, AStrayOneIsNamedAndTheRestIsRead) {
  const std::string stray = support::code(support::diagnostics::strayParenthesis);
  EXPECT_EQ(reported(withGuard("depth > 7 m)")), stray);
  EXPECT_EQ(reported(withGuard("depth > 7 m]")), stray);
  EXPECT_EQ(reported(withGuard("(depth > 7 m]) && temp > 3 degC")), stray)
      << "the wrong kind closes nothing";
  EXPECT_EQ(reported(withGuard("(depth > 7 m)) && (temp > 3 degC)")), stray);
  EXPECT_EQ(reported(withGuard("(depth > 7 m) && (temp > 3 degC)")), "");
}

TEST(Parentheses, AnOpenOneIsClosedBeforeTheNextKeyword) {
  EXPECT_EQ(reported(withGuard("(depth > 7 m && temp > 3 degC")),
            support::code(support::diagnostics::missingParenthesis));
  EXPECT_EQ(reported(withGuard("((depth > 7 m && temp > 3 degC")),
            support::code(support::diagnostics::missingParenthesis) + " " +
                support::code(support::diagnostics::missingParenthesis));
}

TEST(Operators, AreCountedUpToTheLimit) {
  const std::string too_long = support::code(support::diagnostics::expressionTooLong);
  const auto sum = [](size_t operators) { return "depth" + repeated(" + 1", operators); };
  // The comparison is one more.
  EXPECT_EQ(reported(withGuard(sum(kMostOperators - 1) + " > 7 m")), "");
  EXPECT_EQ(reported(withGuard(sum(kMostOperators) + " > 7 m")), too_long);
}

TEST(Operators, ThoseInParenthesesCountWithTheRest) {
  const std::string too_long = support::code(support::diagnostics::expressionTooLong);
  const size_t half = kMostOperators / 2;
  const auto sum = [](size_t operators) { return "(depth" + repeated(" + 1", operators) + ")"; };
  // Two brackets, the plus between them and the comparison.
  EXPECT_EQ(reported(withGuard(sum(half - 1) + " + " + sum(half - 1) + " > 7 m")), "");
  EXPECT_EQ(reported(withGuard(sum(half) + " + " + sum(half) + " > 7 m")), too_long);
}

TEST(Operators, AnEqualsSignEndsNoExpression) {
  const auto compared = [](size_t times) {
    return withGuard("depth == 7 m" + repeated(" && depth == 7 m", times - 1));
  };
  const size_t half = kMostOperators / 2;  // each with an `==`, and an `&&` between them
  EXPECT_EQ(reported(compared(half)), "");
  EXPECT_EQ(reported(compared(half + 1)), support::code(support::diagnostics::expressionTooLong));
}

TEST(Operators, OfSeveralArgumentsTheLongestCounts) {
  const std::string too_long = support::code(support::diagnostics::expressionTooLong);
  const auto sum = [](size_t operators) { return "depth" + repeated(" + 1", operators); };
  const size_t most = kMostOperators - 1;
  EXPECT_EQ(reported(withGuard("max(" + sum(most) + ", " + sum(most) + ") > 7 m")), "");
  EXPECT_EQ(reported(withGuard("max(" + sum(most) + ", depth) + 1 > 7 m")), too_long);
  EXPECT_EQ(reported(withGuard("max(depth, " + sum(most) + ") + 1 > 7 m")), too_long);
  EXPECT_EQ(reported(withGuard("max(" + sum(kMostOperators + 1) + ", depth) > 7 m")), too_long);
}

TEST(Keywords, ThatNameAPlatformAreSaidToBeKeywords) {
  const std::string mission = withGuard("depth > 7 m");
  const std::string named = "mission t\nplatform end\n" + mission.substr(mission.find("state"));
  EXPECT_EQ(reported(named), support::code(support::diagnostics::keywordAsName));
}

/// Between the arguments of a name a comma is missing; `true` and its like end no list of
/// arguments.
TEST(Words, ThatAreValuesLeaveTheParenthesesOpen) {
  const std::string comma = support::code(support::diagnostics::missingComma);
  for (const char* before : {"depth", "true", "false", "not true", "true and false"}) {
    const std::string all = reported(withGuard("max(" + std::string(before) + ", 3910 7349) > 7"));
    EXPECT_TRUE(all.ends_with(comma)) << before << ": " << all;
  }
}

TEST(Texts, AnOpenOneEndsBeforeTheCommaOrTheEnd) {
  const auto with = [](const std::string& log) {
    return "mission t\nstate s\nbegin\n  flightprofile surfaced\n  sensors depth, missiontime\n"
           "  events\n    case missiontime > 20 min do log " +
           log + " end exit\nend\n";
  };
  const std::string open = support::code(support::diagnostics::openString);
  EXPECT_EQ(reported(with("\"deep\", depth")), "");
  EXPECT_EQ(reported(with("\"deep, depth")), open);
  EXPECT_EQ(reported(with("\"deep")), open) << "the `end` of its block is read";
  EXPECT_EQ(reported(with("\"deep enough")), open);
  const std::string more = reported(with("\"deep, depth +"));
  EXPECT_TRUE(more.starts_with(open + " ")) << "what follows the comma is read: " << more;
}

}  // namespace
}  // namespace glider::frontend
