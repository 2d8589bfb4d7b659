// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/warnings.h"

#include "tests/unit/report/small_trace.h"

#include <gtest/gtest.h>

namespace glider::report {
namespace {

using Lines = std::vector<std::string>;

support::Trace flight(double active) {
  auto trace = smallTrace({{"time", "s"}, {"state", "id"}, {"hook_active", ""}},
                          {{0, kUnknown, 0}, {100, active == 1 ? 0.0 : kUnknown, active}});
  trace.state_names = {"s1", "s2"};
  trace.events = {{90, 80, "transition", "s1 → end (exit)", ""}};
  return trace;
}

TEST(Warnings, AFlightThatWentWellHasNone) {
  EXPECT_EQ(flightWarnings(flight(1)), Lines{});
  EXPECT_EQ(flightWarnings({}), Lines{});
}

TEST(Warnings, NeverInControl) {
  EXPECT_EQ(flightWarnings(flight(0)), Lines{"the mission was never in control"});
  auto without = flight(0);
  without.way = "none";
  EXPECT_EQ(flightWarnings(without), Lines{}) << "nobody expected it";
}

TEST(Warnings, AnotherMissionThanThatWhoseStatesAreNamed) {
  auto trace = flight(1);
  trace.mission = "front";
  trace.events.push_back({4, kUnknown, "link", "the SBC answers: mission front", ""});
  EXPECT_EQ(flightWarnings(trace), Lines{});
  trace.events.back().what = "the SBC answers: mission patch";
  EXPECT_EQ(flightWarnings(trace), Lines{"the SBC flies mission patch, not front: the names of its "
                                         "states are those of the wrong mission"});
  trace.state_names.clear();
  EXPECT_EQ(flightWarnings(trace), Lines{}) << "none was named";
}

TEST(Warnings, RefusedInstructionsAreCounted) {
  auto trace = flight(1);
  trace.events.push_back({8, 4, "hook", "instruction 1 refused: deeper than max_depth", ""});
  trace.events.push_back({12, 8, "hook", "instruction 2 refused: it is no command", ""});
  trace.events.push_back({16, 8, "hook", "hookbeh: climb: too deep (m_depth 30.1 m)", ""});
  EXPECT_EQ(refusedInstructions(trace), 2U);
  EXPECT_EQ(flightWarnings(trace),
            Lines{"2 instructions refused, the first at 8 s: instruction 1 refused: deeper than "
                  "max_depth"});
}

TEST(Warnings, AnUnknownDeclination) {
  auto trace = flight(1);
  trace.events.push_back({8, 0, "log", "declination unknown: headings are magnetic", ""});
  ASSERT_EQ(flightWarnings(trace).size(), 1U);
  EXPECT_NE(flightWarnings(trace)[0].find("`declination -12 deg`"), std::string::npos);
}

TEST(Warnings, AMissionThatHadNotEnded) {
  auto trace = flight(1);
  trace.events.push_back({100, 90, "log", "the simulated time of 100 s is over", ""});
  EXPECT_EQ(flightWarnings(trace), Lines{}) << "the layered control flew on";
  trace.events.erase(trace.events.begin());
  EXPECT_EQ(flightWarnings(trace),
            Lines{"the mission had not ended when the simulated time was over; never visited: s2"});
}

}  // namespace
}  // namespace glider::report
