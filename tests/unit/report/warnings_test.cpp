// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/warnings.h"

#include "tests/unit/report/small_trace.h"

#include <gtest/gtest.h>

namespace glider::report {
namespace {

using Lines = std::vector<std::string>;
using support::EventId;
using support::makeEvent;

support::Trace flight(double active) {
  auto trace = smallTrace({{"time", "s"}, {"state", "id"}, {"hook_active", ""}},
                          {{0, kUnknown, 0}, {100, active == 1 ? 0.0 : kUnknown, active}});
  trace.state_names = {"s1", "s2"};
  trace.events = {makeEvent(90, EventId::MissionEnds, {"s1", "exit"})};
  return trace;
}

TEST(Warnings, AFlightThatWentWellHasNone) {
  EXPECT_EQ(flightNotes(flight(1)), Lines{});
  EXPECT_EQ(flightNotes({}), Lines{});
}

/// The messages of reportFlight, each with its code.
Lines reported(const support::Trace& trace) {
  support::DiagnosticEngine diagnostics;
  reportFlight(trace, diagnostics);
  Lines lines;
  for (const support::Diagnostic& d : diagnostics.sorted()) {
    lines.push_back(support::code(d.id) + " " + d.message);
    EXPECT_EQ(d.severity, support::Severity::Warning);
  }
  return lines;
}

// accepts: GL9370 accepts: GL9371 accepts: GL9372 accepts: GL9375
TEST(Warnings, AFlightThatWentWellIsNotReported) {
  EXPECT_EQ(reported(flight(1)), Lines{});
  EXPECT_EQ(reported({}), Lines{});
}

TEST(Warnings, NeverInControl) {
  EXPECT_EQ(reported(flight(0)), Lines{"GL9372 the mission was never in control of the vehicle"});
  auto without = flight(0);
  without.way = "none";
  EXPECT_EQ(reported(without), Lines{}) << "none was expected";
}

TEST(Warnings, AnSbcThatNeverAnsweredDiffersFromOneThatGotNoControl) {
  const auto hint = [](const support::Trace& trace) {
    support::DiagnosticEngine diagnostics;
    reportFlight(trace, diagnostics);
    return diagnostics.sorted().at(0).hint;
  };
  auto trace = flight(0);
  trace.events.push_back(makeEvent(4, EventId::SbcRefused, {}, "protocol 3"));
  trace.events.push_back(makeEvent(4, EventId::Note, {"the SBC answers: mission m"}));
  EXPECT_FALSE(spokeTheProtocol(trace)) << "a note can say anything";
  EXPECT_NE(hint(trace).find("never used this version of the hook protocol"), std::string::npos)
      << hint(trace);
  trace.events.push_back(makeEvent(4, EventId::SbcAnswers, {"m"}));
  EXPECT_TRUE(spokeTheProtocol(trace));
  EXPECT_EQ(hint(trace), "see the events for how far the SBC and the vehicle got");
}

TEST(Warnings, AnAbortIsReportedWithItsReason) {
  auto trace = flight(1);
  trace.events.push_back(makeEvent(50, EventId::Aborts, {"undervolts"}, "battery 10.9 V"));
  EXPECT_EQ(reported(trace),
            Lines{"GL9370 the vehicle aborted at 50 s: undervolts, battery 10.9 V"});
}

/// A flight in water of 996 m that ends at `depth_m`.
support::Trace endsAt(double depth_m) {
  support::Trace trace;
  trace.way = "none";
  trace.columns = {{"time", "s"}, {"true_depth", "m"}, {"water_depth", "m"}};
  trace.rows = {0, 0, 996, 4, depth_m, 996};
  return trace;
}

// accepts: GL5215 GL5216
TEST(Warnings, AFlightThatEndsOnTheBottomIsReported) {
  EXPECT_EQ(reported(endsAt(0)), Lines{});
  EXPECT_EQ(reported(endsAt(500)), Lines{}) << "its time was over";
  EXPECT_EQ(reported(endsAt(996)), Lines{"GL5215 the flight ended on the bottom, 996 m deep"});
  auto aborted = endsAt(995.8);
  aborted.events.push_back(makeEvent(50, EventId::Aborts, {"MS_ABORT_SAMEDEPTH"}));
  EXPECT_EQ(
      reported(aborted),
      (Lines{"GL5215 the flight ended on the bottom, 996 m deep, after the mission was aborted",
             "GL9370 the vehicle aborted at 50 s: MS_ABORT_SAMEDEPTH"}));
}

TEST(Warnings, AnAbortThatDoesNotBringTheVehicleUpIsReported) {
  auto trace = endsAt(700);
  trace.events.push_back(makeEvent(50, EventId::Aborts, {"MS_ABORT_OVERDEPTH"}));
  EXPECT_EQ(reported(trace),
            (Lines{"GL5216 the mission was aborted at 50 s, but the vehicle was still 700 m deep "
                   "when the simulated time was over",
                   "GL9370 the vehicle aborted at 50 s: MS_ABORT_OVERDEPTH"}));
  trace = endsAt(0.2);
  trace.events.push_back(makeEvent(50, EventId::Aborts, {"MS_ABORT_OVERDEPTH"}));
  EXPECT_EQ(reported(trace), Lines{"GL9370 the vehicle aborted at 50 s: MS_ABORT_OVERDEPTH"});
}

TEST(Warnings, TheFirstInterventionIsReportedAndAllAreCounted) {
  auto trace = flight(1);
  trace.events.push_back(makeEvent(16, EventId::GuardClimbs, {"climb: too deep", 30.1}));
  EXPECT_EQ(reported(trace),
            Lines{"GL9375 hookbeh intervened at 16 s: climb: too deep (m_depth 30.1 m)"});
  trace.events.push_back(makeEvent(20, EventId::GuardClimbs, {"climb: too near", 20.0}));
  EXPECT_EQ(reported(trace), Lines{"GL9375 hookbeh intervened at 16 s: climb: too deep (m_depth "
                                   "30.1 m); 2 times in total"});
  trace.events = {makeEvent(16, EventId::WriteRefused, {3.0}),
                  makeEvent(20, EventId::Steers, {"dive_to", 3.1})};
  EXPECT_EQ(reported(trace), Lines{}) << "steering is not an intervention";
}

TEST(Warnings, AsJson) {
  support::DiagnosticEngine diagnostics;
  auto trace = flight(0);
  trace.events.push_back(makeEvent(4, EventId::SbcAnswers, {"m"}));
  reportFlight(trace, diagnostics);
  EXPECT_EQ(
      warningsToJson(diagnostics.sorted(), {"cut \"short\""}),
      R"([{"code":"GL9372","hint":"see the events for how far the SBC and the vehicle got",)"
      R"("message":"the mission was never in control of the vehicle",)"
      R"("slug":"never-in-control"},{"code":"","hint":"","message":"cut \"short\"","slug":""}])");
  EXPECT_EQ(warningsToJson({}, {}), "[]");
}

TEST(Warnings, AFolderForThePortIsCheckedAtTheDock) {
  support::DiagnosticEngine diagnostics;
  reportFlight(flight(0), diagnostics, "survey-port");
  EXPECT_NE(diagnostics.sorted().front().hint.find("glidercc dock survey-port --port DEVICE"),
            std::string::npos);
}

TEST(Warnings, AnotherMissionThanThatWhoseStatesAreNamed) {
  auto trace = flight(1);
  trace.mission = "front";
  trace.events.push_back(makeEvent(4, EventId::SbcAnswers, {"front"}));
  EXPECT_EQ(flightNotes(trace), Lines{});
  trace.events.back() = makeEvent(4, EventId::SbcAnswers, {"patch"});
  EXPECT_EQ(flightNotes(trace), Lines{"the SBC flies mission patch, not front, so the state names "
                                      "shown are wrong"});
  trace.state_names.clear();
  EXPECT_EQ(flightNotes(trace), Lines{}) << "none was named";
}

TEST(Warnings, ALongNameIsTheSameAsFarAsTheLineShowsIt) {
  const auto warnings = [](const std::string& flown, const std::string& told) {
    auto trace = flight(1);
    trace.mission = flown;
    trace.events.push_back(makeEvent(4, EventId::SbcAnswers, {told}));
    return flightNotes(trace).size();
  };
  const std::string name(60, 'n');
  EXPECT_EQ(warnings(name, name.substr(0, 47)), 0U) << "47 bytes go over the line";
  EXPECT_EQ(warnings(name, name.substr(0, 46)), 1U) << "46 are a name of their own";
  EXPECT_EQ(warnings(name, std::string(47, 'x')), 1U);
  EXPECT_EQ(warnings(name.substr(0, 47), name.substr(0, 47)), 0U);
}

TEST(Warnings, OnlyEventsOfRefusedInstructionsAreCounted) {
  auto trace = flight(1);
  trace.events.push_back(makeEvent(8, EventId::InstructionRefused, {1.0, "deeper than max_depth"}));
  EXPECT_EQ(reported(trace),
            Lines{"GL9371 hookbeh refused a command at 8 s: deeper than max_depth"});
  trace.events.back() =
      makeEvent(8, EventId::Note, {"instruction 1 refused: deeper than max_depth"});
  EXPECT_EQ(refusedInstructions(trace), 0U) << "a note with the same text";
  trace.events.back() = makeEvent(8, EventId::InstructionIgnored, {1.0, "it is old"});
  EXPECT_EQ(refusedInstructions(trace), 0U);
}

/// The messages of reportUnusual.
Lines unusual(const support::Trace& trace) {
  support::DiagnosticEngine diagnostics;
  reportUnusual(trace, "look at it", diagnostics);
  Lines lines;
  for (const support::Diagnostic& d : diagnostics.sorted()) {
    lines.push_back(d.message);
    EXPECT_EQ(support::code(d.id), "GL9378");
    EXPECT_EQ(d.hint, "look at it");
  }
  return lines;
}

/// In control from 100 s on, at `end` s over.
support::Trace flightUntil(double end) {
  auto trace = flight(1);
  trace.events = {makeEvent(end, EventId::MissionEnds, {"s1", "exit"})};
  return trace;
}

TEST(Warnings, AMissionThatEndsAtOnceIsUnusual) {
  EXPECT_EQ(unusual(flightUntil(159)), Lines{"the mission ended 59 s after it had taken control"});
  EXPECT_EQ(unusual(flightUntil(160)), Lines{});
  EXPECT_EQ(unusual({}), Lines{});
}

TEST(Warnings, AnExitByACaseOfAlwaysIsAnEndToo) {
  auto trace = flightUntil(159);
  trace.events = {makeEvent(159, EventId::MissionEnds, {"s1", "exit, always case 2"}),
                  makeEvent(200, EventId::TimeIsOver, {200.0})};
  EXPECT_EQ(unusual(trace), Lines{"the mission ended 59 s after it had taken control"});
}

TEST(Warnings, AMissionThatHadNotEndedIsUnusual) {
  auto trace = flight(1);
  trace.events = {makeEvent(100, EventId::TimeIsOver, {100.0})};
  EXPECT_EQ(unusual(trace), Lines{"the mission had not ended when the simulated time was up; never "
                                  "visited (the time was too short, or no case led there): s2"});
  auto without = flight(0);
  without.events.push_back(makeEvent(100, EventId::TimeIsOver, {100.0}));
  without.events.erase(without.events.begin());
  EXPECT_EQ(flightNotes(without),
            Lines{"the mission had not ended when the simulated time was up (`--duration` flies "
                  "longer); it was never in control of the vehicle"});
}

/// 20 transitions within 5 min; transitions that are further apart are a busy mission.
TEST(Warnings, AMissionThatChangesItsStateAllTheTimeIsUnusual) {
  const auto restless = [](int count, double apart) {
    auto trace = flightUntil(9000);
    for (int i = 0; i < count; ++i) {
      const double time = 200 + apart * i;
      trace.events.insert(trace.events.end() - 1,
                          makeEvent(time, EventId::Transition, {"s1", "s2", "call"}));
    }
    return unusual(trace);
  };
  EXPECT_EQ(restless(20, 15),
            Lines{"from 200 s on the mission changed its state 20 times within 5 min"});
  EXPECT_EQ(restless(19, 4), Lines{});
  EXPECT_EQ(restless(40, 16), Lines{});
}

TEST(Warnings, ManyStatesThatWereNeverVisitedAreCounted) {
  auto trace = flight(1);
  trace.events = {makeEvent(100, EventId::TimeIsOver, {100.0})};
  trace.state_names.clear();
  for (int i = 0; i <= 20; ++i) {
    trace.state_names.push_back("s" + std::to_string(i));
  }
  EXPECT_TRUE(flightNotes(trace).at(0).ends_with(", s19, s20")) << "20 are named";
  trace.state_names.emplace_back("s21");
  EXPECT_TRUE(flightNotes(trace).at(0).ends_with(", s20 and 1 more"));
}

TEST(Warnings, InControlAtAnyTimeIsInControl) {
  auto trace = flight(0);
  EXPECT_TRUE(wasNeverInControl(trace));
  trace.rows[2] = 1;
  EXPECT_FALSE(wasNeverInControl(trace));
  trace.rows.clear();
  EXPECT_FALSE(wasNeverInControl(trace)) << "it did not fly";
  auto without = flight(0);
  without.way.clear();
  EXPECT_FALSE(wasNeverInControl(without));
}

TEST(Warnings, RefusedInstructionsAreCounted) {
  auto trace = flight(1);
  trace.events.push_back(makeEvent(8, EventId::InstructionRefused, {1.0, "deeper than max_depth"}));
  trace.events.push_back(makeEvent(12, EventId::InstructionRefused, {2.0, "it is not a command"}));
  trace.events.push_back(makeEvent(16, EventId::GuardClimbs, {"climb: too deep", 30.1}));
  EXPECT_EQ(refusedInstructions(trace), 2U);
  EXPECT_EQ(
      reported(trace),
      (Lines{"GL9371 hookbeh refused a command at 8 s: deeper than max_depth; 2 times in total",
             "GL9375 hookbeh intervened at 16 s: climb: too deep (m_depth 30.1 m)"}));
}

TEST(Warnings, AnUnknownDeclination) {
  auto trace = flight(1);
  trace.events.push_back(
      makeEvent(8, EventId::DeclinationUnknown, {"declination unknown: headings are magnetic"}));
  ASSERT_EQ(flightNotes(trace).size(), 1U);
  EXPECT_NE(flightNotes(trace)[0].find("`declination -12 deg`"), std::string::npos);
}

TEST(Warnings, AMissionThatHadNotEnded) {
  auto trace = flight(1);
  trace.events.push_back(makeEvent(100, EventId::TimeIsOver, {100.0}));
  EXPECT_EQ(flightNotes(trace), Lines{}) << "the layered control flew on";
  trace.events.erase(trace.events.begin());
  EXPECT_EQ(flightNotes(trace),
            Lines{"the mission had not ended when the simulated time was up (`--duration` flies "
                  "longer); never visited (the time was too short, or no case led there): s2"});
}

TEST(Warnings, TheBottomIsReportedWithTheFirstContact) {
  auto trace = flight(1);
  trace.events.push_back(makeEvent(50, EventId::TouchesBottom, {}, "14.0 m deep"));
  EXPECT_EQ(reported(trace), Lines{"GL9376 the vehicle touched the bottom at 50 s: 14.0 m deep"});
  trace.events.push_back(makeEvent(90, EventId::TouchesBottom, {}, "15.0 m deep"));
  EXPECT_EQ(reported(trace),
            Lines{"GL9376 the vehicle touched the bottom at 50 s: 14.0 m deep; 2 times in total"});
}

TEST(Warnings, EmptyBatteriesAreReportedWithWhatTookTheMost) {  // accepts: GL9398
  auto trace = flight(1);
  trace.battery = {1000, 10, {{"hotel", 300}, {"SBC", 600}, {"pump", 90}}};
  EXPECT_EQ(reported(trace), Lines{});
  trace.events.push_back(makeEvent(50, EventId::PackEmpty, {14.04}));
  EXPECT_EQ(reported(trace),
            Lines{"GL9398 the batteries were empty at 50 s, at 14.0 m: nothing worked any more"});
  support::DiagnosticEngine diagnostics;
  reportFlight(trace, diagnostics);
  EXPECT_EQ(diagnostics.sorted().at(0).hint, "most went to: SBC");
}

TEST(Warnings, OfALogHaveItsNotesAndTimesOfUtc) {
  auto trace = flight(1);
  trace.way = "";
  trace.log = support::VehicleLog{"comet", 1565364272, "", {"a note"}};
  trace.events = {makeEvent(30.5, EventId::Aborts, {"too deep"}, "mission status 7")};
  EXPECT_EQ(flightNotes(trace), Lines{"a note"});
  EXPECT_EQ(reported(trace),
            Lines{"GL9370 the vehicle aborted at 2019-08-09 15:25:02 UTC: too deep, "
                  "mission status 7"});
}

}  // namespace
}  // namespace glider::report
