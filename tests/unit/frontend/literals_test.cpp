// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/literals.h"

#include "tests/unit/frontend/compile.h"

#include <numbers>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;

TEST(Literals, NumbersAreReadToTheLastBit) {
  EXPECT_EQ(parseNumber("0.1"), 0.1);
  EXPECT_EQ(parseNumber(".454"), .454);
  EXPECT_EQ(parseNumber("1e3"), 1000.0);
  EXPECT_EQ(parseNumber("1.7976931348623157e308"), 1.7976931348623157e308);
  EXPECT_EQ(parseNumber("1e309"), std::nullopt);
  EXPECT_EQ(parseNumber("1e-400"), 0.0);
  EXPECT_EQ(parseNumber("1e-310"), 0.0);  // subnormal: settles to zero, as arithmetic on board does
}

TEST(Literals, DegreesAndMinutes) {
  const auto value = [](std::string_view digits) { return parseDegreesMinutes(digits)->value(); };
  EXPECT_EQ(value("3910.5"), 39 + 10.5 / 60);
  EXPECT_EQ(value("7349.8058"), 73 + 49.8058 / 60);
  EXPECT_EQ(value("0"), 0);
  EXPECT_EQ(value("100"), 1);
  EXPECT_EQ(value("05.25"), 5.25 / 60);
  EXPECT_EQ(value("17959.9999"), 179 + 59.9999 / 60);
  EXPECT_EQ(value("3.9105e3"), 39 + 10.5 / 60);
  EXPECT_EQ(parseDegreesMinutes("3960")->minutes, 60);
  EXPECT_FALSE(parseDegreesMinutes("1e400").has_value());
}

/// The value of `const x = <text>`, as a sensor is compared with it.
double constant(const std::string& text) {
  FrontendRun run("mission t\nconst x = " + text +
                  "\nstate s begin flightprofile surfaced events case x == x exit end");
  const auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  return mission ? mission->exprs.front().number : 0;
}

TEST(Literals, UnitsGiveSi) {
  EXPECT_EQ(constant("26 deg"), 26 * (std::numbers::pi / 180));
  EXPECT_EQ(constant("2 h"), 7200);
  EXPECT_EQ(constant(".5 degC/m"), .5);
  EXPECT_EQ(constant("5 cm/s"), 5 * 1e-2);
  EXPECT_EQ(constant("50 %"), 50 * 1e-2);
  EXPECT_EQ(constant("1 Ah"), 3600);
  EXPECT_EQ(constant("2 km * 3"), 6000);
  EXPECT_EQ(constant("clamp(5 m, 1 m, 3 m) - -2 m"), 5);
  EXPECT_EQ(constant("sqrt(9 m*m)"), 3);
}

}  // namespace
}  // namespace glider::frontend
