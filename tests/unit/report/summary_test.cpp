// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/summary.h"

#include "report/text.h"
#include "tests/report/sample_trace.h"
#include "tests/unit/report/small_trace.h"

#include <gtest/gtest.h>

namespace glider::report {
namespace {

using support::unlistedEvent;

support::Trace figure2() {
  auto trace = smallTrace(
      {{"time", "s"}, {"m_depth", "m"}, {"state", "id"}, {"true_x", "m"}, {"true_y", "m"}},
      {{0, 0, kUnknown, 0, 0},
       {100, 10, 0, 30, 0},
       {200, 5, 0, 60, 0},
       {600, 20, 1, 180, 0},
       {1600, 0, 0, 480, 400}});
  trace.state_names = {"s1", "s2"};
  trace.events = {
      unlistedEvent(100, 0, "control", "hookbeh in control", "the SBC asked for it"),
      unlistedEvent(600, 500, "transition", "s1 → s2 (call)",
                    "missiontime >= 500 && missiontime < 1500: missiontime = 500"),
      unlistedEvent(1600, 1500, "transition", "s2 → s1 (return)",
                    "missiontime >= 1500: missiontime = 1500"),
      unlistedEvent(1600, kUnknown, "abort", "MS_ABORT_OVERDEPTH", ""),
  };
  return trace;
}

TEST(Summary, SaysWhatTheFlightCameTo) {
  EXPECT_EQ(summarize(figure2()), R"(survey, scenario shelf, flown on host, seed 3
  duration     26:40 (1600 s)
  depth        0.0 to 20.0 m, 2 yos
  distance     680 m over ground, 625 m made good

states              visits       time  share
  s1                     2      500 s   31 %
  s2                     1     1000 s   62 %
  (layered control)             100 s    6 %

transitions
       time   mission
      600 s     500 s  s1 → s2 (call)  missiontime >= 500 && missiontime < 1500: missiontime = 500
     1600 s    1500 s  s2 → s1 (return)  missiontime >= 1500: missiontime = 1500

other events
       time   mission
      100 s       0 s  control     hookbeh in control  the SBC asked for it
     1600 s         -  abort       MS_ABORT_OVERDEPTH
)");
}

TEST(Summary, OfNothingIsAWordAboutIt) {
  EXPECT_EQ(summarize({}), "flight, seed 0\n  nothing was recorded\n");
}

/// The widest line of `text`, in columns.
size_t widest(const std::string& text) {
  size_t most = 0;
  for (size_t at = 0; at < text.size();) {
    const size_t end = text.find('\n', at);
    most = std::max(most, width(text.substr(at, end - at)));
    at = end + 1;
  }
  return most;
}

TEST(Summary, KeepsToAHundredColumnsAndToPrintableText) {
  for (const support::Trace& trace : {sampleTrace(), hostileTrace(), bareTrace()}) {
    const std::string text = summarize(trace);
    EXPECT_LE(widest(text), 100U);
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.back(), '\n');
  }
}

TEST(Summary, ShowsUpToSixtyEventsOfEachListAndTheLastOfThem) {
  const auto with = [](size_t count, const char* kind) {
    support::Trace trace = smallTrace({{"time", "s"}}, {{0}, {4}});
    for (size_t i = 1; i <= count; ++i) {
      trace.events.push_back(
          unlistedEvent(1, kUnknown, kind, "note " + std::to_string(i) + ".", ""));
    }
    return summarize(trace);
  };
  for (const char* kind : {"log", "transition"}) {
    EXPECT_NE(with(60, kind).find("note 60."), std::string::npos) << kind;
    EXPECT_EQ(with(60, kind).find("more: see the report"), std::string::npos);
    EXPECT_NE(with(61, kind).find("  and 1 more: see the report\n"), std::string::npos);
    EXPECT_EQ(with(61, kind).find("note 61."), std::string::npos);
    EXPECT_NE(with(61, kind).find("note 60."), std::string::npos);
  }
  EXPECT_EQ(with(5, "steering").find("note"), std::string::npos);
}

TEST(Summary, ManyEventsAreCounted) {
  support::Trace trace = figure2();
  trace.events.insert(trace.events.end(), 1000, unlistedEvent(1, kUnknown, "log", "note", ""));
  const std::string text = summarize(trace);
  EXPECT_NE(text.find("  and 942 more: see the report\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace glider::report
