// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/against_marks.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::report {
namespace {

constexpr double kBegin = 1719946527;

LoggedMoment at(double seconds, double depth_m) {
  return {kBegin + seconds, "", seconds / 3600, depth_m, 0};
}

FollowedStep step(double seconds, FollowedKind kind, const char* from, const char* to) {
  FollowedStep out;
  out.at = at(seconds, 12);
  out.kind = kind;
  out.from = from;
  out.to = to;
  return out;
}

/// A log whose time 0 is 100 s before kBegin, with one event of its own.
support::Trace log() {
  support::Trace trace;
  trace.log.emplace();
  trace.log->utc_s = kBegin - 100;
  trace.events.push_back(support::makeEvent(110, support::EventId::Surfaces));
  return trace;
}

TEST(AgainstMarks, ShowEachChangeOfStateAtItsTimeInTheLog) {
  AgainstLogs against;
  against.followed = {
      step(0, FollowedKind::Start, "", "look"), step(4, FollowedKind::Stay, "look", "look"),
      step(20, FollowedKind::Goto, "look", "track"), step(30, FollowedKind::Exit, "track", ""),
      step(40, FollowedKind::Gap, "look", "")};
  against.followed[2].guard = "temp < 12 degC";
  against.followed[2].values = {{"temp", 11.5, "degC"}};
  against.followed[3].always = true;
  support::Trace trace = log();
  markAgainst("tracker", against, trace);
  ASSERT_EQ(trace.events.size(), 5U) << "a case that stays is not a change of state";
  EXPECT_EQ(trace.events[0].time_s, 100);
  EXPECT_EQ(kindOf(trace.events[0]), "transition");
  EXPECT_EQ(textOf(trace.events[0]), "the mission would have started in look");
  EXPECT_EQ(trace.events[0].why, "depth 12.0 m");
  EXPECT_EQ(textOf(trace.events[1]), "at the surface") << "in the order of time";
  EXPECT_EQ(trace.events[2].time_s, 120);
  EXPECT_EQ(textOf(trace.events[2]), "look → track (goto)");
  EXPECT_EQ(trace.events[2].why, "temp < 12 degC (depth 12.0 m, temp 11.5 degC)");
  EXPECT_EQ(textOf(trace.events[3]), "track → end (exit, always)");
  EXPECT_EQ(textOf(trace.events[4]), "the log has a gap: the mission would have ended in look");
  ASSERT_EQ(trace.log->notes.size(), 1U);
  EXPECT_NE(trace.log->notes[0].find("the mission tracker would have made"), std::string::npos);
}

TEST(AgainstMarks, ShowWhereAGuardFlickers) {
  AgainstLogs against;
  LoggedCase of;
  of.state = "look";
  of.guard = "depth > 10 m";
  of.firings.resize(6);
  of.firings[2].at = at(8, 12);
  of.flickers = {{.first = 2, .count = 4, .seconds = 31.7}};
  LoggedCase always = of;
  always.state = "";
  against.cases = {of, always};
  support::Trace trace = log();
  markAgainst("tracker", against, trace);
  ASSERT_EQ(trace.events.size(), 3U);
  EXPECT_EQ(trace.events[0].time_s, 108);
  EXPECT_EQ(kindOf(trace.events[0]), "guard");
  EXPECT_EQ(textOf(trace.events[0]), "a guard of look flickers: true 4 times within 32 s");
  EXPECT_EQ(trace.events[0].why, "depth > 10 m");
  EXPECT_EQ(textOf(trace.events[1]), "a guard of `always` flickers: true 4 times within 32 s");
}

}  // namespace
}  // namespace glider::report
