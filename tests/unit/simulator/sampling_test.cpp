// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/memory.h"
#include "platforms/load/load_platform.h"
#include "simulator/slocum/flight/science_switches.h"
#include "simulator/slocum/own_mission.h"
#include "simulator/slocum/science/science_computer.h"
#include "tests/unit/simulator/behaviour_bench.h"
#include "tests/unit/simulator/flights.h"
#include "vehicles/slocum/mission_files/read.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

/// Which sensors of the vehicle are on: the behaviours sample, sensors_in and prepare_to_dive, as
/// the vehicle's documents state them.
namespace glider::simulator {
namespace {

namespace fs = std::filesystem;
constexpr double kNoSample = std::numeric_limits<double>::quiet_NaN();
constexpr int kCtd = 1, kFlbbcd = 48, kOptode = 54;
using State = Behaviour::State;

std::string sample(const std::string& arguments) {
  return "behavior: sample\n" + arguments;
}

/// What a sample orders in a cycle; negative: nothing.
double ordered(BehaviourBench& bench, const Situation& situation) {
  bench.run(situation);
  EXPECT_EQ(bench.commands.samples.size(), 1U);
  EXPECT_TRUE(bench.commands.anyIdle()) << "it commands no motor";
  return bench.commands.samples.at(0).period_s;
}

Situation in(DepthState state, double time_s = 100, double depth_m = 10) {
  return {.time_s = time_s, .depth_m = depth_m, .depth_rate_mps = 0.2, .depth_state = state};
}

TEST(Sample, StatesAreBitsDivingHoveringClimbingSurface) {
  const DepthState states[] = {DepthState::Diving, DepthState::Hovering, DepthState::Climbing,
                               DepthState::Surface};
  for (int mask = 0; mask < 16; ++mask) {
    for (int i = 0; i < 4; ++i) {
      BehaviourBench bench(sample(fmt::format(" b_arg: state_to_sample(enum) {}\n", mask)));
      EXPECT_EQ(ordered(bench, in(states[i])) == 0, (mask & 1 << i) != 0) << mask << " " << i;
    }
  }
}

TEST(Sample, DefaultsAreAllSensorsOnTheDive) {
  BehaviourBench bench(sample(""));
  EXPECT_EQ(ordered(bench, in(DepthState::Diving)), 0) << "as fast as possible";
  EXPECT_EQ(bench.commands.samples.at(0).sensor_type, 0);
  BehaviourBench climbing(sample(""));
  EXPECT_LT(ordered(climbing, in(DepthState::Climbing)), 0);
}

TEST(Sample, GoesOnForAWhileAfterTheStateHasChanged) {
  BehaviourBench bench(sample(" b_arg: sensor_type(enum) 1\n"));
  EXPECT_EQ(ordered(bench, in(DepthState::Diving, 100)), 0);
  EXPECT_EQ(ordered(bench, in(DepthState::Climbing, 115)), 0) << "15 s";
  EXPECT_LT(ordered(bench, in(DepthState::Climbing, 116)), 0);
  EXPECT_EQ(bench.commands.samples.at(0).sensor_type, kCtd);
  BehaviourBench at_once(sample(" b_arg: sample_time_after_state_change(s) 0\n"));
  EXPECT_EQ(ordered(at_once, in(DepthState::Diving, 100)), 0);
  EXPECT_LT(ordered(at_once, in(DepthState::Climbing, 104)), 0);
}

TEST(Sample, TimeBetweenReadingsAndDepthThatOverridesIt) {
  BehaviourBench timed(sample(" b_arg: intersample_time(s) 30\n"));
  EXPECT_EQ(ordered(timed, in(DepthState::Diving)), 30);
  BehaviourBench off(sample(" b_arg: intersample_time(s) -1\n"));
  EXPECT_LT(ordered(off, in(DepthState::Diving)), 0);
  BehaviourBench by_depth(
      sample(" b_arg: intersample_time(s) 30\n b_arg: intersample_depth(m) 5\n"));
  EXPECT_EQ(ordered(by_depth, in(DepthState::Diving)), 25) << "5 m at 0.2 m/s";
  Situation slower = in(DepthState::Diving);
  slower.depth_rate_mps = -0.1;
  EXPECT_EQ(ordered(by_depth, slower), 50);
  BehaviourBench not_by_depth(
      sample(" b_arg: intersample_time(s) 30\n b_arg: intersample_depth(m) 0\n"));
  EXPECT_EQ(ordered(not_by_depth, in(DepthState::Diving)), 30) << "above 0 only";
}

TEST(Sample, WithinItsDepths) {
  BehaviourBench bench(sample(" b_arg: min_depth(m) 5\n b_arg: max_depth(m) 50\n"));
  for (const auto& [depth, samples] :
       {std::pair(4.9, false), {5.0, true}, {50.0, true}, {50.1, false}}) {
    EXPECT_EQ(ordered(bench, in(DepthState::Diving, 100, depth)) >= 0, samples) << depth;
  }
  BehaviourBench plain(sample(" b_arg: state_to_sample(enum) 15\n"));
  EXPECT_EQ(ordered(plain, in(DepthState::Surface, 100, -0.3)), 0) << "noise at the surface";
  EXPECT_EQ(ordered(plain, in(DepthState::Diving, 100, 2000)), 0);
  EXPECT_LT(ordered(plain, in(DepthState::Diving, 100, 2000.5)), 0);
}

/// The yos, from 1, of which the dive (and the climb) is sampled.
std::string sampledYos(int nth) {
  BehaviourBench bench(
      sample(fmt::format(" b_arg: nth_yo_to_sample(nodim) {}\n b_arg: state_to_sample(enum) 5\n"
                         " b_arg: sample_time_after_state_change(s) 0\n",
                         nth)));
  std::string out;
  double now = 0;
  bench.run(in(DepthState::Surface, now));
  for (int yo = 1; yo <= 7; ++yo) {
    const bool dive = ordered(bench, in(DepthState::Diving, now += 4)) >= 0;
    bench.run(in(DepthState::Hovering, now += 4));
    const bool resumed = ordered(bench, in(DepthState::Diving, now += 4)) >= 0;
    const bool climb = ordered(bench, in(DepthState::Climbing, now += 4)) >= 0;
    EXPECT_EQ(dive, climb) << yo;
    EXPECT_EQ(dive, resumed) << "a hover is not the end of yo " << yo;
    out += dive ? std::to_string(yo) : "";
    if (yo == 3) {
      bench.run(in(DepthState::Surface, now += 4));
    }
  }
  return out;
}

TEST(Sample, EveryNthYo) {
  EXPECT_EQ(sampledYos(1), "1234567");
  EXPECT_EQ(sampledYos(0), "1234567");
  EXPECT_EQ(sampledYos(2), "1357") << "the first, and every second after it";
  EXPECT_EQ(sampledYos(3), "147");
  EXPECT_EQ(sampledYos(-1), "234567") << "without the first";
  EXPECT_EQ(sampledYos(-2), "246");
  EXPECT_EQ(sampledYos(-3), "36");
}

/// The periods of CTD, FLBBCD and optode under the settings `mission` with these orders.
std::vector<double> periods(const std::string& mission, const std::vector<SampleOrder>& orders) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const auto read = slocum::readMission(sources, sources.add("test.mi", mission), diagnostics);
  const SamplePeriods found = samplePeriods(orders, MissionVariables(*read));
  return {found.at(kCtd), found.at(kFlbbcd), found.at(kOptode)};
}

const std::string kApart = "sensor: c_science_all_on_enabled(bool) 0\n";
using Periods = std::vector<double>;

TEST(ScienceSwitches, OneForAllUnlessTheyAreApart) {
  EXPECT_EQ(periods("", {}), (Periods{0, 0, 0})) << "on, as nothing is said";
  EXPECT_EQ(periods("sensor: c_science_all_on(sec) 8\n", {}), (Periods{8, 8, 8}));
  EXPECT_EQ(periods("sensor: c_science_all_on(sec) -1\n", {}), (Periods{-1, -1, -1}));
  EXPECT_EQ(periods("sensor: c_profile_on(sec) -1\n", {}), (Periods{0, 0, 0})) << "together";
  EXPECT_EQ(periods("", {{kCtd, 5}}), (Periods{5, 5, 5})) << "one sample drives the whole bay";
  EXPECT_EQ(periods("sensor: c_science_all_on(sec) 8\n", {{0, -1}}), (Periods{-1, -1, -1}))
      << "sample decides";
  EXPECT_EQ(periods("sensor: c_science_all_on_enabled(bool) 1\n", {{kOptode, 2}}),
            (Periods{2, 2, 2}));
}

TEST(ScienceSwitches, EachByItself) {
  EXPECT_EQ(periods(kApart, {{kCtd, 5}, {kFlbbcd, -1}}), (Periods{5, -1, 0}));
  EXPECT_EQ(periods(kApart, {{0, 3}}), (Periods{3, 3, 3})) << "sensor_type 0 is all";
  EXPECT_EQ(periods(kApart + "sensor: c_profile_on(sec) -1\nsensor: c_oxy4_on(sec) 6\n"
                             "sensor: c_science_all_on(sec) 9\n",
                    {{kFlbbcd, 4}}),
            (Periods{-1, 4, 6}));
  EXPECT_EQ(periods(kApart + "sensor: c_flbbcd_on(sec) 7\n", {}), (Periods{0, 7, 0}));
  // Of two for one instrument, as for the dive and for the climb, that counts which samples.
  EXPECT_EQ(periods(kApart, {{kCtd, -1}, {kCtd, 5}}), (Periods{5, 0, 0}));
  EXPECT_EQ(periods(kApart, {{kCtd, 5}, {kCtd, -1}}), (Periods{5, 0, 0}));
  EXPECT_EQ(periods(kApart, {{kCtd, 5}, {kCtd, 3}}), (Periods{3, 0, 0}));
  EXPECT_EQ(periods(kApart, {{39, 5}}), (Periods{0, 0, 0})) << "another instrument";
}

TEST(SensorsIn, SetsItsOwnAboveTheMissionsAndBelowWhatIsPut) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const auto read = slocum::readMission(
      sources,
      sources.add("test.mi",
                  "sensor: c_alt_time(sec) 4\nsensor: c_gps_on(sec) 5\n"
                  "sensor: u_mission_param_b(X) 60\n"
                  "behavior: sensors_in\n b_arg: c_alt_time(sec) -1\n"
                  " b_arg: u_vacuum_time(sec) 1000001\n"
                  "behavior: sensors_in\n b_arg: c_alt_time(sec) 8\n b_arg: c_att_time(sec) 9\n"),
      diagnostics);
  MissionVariables variables(*read);
  EXPECT_EQ(variables.find("c_alt_time"), -1) << "the higher of the two";
  EXPECT_EQ(variables.find("c_att_time"), 9);
  EXPECT_EQ(variables.find("c_gps_on"), 5);
  EXPECT_EQ(variables.find("u_vacuum_time"), 60) << "a mission parameter";
  EXPECT_EQ(variables.find("c_pressure_time"), std::nullopt);
  variables.set("c_alt_time", 2);
  EXPECT_EQ(variables.find("c_alt_time"), 2);
}

TEST(PrepareToDive, HoldsTheVehicleUpUntilItHasAFix) {
  BehaviourBench bench("behavior: prepare_to_dive\n");
  bench.run({.time_s = 50});
  EXPECT_EQ(bench.state(), State::Active);
  EXPECT_TRUE(bench.behaviour->atWork());
  EXPECT_FALSE(bench.behaviour->flies());
  ASSERT_TRUE(bench.commands.pump_cc && bench.commands.pitch && bench.commands.heading);
  EXPECT_EQ(*bench.commands.pump_cc, 1000) << "as far out as it goes";
  EXPECT_EQ(*bench.commands.pitch, (PitchCommand{PitchCommand::Mode::Servo, 0.4538}));
  EXPECT_EQ(bench.commands.heading->mode, HeadingCommand::Mode::Fin);
  Commands below;
  below.steer({HeadingCommand::Mode::Heading, 1, 0, 0});
  bench.run({.time_s = 54}, below);
  EXPECT_EQ(bench.commands.heading->mode, HeadingCommand::Mode::Heading) << "may steer";
  bench.run({.time_s = 58, .gps_fix = true});
  EXPECT_EQ(bench.state(), State::Complete);
  EXPECT_FALSE(bench.behaviour->atWork());
  EXPECT_FALSE(bench.behaviour->endsMission());
  EXPECT_FALSE(bench.commands.pitch) << "so that a yo on pitch idle can start at once";
  bench.run({.time_s = 90});
  EXPECT_FALSE(bench.commands.pitch) << "it ends for good";
}

TEST(PrepareToDive, WaitsAtMostItsTime) {
  BehaviourBench plain("behavior: prepare_to_dive\n");
  plain.run({.time_s = 50});
  plain.run({.time_s = 769});
  EXPECT_EQ(plain.state(), State::Active);
  plain.run({.time_s = 770});
  EXPECT_EQ(plain.state(), State::Complete) << "720 s";
  BehaviourBench shorter("behavior: prepare_to_dive\n b_arg: wait_time(s) 300\n");
  shorter.run({.time_s = 0});
  shorter.run({.time_s = 300});
  EXPECT_EQ(shorter.state(), State::Complete);
  BehaviourBench idle("behavior: prepare_to_dive\n b_arg: start_when(enum) 1\n");
  Commands busy;
  busy.steer({});
  busy.point({});
  busy.pump(0);
  idle.run({.time_s = 0}, busy);
  EXPECT_EQ(idle.state(), State::Waiting);
  idle.run({.time_s = 4});
  EXPECT_EQ(idle.state(), State::Active);
}

const std::string kSurface =
    "behavior: surface\n b_arg: start_when(enum) 1\n b_arg: end_action(enum) 0\n";
const std::string kYo =
    "behavior: set_heading\n b_arg: use_heading(bool) 1\n b_arg: heading_value(rad) 0.5\n"
    "behavior: yo\n b_arg: num_half_cycles_to_do(nodim) 2\n b_arg: d_target_depth(m) 25\n"
    " b_arg: c_target_depth(m) 3\n b_arg: end_action(enum) 0\n";

/// How many rows of the flight show a reading of the CTD in `state`, 1 diving or 2 climbing, and
/// how often it changes there.
struct Readings {
  int rows = 0, known = 0, changes = 0;
};
Readings readings(const support::Trace& trace, bool down) {
  Readings out;
  double last = kNoSample;
  for (size_t row = 1; row < trace.rowCount(); ++row) {
    const double rate = trace.at(row, trace.column("m_depth_rate"));
    if (trace.at(row, trace.column("true_depth")) < 5 || (down ? rate < 0.06 : rate > -0.06)) {
      continue;
    }
    const double value = trace.at(row, trace.column("sci_water_temp"));
    ++out.rows;
    out.known += std::isnan(value) ? 0 : 1;
    out.changes += !std::isnan(value) && value != last ? 1 : 0;
    last = value;
  }
  return out;
}

TEST(Sampling, TheCtdReadsWhereItIsToldTo) {
  const support::Trace always = fly(setupWith(kSurface + kYo));
  EXPECT_EQ(readings(always, true).known, readings(always, true).rows);
  EXPECT_EQ(readings(always, false).known, readings(always, false).rows);
  const support::Trace dives = fly(setupWith(
      kSurface + kYo + "behavior: sample\n b_arg: sample_time_after_state_change(s) 0\n"));
  EXPECT_GT(readings(dives, true).rows, 10);
  EXPECT_GE(readings(dives, true).known, readings(dives, true).rows - 1);
  EXPECT_GT(readings(dives, false).rows, 10);
  EXPECT_LE(readings(dives, false).known, 1);
  const support::Trace seldom =
      fly(setupWith(kSurface + kYo + "behavior: sensors_in\n b_arg: c_science_all_on(sec) 40\n"));
  const Readings rare = readings(seldom, true);
  EXPECT_NEAR(rare.changes, rare.rows / 10.0, 2) << "one cycle in ten";
}

/// An instrument that is off reports nothing to the SBC or the trace.
TEST(Sampling, TheScienceComputerKeepsToThePeriods) {
  const auto platform =
      platforms::loadPlatform(fs::path(GLIDER_SOURCE_DIR) / "platforms/slocum.toml");
  ASSERT_TRUE(platform);
  ScienceComputer science(*platform, 1, {}, makeHookprog(true));
  const Ocean ocean(OceanSettings{});
  hooks::MemoryLine sbc;
  FlightScienceLine line({}, 1);
  double now = 0, last = kNoSample;
  const auto readings = [&](double period_s) {
    SamplePeriods periods;
    periods.set(kCtd, period_s);
    science.sampleEvery(periods);
    int found = 0;
    for (const double end = now + 60; now < end; ++now) {
      science.run(now, ocean, {10, 0, 0}, sbc.left(), line);
      const double value = science.value(GLIDER_SCI_WATER_TEMP);
      found += !std::isnan(value) && value != last ? 1 : 0;
      last = value;
    }
    return found;
  };
  EXPECT_EQ(readings(-1), 0);
  EXPECT_TRUE(std::isnan(science.value(GLIDER_SCI_WATER_TEMP)));
  EXPECT_EQ(readings(20), 3);
  EXPECT_EQ(readings(0), 60) << "each second";
  EXPECT_EQ(science.recorded(GLIDER_SCI_WATER_TEMP), last);
  EXPECT_EQ(readings(-1), 0);
  EXPECT_EQ(science.value(GLIDER_SCI_WATER_TEMP), last) << "the newest, which gets old";
  EXPECT_TRUE(std::isnan(science.recorded(GLIDER_SCI_WATER_TEMP)));
}

TEST(Sampling, ASampleWhoseFileIsMissingOrdersNothing) {
  SimulationSetup setup =
      setupWith(kSurface + kYo + "behavior: sample\n b_arg: intersample_time(s) -1\n");
  missionFileOf(setup.scenario).behaviours.back().lacks_file = true;
  const support::Trace trace = fly(std::move(setup));
  EXPECT_GT(readings(trace, true).rows, 10);
  EXPECT_EQ(readings(trace, true).known, readings(trace, true).rows);
}

TEST(Sampling, ThePrimaryWaypointIsAsFarAsIsPut) {
  SimulationSetup setup = setupWith(
      "sensor: m_dist_to_primary_wpt(m) 800\nbehavior: surface\n b_arg: start_when(enum) 17\n"
      " b_arg: when_wpt_dist(m) 500\n b_arg: end_action(enum) 0\n" +
      kYo);
  setup.scenario.puts.push_back({100, "m_dist_to_primary_wpt", 400});
  const support::Trace trace = fly(std::move(setup));
  const auto* started = findStart(trace, "surface");
  ASSERT_NE(started, nullptr) << eventText(trace);
  EXPECT_EQ(started->time_s, 100);
}

TEST(Sampling, DevicesOfTheFlightControllerAreReadAsSensorsInSays) {
  const support::Trace off = fly(setupWith(kSurface + kYo +
                                           "behavior: sensors_in\n b_arg: u_battery_time(sec) 400\n"
                                           " b_arg: c_gps_on(bool) -1\n"));
  const int battery = off.column("m_battery");
  EXPECT_EQ(valueAt(off, "m_battery", 0), valueAt(off, "m_battery", 396)) << "the first reading";
  EXPECT_NE(valueAt(off, "m_battery", 0), off.at(off.rowCount() - 1, battery));
}

}  // namespace
}  // namespace glider::simulator
