// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/summary.h"

#include "report/text.h"
#include "tests/report/sample_trace.h"
#include "tests/unit/report/small_trace.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::report {
namespace {

using support::makeEvent;
using support::unlistedEvent;
using ::testing::HasSubstr;

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

states             current       time  share
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

TEST(Summary, NamesWhatFliesTheVehicleWithoutTheSbc) {
  support::Trace trace = figure2();
  trace.own_control = "DUNE";
  EXPECT_THAT(summarize(trace), HasSubstr("\n  (DUNE)                      100 s    6 %\n"));
  trace.way = "none";
  EXPECT_THAT(summarize(trace), HasSubstr(", flown by DUNE alone, "));
}

TEST(Summary, ShowsHowLongTheEnergyLasts) {
  auto flown = [](double used_Wh, double to_go_Wh) {
    auto trace = smallTrace({{"time", "s"}, {"energy", "Wh"}}, {{0, 0}, {3600, used_Wh}});
    trace.battery = {1000, 1000 - to_go_Wh - used_Wh};
    return summarize(trace);
  };
  EXPECT_NE(flown(5, 19.5).find("5.0 Wh used, 0.50 % of the pack; 19.5 Wh to go (1.95 %), 3.9 h at "
                                "this rate\n"),
            std::string::npos)
      << flown(5, 19.5);
  EXPECT_NE(flown(5, 500).find(" to go (50.0 %), 4.2 days at this rate\n"), std::string::npos);
  EXPECT_NE(flown(1, 500).find(", 21 days at this rate\n"), std::string::npos);
}

TEST(Summary, HasTheBoundOfTheEnergyBesideIt) {
  auto trace = smallTrace({{"time", "s"}, {"energy", "Wh"}}, {{0, 0}, {3600, 5}});
  EXPECT_EQ(summarize(trace).find("bound"), std::string::npos);
  trace.facts.at_most = {{"pump", 12.25}, {"SBC", 30}};
  EXPECT_THAT(summarize(trace),
              HasSubstr("\n    bound      at most 42.3 Wh until the mission ends\n"));
  trace.battery = {42, 0};
  EXPECT_THAT(summarize(trace), HasSubstr("at most 42.3 Wh until the mission ends, more than the "
                                          "42 Wh of a full pack\n"));
  trace.battery.reset();
  trace.facts.at_most = {{"pump", 4.25}};
  EXPECT_THAT(summarize(trace), HasSubstr("mission ends; the flight took more, after its end"));
}

TEST(Summary, NamesTheStatesThatWereNeverEntered) {
  support::Trace trace = smallTrace({{"time", "s"}, {"state", "id"}}, {{0, 1}, {4, 1}});
  trace.state_names = {"out", "home"};
  EXPECT_THAT(summarize(trace), HasSubstr("\n  never entered in this flight: `out`\n"));
  trace.events = {makeEvent(1, support::EventId::Transition, {"out", "home", "goto"})};
  EXPECT_EQ(summarize(trace).find("never entered"), std::string::npos)
      << "for a tick, at the start";
  trace.events = {};
  trace.state_names = {};
  EXPECT_EQ(summarize(trace).find("never entered"), std::string::npos);
}

TEST(Summary, TellsYosFromTheSwingsOfAHover) {
  const auto flown = [](std::initializer_list<std::vector<double>> rows) {
    return summarize(smallTrace({{"time", "s"}, {"m_depth", "m"}, {"hook_vertical", ""}}, rows));
  };
  EXPECT_THAT(flown({{0, 0, 1}, {9, 23, 3}, {18, 19, 3}, {27, 22, 3}, {36, 0, 4}}),
              HasSubstr(" m, 1 yo and 1 swing about the depth of a hover\n"));
  EXPECT_THAT(flown({{0, 0, 1}, {9, 23, 2}, {18, 5, 1}, {27, 22, 2}, {36, 0, 4}}),
              HasSubstr(" m, 2 yos\n"));
}

TEST(Summary, SaysInWhichTimeTheEnergyIsKnown) {
  const auto trace = smallTrace({{"time", "s"}, {"energy", "Wh"}},
                                {{0, kUnknown}, {3600, kUnknown}, {5400, 0}, {7200, 7.7}});
  EXPECT_NE(summarize(trace).find("7.7 Wh used in 30:00 of the flight, not known for the rest\n"),
            std::string::npos)
      << summarize(trace);
}

TEST(Summary, ShowsAnEventInItsTextForPeople) {
  support::Trace trace = smallTrace({{"time", "s"}}, {{0}, {4}});
  trace.events = {unlistedEvent(1, 1, "log", "bloom at 11.7794151306", "")};
  trace.events[0].shown = "bloom at 11.779 m";
  const std::string text = summarize(trace);
  EXPECT_NE(text.find("bloom at 11.779 m\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("7794151306"), std::string::npos);
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

TEST(Summary, SaysForHowLongTheSbcSlept) {
  support::Trace trace = smallTrace({{"time", "s"}}, {{0}, {400}});
  EXPECT_EQ(summarize(trace).find("asleep"), std::string::npos);
  const auto at = [&](double time_s, support::EventId id) {
    support::TraceEvent event = unlistedEvent(time_s, kUnknown, "steering", "it sleeps", "");
    event.id = id;
    trace.events.push_back(event);
  };
  at(20, support::EventId::SbcSleeps);
  at(80, support::EventId::SbcWoken);
  at(100, support::EventId::SbcSleeps);
  at(240, support::EventId::SbcWoken);
  at(390, support::EventId::SbcSleeps);  // and never wakes
  EXPECT_NE(summarize(trace).find("SBC asleep   50.0 % of the flight, 3 times\n"),
            std::string::npos)
      << summarize(trace);
  trace.battery = {1000, 100};
  EXPECT_EQ(summarize(trace).find("asleep_W"), std::string::npos);
  trace.battery->sleep_saves = false;
  EXPECT_NE(
      summarize(trace).find(
          "SBC asleep   50.0 % of the flight, 3 times; it saves nothing: no lower `asleep_W` is "
          "given\n"),
      std::string::npos)
      << summarize(trace);
}

TEST(Summary, ManyEventsAreCounted) {
  support::Trace trace = figure2();
  trace.events.insert(trace.events.end(), 1000, unlistedEvent(1, kUnknown, "log", "note", ""));
  const std::string text = summarize(trace);
  EXPECT_NE(text.find("  and 942 more: see the report\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace glider::report
