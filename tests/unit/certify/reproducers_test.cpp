// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Rules that an encoder has had wrong: the certificate that would be right under the wrong rule is
// refused. Each has a twin that differs in that rule alone and is accepted.

#include "tests/unit/certify/judge.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <gmock/gmock.h>

namespace glider::ir::certify {
namespace {

using testing::IsEmpty;
using testing::Not;

constexpr const char* kYo = "  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n";

/// The same formula everywhere.
Formula always(std::string formula) {
  return [formula = std::move(formula)](const std::string&) { return formula; };
}

/// A formula in `a`, and `in_b` in `b`; nothing is said of other states: they must be unreachable.
Formula inAB(std::string in_a, std::string in_b) {
  return [in_a = std::move(in_a), in_b = std::move(in_b)](const std::string& words) {
    return words == "`a`" ? in_a : words == "`b`" ? in_b : std::string();
  };
}

TEST(Reproducers, AnIfOnUnknownRunsNeitherBranch) {
  NEEDS_CVC5();
  const auto mission = [](const char* initial) {
    return compiled(fmt::format(R"(mission m
require exit within 30 min
var limit : time = {} in 0 s .. 20 h
state a
begin
{}  sensors statetime, temp
  entry do if temp > 10 degC then set limit = 10 min else set limit = 20 min end end
  events
    case statetime >= limit exit
end
)",
                                initial, kYo));
  };
  const Formula formula = always(
      "(and |var limit known| (<= |var limit| 1200.0) (= |entered 0| 0.0)"
      " (or (= |time| 0.0) (< |time| 1200.0)))");
  EXPECT_THAT(judged(mission("10 h"), formula), Not(IsEmpty()));
  EXPECT_THAT(judged(mission("5 min"), formula), IsEmpty());
}

TEST(Reproducers, ArgumentsAreEvaluatedBeforeAnyParameterChanges) {
  NEEDS_CVC5();
  const auto mission = [](const char* again) {
    return compiled(fmt::format(R"(mission m
require never bad after a
state a
begin
{0}  sensors missiontime
  events
    case missiontime >= 20 s goto b(1, 9)
end
state b(x: number, y: number)
begin
{0}  sensors missiontime, statetime
  events
    case missiontime >= 30 min exit
    case x > 5 && y < 5 goto bad
    case statetime >= 5 min goto b({1})
end
state bad
begin
{0}  sensors missiontime
  events
    case missiontime >= 30 min exit
end
)",
                                kYo, again));
  };
  const Formula formula = inAB("true", "(and |var b.y known| (= |var b.y| 9.0))");
  EXPECT_THAT(judged(mission("y, x"), formula), Not(IsEmpty()));
  EXPECT_THAT(judged(mission("y, y"), formula), IsEmpty());
}

TEST(Reproducers, CommandsOfCasesCount) {
  NEEDS_CVC5();
  const auto mission = [](const char* in_state, const char* in_always) {
    return compiled(fmt::format(R"(mission m
require always depth <= 25 m
always
  case missiontime >= 1 min do {1} end stay
state a
begin
{2}  sensors missiontime
  events
    case missiontime >= 1 min do {0} end stay
    case missiontime >= 1 h exit
end
)",
                                in_state, in_always, kYo));
  };
  const Formula formula = always("(<= |deepest| 25.0)");
  const char* const fine = "descend(20 m, 26 deg)";
  const char* const deep = "descend(21 m, 26 deg)";
  EXPECT_THAT(judged(mission(fine, fine), formula), IsEmpty());
  EXPECT_THAT(judged(mission(deep, fine), formula), Not(IsEmpty()));
  EXPECT_THAT(judged(mission(fine, deep), formula), Not(IsEmpty()));
  EXPECT_THAT(judged(mission(fine, "hover(20.5 m)"), formula), Not(IsEmpty()));
}

TEST(Reproducers, HeldForNoTimeIsTrueAtOnce) {
  NEEDS_CVC5();
  const auto mission = [](const char* least) {
    return compiled(fmt::format(R"(mission m
require never bad after a
param d : time = 50 s in {1} .. 100 s
var hit : bool = false
state a
begin
{0}  sensors missiontime, temp
  events
    case missiontime >= 20 s goto b
end
state b
begin
{0}  sensors missiontime, temp
  entry do if held(temp > 5 degC, d) then set hit = true end end
  events
    case hit goto bad
    case missiontime >= 30 min exit
end
state bad
begin
{0}  sensors missiontime
  events
    case missiontime >= 30 min exit
end
)",
                                kYo, least));
  };
  const Formula formula = inAB("(not |var hit true|)", "(not |var hit true|)");
  EXPECT_THAT(judged(mission("0 s"), formula), Not(IsEmpty()));
  EXPECT_THAT(judged(mission("1 s"), formula), IsEmpty());
}

TEST(Reproducers, WholeNumbersAreExactBelow2To53Only) {
  NEEDS_CVC5();
  const auto mission = [](const char* from, const char* most) {
    return compiled(fmt::format(R"(mission m
require never bad after a
var n : number = {1} in 0 .. {2}
var counted : bool = false
state a
begin
{0}  sensors missiontime
  events
    case counted && n <= {1} goto bad
    case missiontime >= 30 min exit
    case true do set n = min(n + 1, {2}) set counted = true end stay
end
state bad
begin
{0}  sensors missiontime
  events
    case missiontime >= 30 min exit
end
)",
                                kYo, from, most));
  };
  const auto formula = [](const char* from) {
    return inAB(fmt::format("(and |var n known| (>= |var n| {0}.0)"
                            " (or (not |var counted true|) (> |var n| {0}.0)))",
                            from),
                "");
  };
  EXPECT_THAT(judged(mission("9007199254740992", "9007199254740994"), formula("9007199254740992")),
              Not(IsEmpty()));
  EXPECT_THAT(judged(mission("4503599627370496", "4503599627370498"), formula("4503599627370496")),
              IsEmpty());
  // 2^53 - 1 and 1 are 2^53, which is exact; the rules only promise what is below.
  EXPECT_THAT(judged(mission("9007199254740990", "9007199254740991"), formula("9007199254740990")),
              IsEmpty());
}

TEST(Reproducers, TicksAreAsFarApartAsPowerCutsAllow) {
  NEEDS_CVC5();
  const auto mission = [](const char* resume) {
    return compiled(fmt::format(R"(mission m
resume within {1}
require exit within 61 min
state a
begin
{0}  sensors missiontime
  events
    case missiontime >= 1 h exit
end
)",
                                kYo, resume));
  };
  const Formula formula = always("(< |time| 3600.0)");
  EXPECT_THAT(judged(mission("10 h"), formula), Not(IsEmpty()));
  EXPECT_THAT(judged(mission("61 s"), formula), Not(IsEmpty()));
  EXPECT_THAT(judged(mission("60 s"), formula), IsEmpty());
  EXPECT_THAT(judged(mission("1 s"), formula), IsEmpty());
  EXPECT_EQ(longestGap(mission("1 s"), slocum()), 20);
}

}  // namespace
}  // namespace glider::ir::certify
