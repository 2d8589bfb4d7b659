// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The functions of runtime/c/glider.h, each by what it does to the vehicle on the bench. A program
// has one mission: each test is a process of its own.

#include "runtime/abi/behaviour.h"
#include "runtime/c/glider.h"
#include "runtime/c/program.h"
#include "tests/slocum.h"
#include "tests/unit/runtime/log_csv.h"
#include "tests/unit/runtime/reveal.h"
#include "tests/unit/runtime/vehicle_bench.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

REVEAL(KeptCount, glider::runtime::KeptState, uint32_t, count_);

namespace glider::runtime::testing {
namespace {

using ::testing::HasSubstr;

/// Does `what` in a process of its own, and fails as it does.
void alone(const std::function<void()>& what) {
  std::cout.flush();
  fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    what();
    std::cout.flush();
    fflush(nullptr);
    _exit(::testing::Test::HasFailure() ? 1 : 0);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

VehicleBench* bench = nullptr;
double the_end = 0;
std::string the_log;

int waitASecond() {
  if (bench->now() >= the_end) {
    return 0;
  }
  bench->run(bench->now() + 1);
  return 1;
}

/// What gliderOpen does, without a port.
void open(VehicleBench& vehicle, double end = 1e4) {
  bench = &vehicle;
  the_end = end;
  const GliderClock clock{nullptr, [](void*) { return bench->now(); }};
  const GliderLogSink log{nullptr,
                          [](void*, const uint8_t* bytes, uint32_t count) {
                            the_log.append(bytes, bytes + count);
                            return static_cast<int32_t>(count);
                          },
                          nullptr, nullptr};
  Program::instance().attach({vehicle.sbcEnd(), clock, waitASecond, "test", log, {}, 0});
}

const GliderContext& context() {
  return Program::instance().context();
}

/// A list with which each tick of the mission is one turn of gliderRun.
eventList everyTick() {
  static const double kZero = 0;
  static const gliderEvent kAlways{GEQ, MISSION_TIME, &kZero, nullptr, nullptr};
  eventList list = newEventList();
  EXPECT_EQ(addEvent(list, &kAlways), 0);
  return list;
}

void ticks(eventList list, int count) {
  for (int i = 0; i < count; ++i) {
    ASSERT_NE(gliderRun(list), nullptr);
  }
}

/// The program's memory breaks: its log says what, and hookbeh ends its control.
void expectFailedCheck(const std::function<void(eventList)>& damage, const char* text) {
  alone([&] {
    VehicleBench vehicle({}, false);
    open(vehicle);
    eventList list = everyTick();
    ticks(list, 1);
    dive();
    ticks(list, 9);
    ASSERT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
    damage(list);
    EXPECT_EQ(gliderRun(list), nullptr);
    EXPECT_EQ(gliderRun(list), nullptr);
    EXPECT_EQ(gliderExitStatus(), 3);
    const std::string csv = csvOf(the_log);
    const std::string record = std::string(",event,internal check failed,1,") + text + ",\n";
    const size_t first = csv.find(record);
    ASSERT_NE(first, std::string::npos) << csv;
    EXPECT_EQ(csv.find("internal check failed", first + record.size()), std::string::npos) << csv;
    const double heartbeat = vehicle.array(GLIDER_SCI_HOOK_HEARTBEAT);
    vehicle.run(vehicle.now() + 120);
    EXPECT_LE(vehicle.array(GLIDER_SCI_HOOK_HEARTBEAT), heartbeat + 1);
    EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
  });
}

TEST(CProgram, AFlippedBitInTheKeptStateEndsIt) {
  expectFailedCheck([](eventList) { Program::instance().kept().*memberOf(KeptCount{}) ^= 32; },
                    "the kept state of a mission in C is beyond its limits");
}

TEST(CProgram, AFlippedBitInAListOfEventsEndsIt) {
  // The list ends with its count, after the events and their copies.
  constexpr size_t kMost = 16;
  constexpr size_t kCount = kMost * (sizeof(event) + sizeof(gliderEvent));
  expectFailedCheck([](eventList list) { reinterpret_cast<uint8_t*>(list)[kCount + 1] ^= 4; },
                    "the number of events in a list of a mission in C is beyond its limit");
}

TEST(CProgram, AFlippedBitInItsContextEndsIt) {
  expectFailedCheck([](eventList) { Program::instance().context().vertical ^= 64; },
                    "the vertical command in force is unknown");
}

TEST(CProgram, AnEventOutlivesTheBlockItWasWrittenIn) {
  alone([] {
    const double limit = 3;
    const auto made =
        std::make_unique<gliderEvent>(gliderEvent{GEQ, MISSION_TIME, &limit, nullptr, nullptr});
    eventList list = newEventList();
    EXPECT_EQ(addEvent(list, made.get()), 0);
    made->sensor = UINT32_MAX;  // as a stack that was used again
    made->limit = nullptr;
    EXPECT_EQ(addEvent(list, nullptr), -1);
    const gliderEvent no_limit{GEQ, MISSION_TIME, nullptr, nullptr, nullptr};
    const gliderEvent no_test{CUSTOM, MISSION_TIME, nullptr, nullptr, nullptr};
    EXPECT_EQ(addEvent(list, &no_limit), -1);
    EXPECT_EQ(addEvent(list, &no_test), -1);
    EXPECT_EQ(gliderRun(list), nullptr) << "never opened";
    VehicleBench vehicle({}, false);
    open(vehicle);
    EXPECT_EQ(nextEvent(gliderRun(list), nullptr), made.get());
    EXPECT_GE(gliderSensor(MISSION_TIME), 3);
  });
}

TEST(CProgram, BeforeTheFirstTickEverySensorIsUnknown) {
  alone([] {
    ASSERT_EQ(useSensor(M_DEPTH), 0);
    EXPECT_TRUE(std::isnan(gliderSensor(M_DEPTH)));
  });
}

TEST(CProgram, AnEventComparesItsSensorWithItsLimit) {
  alone([] {
    VehicleBench vehicle({}, false);
    vehicle.reports = {GLIDER_M_PITCH};
    double limit = 0.25;
    std::vector<gliderEvent> compared;
    for (const gliderOp op : {LEQ, LESS, GEQ, GREATER}) {
      compared.push_back({op, M_PITCH, &limit, nullptr, nullptr});
    }
    eventList list = everyTick();
    for (const gliderEvent& one : compared) {
      ASSERT_EQ(addEvent(list, &one), 0);
    }
    open(vehicle);
    const auto fired = [&](double pitch) {
      vehicle.set(GLIDER_M_PITCH, pitch);
      eventList found = nullptr;
      for (int i = 0; i < 4; ++i) {
        found = gliderRun(list);
      }
      EXPECT_TRUE(gliderSensor(M_PITCH) == pitch || std::isnan(pitch));
      std::string names;
      for (event e = nextEvent(found, nullptr); e != nullptr; e = nextEvent(found, e)) {
        names += e >= compared.data() && e < compared.data() + compared.size()
                     ? "lLgG"[e - compared.data()]
                     : 't';
      }
      return names;
    };
    EXPECT_EQ(fired(0.125), "tlL");
    EXPECT_EQ(fired(0.25), "tlg");
    EXPECT_EQ(fired(0.5), "tgG");
    limit = 0.75;
    EXPECT_EQ(fired(0.625), "tlL") << "the limit is read on every tick";
  });
}

TEST(CProgram, AnUnknownReadingFiresNothing) {
  alone([] {
    VehicleBench vehicle({}, false);
    const double limit = 0;
    std::vector<gliderEvent> compared;
    for (const gliderOp op : {LEQ, LESS, GEQ, GREATER}) {
      compared.push_back({op, M_PITCH, &limit, nullptr, nullptr});
    }
    eventList list = newEventList();
    for (const gliderEvent& one : compared) {
      ASSERT_EQ(addEvent(list, &one), 0);
    }
    open(vehicle, 60);
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(gliderRun(list), nullptr);
    EXPECT_EQ(::testing::internal::GetCapturedStderr(),
              "error: the line to the vehicle is closed\n");
    EXPECT_TRUE(Program::instance().context().mission_time > 30) << "it flew";
    EXPECT_EQ(gliderExitStatus(), 2) << "the line is closed";
  });
}

TEST(CProgram, ACustomEventIsItsFunctionsTruth) {
  alone([] {
    VehicleBench vehicle({}, false);
    int truth = 0;
    const gliderEvent custom{CUSTOM, MISSION_TIME, nullptr,
                             [](const void* data) { return *static_cast<const int*>(data); },
                             &truth};
    eventList list = everyTick();
    ASSERT_EQ(addEvent(list, &custom), 0);
    open(vehicle);
    eventList fired = gliderRun(list);
    EXPECT_EQ(nextEvent(fired, nextEvent(fired, nullptr)), nullptr);
    truth = -2;
    fired = gliderRun(list);
    EXPECT_EQ(nextEvent(fired, nextEvent(fired, nullptr)), &custom);
    EXPECT_EQ(nextEvent(fired, &custom), nullptr);
    EXPECT_EQ(nextEvent(nullptr, nullptr), nullptr);
  });
}

TEST(CProgram, WithoutAListItFliesToItsEnd) {
  alone([] {
    VehicleBench vehicle({}, false);
    dive();
    open(vehicle, 40);
    EXPECT_EQ(gliderRun(nullptr), nullptr);
    EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
    EXPECT_EQ(vehicle.now(), 40);
  });
}

TEST(CProgram, ThereAre16ListsOf16EventsEach) {
  alone([] {
    const double limit = 0;
    const gliderEvent one{GEQ, M_DEPTH, &limit, nullptr, nullptr};
    for (int i = 0; i < 16; ++i) {
      eventList list = newEventList();
      ASSERT_NE(list, nullptr) << i;
      for (int k = 0; k < 16; ++k) {
        ASSERT_EQ(addEvent(list, &one), 0) << k;
      }
      EXPECT_EQ(addEvent(list, &one), -1);
    }
    EXPECT_EQ(newEventList(), nullptr);
    EXPECT_EQ(addEvent(nullptr, &one), -1);
  });
}

TEST(CProgram, SensorsAreSubscribedBeforeTheFirstTick) {
  alone([] {
    VehicleBench vehicle({}, false);
    vehicle.reports = {GLIDER_M_PITCH};
    vehicle.set(GLIDER_M_PITCH, 0.125);
    eventList list = everyTick();
    EXPECT_EQ(useSensor(M_PITCH), 0);
    EXPECT_EQ(useSensor(GLIDER_SENSOR_COUNT), -1) << "there is no such sensor";
    open(vehicle);
    ticks(list, 3);
    EXPECT_EQ(gliderSensor(M_PITCH), 0.125);
    EXPECT_EQ(useSensor(M_PITCH), 0) << "it is subscribed";
    EXPECT_EQ(useSensor(M_ALTITUDE), -1) << "too late";
    const double limit = 0;
    const gliderEvent late{GEQ, M_ALTITUDE, &limit, nullptr, nullptr};
    EXPECT_EQ(addEvent(list, &late), -1);
    EXPECT_TRUE(std::isnan(gliderSensor(M_ALTITUDE)));
    EXPECT_GT(gliderSensor(MISSION_TIME), 0);
  });
}

TEST(CProgram, AThermoclineNeedsItsTwoSensors) {
  static const gliderThermo kThermo = {1, 10};
  static const gliderEvent kMet{CUSTOM, MISSION_TIME, nullptr, thermoMet, &kThermo};
  using Sensors = std::vector<uint32_t>;
  for (const Sensors& before :
       {Sensors{}, Sensors{M_DEPTH}, Sensors{SCI_WATER_TEMP}, Sensors{M_DEPTH, SCI_WATER_TEMP}}) {
    alone([&] {
      VehicleBench vehicle({}, false);
      eventList list = everyTick();
      for (const uint32_t sensor : before) {
        ASSERT_EQ(useSensor(sensor), 0);
      }
      open(vehicle);
      ticks(list, 1);
      EXPECT_EQ(addEvent(list, &kMet), before.size() == 2 ? 0 : -1) << "too late";
    });
  }
}

TEST(CProgram, CommandsAreThoseInForce) {
  alone([] {
    VehicleBench vehicle({}, false);
    eventList list = everyTick();
    open(vehicle);
    ticks(list, 2);
    setDepths(4, 21);
    setPitches(0.25, 0.375);
    const auto vertical = [&](uint32_t wanted, double depth, double pitch) {
      EXPECT_EQ(context().vertical, wanted);
      EXPECT_EQ(context().depth, depth);
      EXPECT_EQ(context().pitch, pitch);
    };
    dive();
    vertical(kGliderDescend, 21, -0.25);
    climb();
    vertical(kGliderAscend, 4, 0.375);
    diveTo(17);
    vertical(kGliderDescend, 17, -0.25);
    climbTo(9);
    vertical(kGliderAscend, 9, 0.375);
    hoverAt(12);
    vertical(kGliderHover, 12, 0);
    surface();
    vertical(kGliderSurface, 0, 0);
    steer(1.5);
    EXPECT_EQ(context().lateral, static_cast<uint32_t>(kGliderHeading));
    EXPECT_EQ(context().heading, 1.5);
    steerTo(39.5, -73.25);
    EXPECT_EQ(context().lateral, static_cast<uint32_t>(kGliderWaypoint));
    EXPECT_EQ(context().latitude, 39.5);
    EXPECT_EQ(context().longitude, -73.25);
    setPump(-120);
    setPitchBattery(0.5);
    EXPECT_EQ(context().vertical, static_cast<uint32_t>(kGliderActuators));
    EXPECT_NEAR(context().depth, -120, 1e-9);
    EXPECT_NEAR(context().pitch, 0.5, 1e-12);
    holdFin(-0.25);
    EXPECT_EQ(context().lateral, static_cast<uint32_t>(kGliderFin));
    EXPECT_EQ(context().heading, -0.25);
    drift();
    EXPECT_EQ(context().lateral, static_cast<uint32_t>(kGliderDrift));
    diveTo(15);
    ticks(list, 4);
    EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_DEPTH), 15);
    EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_VERTICAL),
              static_cast<double>(hooks::HookVertical::Descend));
    EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_LATERAL), 0);
  });
}

TEST(CProgram, DepthsAndPitchesHaveDefaults) {
  alone([] {
    dive();
    EXPECT_EQ(context().depth, 30);
    EXPECT_EQ(context().pitch, -0.454);
    climb();
    EXPECT_EQ(context().depth, 3);
    EXPECT_EQ(context().pitch, 0.454);
  });
}

TEST(CProgram, AFinHeldBeforeTheFirstTickIsHeld) {
  for (const double angle : {-0.25, 0.25}) {
    alone([&] {
      VehicleBench vehicle({}, false);
      eventList list = everyTick();
      holdFin(angle);
      diveTo(15);
      open(vehicle);
      ticks(list, 4);
      EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_LATERAL), 3);
      EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_HEADING), angle);
    });
  }
}

TEST(CProgram, WhatIsCommandedBeforeTheFirstTickIsItsFirstInstruction) {
  for (const bool to_waypoint : {true, false}) {
    alone([&] {
      VehicleBench vehicle({}, false);
      eventList list = everyTick();
      setPitches(0.25, 0.375);
      climbTo(11);
      to_waypoint ? steerTo(39.5, -73.25) : steer(1.5);
      hoverAt(NAN);  // refused
      open(vehicle);
      ticks(list, 1);
      EXPECT_EQ(context().vertical, static_cast<uint32_t>(kGliderAscend));
      EXPECT_EQ(context().depth, 11);
      EXPECT_EQ(context().pitch, 0.375);
      EXPECT_EQ(context().heading, to_waypoint ? 0 : 1.5);
      EXPECT_EQ(context().latitude, to_waypoint ? 39.5 : 0);
      EXPECT_EQ(context().longitude, to_waypoint ? -73.25 : 0);
      EXPECT_EQ(context().lateral,
                static_cast<uint32_t>(to_waypoint ? kGliderWaypoint : kGliderHeading));
      EXPECT_EQ(context().refused_commands, 1U);
      ticks(list, 3);
      EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_DEPTH), 11);
      EXPECT_THAT(csvOf(the_log), HasSubstr("command"));
    });
  }
}

TEST(CProgram, ALegBeginsWhenTheGliderTurns) {
  alone([] {
    VehicleBench vehicle({}, false);
    eventList list = everyTick();
    open(vehicle);
    ticks(list, 3);
    const auto began = [&](void (*command)()) {
      ticks(list, 1);
      command();
      return Program::instance().legBegan() == context().mission_time;
    };
    EXPECT_TRUE(began(dive));
    EXPECT_FALSE(began(dive));
    EXPECT_FALSE(began([] { diveTo(12); })) << "deeper or not, it is the same leg";
    EXPECT_TRUE(began(climb));
    EXPECT_FALSE(began(climb));
    EXPECT_FALSE(began([] { climbTo(5); }));
    EXPECT_TRUE(began([] { diveTo(12); }));
    EXPECT_TRUE(began([] { climbTo(5); }));
    EXPECT_FALSE(began([] { hoverAt(5); }));
    EXPECT_TRUE(began(climb)) << "it had stopped climbing";
  });
}

/// Dives through the depths and temperatures given, a pair a tick, and asks `then`.
void inWater(const std::vector<std::pair<double, double>>& readings,
             const std::function<void()>& then) {
  alone([&] {
    VehicleBench vehicle({}, false);
    ASSERT_EQ(useSensor(M_DEPTH), 0);
    ASSERT_EQ(useSensor(SCI_WATER_TEMP), 0);
    eventList list = everyTick();
    size_t at = 0;
    const auto now = [&] { return readings[std::min(at, readings.size() - 1)]; };
    vehicle.depth = [&](double) { return now().first; };
    vehicle.temperature = [&](double) { return now().second; };
    open(vehicle);
    ticks(list, 3);
    setDepths(5, 20);
    dive();
    for (; at < readings.size(); ++at) {
      ticks(list, 3);  // until both have come
    }
    then();
  });
}

int met(double dtemp, double ddepth) {
  const gliderThermo thermo = {dtemp, ddepth};
  return thermoMet(&thermo);
}

TEST(CProgram, AThermoclineIsAsStrongAsRequired) {
  inWater({{8, 20}, {9, 20}, {10, 19}, {11, 16}, {12, 15}, {13, 15}}, [] {
    EXPECT_EQ(met(5, 10), 1);
    EXPECT_EQ(met(5.25, 10), 0);
    EXPECT_EQ(met(4, 2.5), 1) << "of 10 to 12 m";
    EXPECT_EQ(met(5, 2.5), 0);
    double min = 1;
    double max = 2;
    EXPECT_EQ(trackThermo(&min, &max, 5.25, 10), 0);
    EXPECT_EQ(min, 1) << "it changes nothing";
    EXPECT_EQ(max, 2);
    // 17.5 degC lies halfway from 19 at 10 m to 16 at 11 m.
    EXPECT_EQ(trackThermo(&min, &max, 5, 10), 1);
    EXPECT_NEAR(min, 10.5 - 4, 1e-4);
    EXPECT_NEAR(max, 10.5 + 4, 1e-4);
    EXPECT_EQ(trackThermo(&min, &max, 4, 2.5), 1);
    EXPECT_NEAR(max - min, 2, 1e-4);
    setDepths(10, 11);
    EXPECT_EQ(trackThermo(&min, &max, 5, 10), 1);
    EXPECT_EQ(min, 10);
    EXPECT_EQ(max, 11);
    climb();
    EXPECT_EQ(met(5, 10), 0) << "another leg has met nothing yet";
    EXPECT_EQ(trackThermo(&min, &max, 5, 10), 0);
  });
}

TEST(CProgram, WaterOfOneTemperatureHasNoThermocline) {
  inWater({{8, 15}, {9, 15}, {10, 15}}, [] {
    EXPECT_EQ(met(0, 10), 0);
    double min = 1;
    double max = 2;
    EXPECT_EQ(trackThermo(&min, &max, 0, 10), 0);
  });
}

TEST(CProgram, AThermoclineAcrossWaterThatWasNotReadIsNotTracked) {
  inWater({{8, 20}, {12, 15}}, [] {
    EXPECT_EQ(met(5, 10), 1);
    double min = 1;
    double max = 2;
    EXPECT_EQ(trackThermo(&min, &max, 5, 10), 0);
    EXPECT_EQ(min, 1);
  });
}

TEST(CProgram, EachWordIsLoggedWithItsValues) {
  alone([] {
    VehicleBench vehicle({}, false);
    eventList list = everyTick();
    const double value = 7;
    gliderLog("early", &value, 1);  // dropped
    open(vehicle);
    ticks(list, 1);
    for (int i = 0; i < 40; ++i) {  // more than one tick's notes have room for
      const double values[] = {static_cast<double>(i), 0.5};
      gliderLog("word", values, 2);
    }
    gliderLog("bare", nullptr, 2);
    gliderLog("none", &value, 0);
    gliderLog("less", &value, -1);
    gliderLog(nullptr, &value, 1);
    const std::array<double, 70> many{};
    gliderLog("many", many.data(), 70);
    gliderLog("after", &value, 1);
    ticks(list, 1);
    std::string wanted;
    for (int i = 0; i < 40; ++i) {
      wanted += "0,log,word," + std::to_string(i) + ",,\n0,log,word,0.5,,\n";
    }
    wanted += "0,log,bare,,,\n0,log,none,,,\n0,log,less,,,\n";
    const std::string csv = csvOf(the_log);
    const size_t from = csv.find("0,log");
    EXPECT_EQ(csv.substr(from, wanted.size()), wanted);
    EXPECT_TRUE(csv.find("0,event,notes lost,1,,\n0,log,after,7,,\n") != std::string::npos);
    EXPECT_EQ(csv.find("notes lost"), csv.rfind("notes lost")) << "reported once";
  });
}

TEST(CProgram, HeadingsAreTrueWithTheDeclinationSet) {
  alone([] {
    VehicleBench vehicle({}, false);
    eventList list = everyTick();
    constexpr double kHalfTurn = 3.141592653589793;
    EXPECT_EQ(setDeclination(3.1416), -1);
    EXPECT_EQ(setDeclination(-3.1416), -1);
    EXPECT_EQ(setDeclination(NAN), -1);
    EXPECT_EQ(setDeclination(kHalfTurn), 0);
    EXPECT_EQ(setDeclination(-kHalfTurn), 0);
    EXPECT_EQ(setDeclination(-0.25), 0);
    dive();
    open(vehicle);
    steer(1.5);
    ticks(list, 4);
    EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_HEADING), 1.75, 1e-6);
    vehicle.set(GLIDER_M_GPS_MAG_VAR, 0.5);  // west; what the vehicle says goes before it
    vehicle.reports = {GLIDER_M_GPS_MAG_VAR};
    ticks(list, 5);
    EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_HEADING), 2.0, 1e-6);
  });
}

TEST(CProgram, ReadsTheVariationThatWasReportedBeforeItBegan) {
  alone([] {
    VehicleBench vehicle({.start_secs = 60, .silence_secs = 24}, false);
    vehicle.set(GLIDER_M_GPS_MAG_VAR, 0.5);
    vehicle.reports = {GLIDER_M_GPS_MAG_VAR};
    eventList list = everyTick();
    EXPECT_EQ(useSensor(GLIDER_M_GPS_MAG_VAR), 0);
    dive();
    static bool under_water = false;
    bench = &vehicle;
    Program::instance().attach({vehicle.sbcEnd(),
                                {nullptr, [](void*) { return bench->now(); }},
                                [] {
                                  bench->run(bench->now() + 1);
                                  if (bench->now() > 40) {
                                    bench->reports.clear();
                                    under_water = true;
                                  }
                                  return bench->now() < 200 ? 1 : 0;
                                },
                                "test",
                                {},
                                {},
                                0});
    ticks(list, 1);
    EXPECT_TRUE(under_water);
    EXPECT_EQ(gliderSensor(GLIDER_M_GPS_MAG_VAR), 0.5);
  });
}

TEST(CProgram, ReleasesControlOnRequest) {
  alone([] {
    VehicleBench vehicle({}, false);
    eventList list = everyTick();
    dive();
    open(vehicle);
    ticks(list, 5);
    EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
    releaseControl();
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(gliderRun(list), nullptr);
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Complete);
    EXPECT_EQ(gliderExitStatus(), 0);
    EXPECT_EQ(gliderResumed(), 0);
    EXPECT_LT(vehicle.now(), 60);
  });
}

TEST(CProgram, ContinuesByItsOwnClockWhileTheLinkIsSilent) {
  alone([] {
    VehicleBench vehicle({}, false);
    eventList list = everyTick();
    open(vehicle);
    ticks(list, 3);
    static bool cut = false;
    static double silent_since = 0;
    Program::instance().attach({vehicle.sbcEnd(),
                                {nullptr, [](void*) { return bench->now() + silent_since; }},
                                [] {
                                  if (!cut) {
                                    return waitASecond();
                                  }
                                  silent_since += 1;
                                  return silent_since < 100 ? 1 : 0;
                                },
                                "test",
                                {},
                                {},
                                0});
    cut = true;
    const double before = gliderSensor(MISSION_TIME);
    ticks(list, 3);
    EXPECT_GT(gliderSensor(MISSION_TIME), before);
    EXPECT_THAT(csvOf(the_log), HasSubstr("silen"));
  });
}

TEST(CProgram, DoesNotFlyByItsOwnClockBeforeItHasBegun) {
  alone([] {
    VehicleBench vehicle({}, false);
    eventList list = everyTick();
    static double now = 0;
    bench = &vehicle;
    Program::instance().attach({vehicle.sbcEnd(),
                                {nullptr, [](void*) { return now; }},
                                [] {
                                  now += 1;
                                  if (now == 1) {
                                    bench->run(1);  // a first word, and then no more
                                  }
                                  return now < 200 ? 1 : 0;
                                },
                                "test",
                                {},
                                {},
                                0});
    EXPECT_EQ(gliderRun(list), nullptr);
  });
}

TEST(CProgram, KeepsStateOnlyBeforeItIsOpen) {
  alone([] {
    VehicleBench vehicle({}, false);
    double state = 0;
    EXPECT_EQ(keepState(nullptr, 1), -1);
    EXPECT_EQ(keepState(&state, size_t{1} << 32U), -1) << "no wrap-around";
    EXPECT_EQ(keepState(&state, (size_t{1} << 32U) + 1), -1);
    EXPECT_EQ(keepState(&state, sizeof state), 0);
    open(vehicle);
    EXPECT_EQ(keepState(&state, sizeof state), -1);
  });
}

}  // namespace
}  // namespace glider::runtime::testing
