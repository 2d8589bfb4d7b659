// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Flights in which something goes wrong, each with its stated outcome (scenarios/README.md).

#include "simulator/faults/card_damage.h"
#include "simulator/faults/sensor_damage.h"
#include "simulator/flight_observer.h"
#include "support/diagnostics/ids/vehicle.h"
#include "tests/slocum.h"
#include "tests/unit/simulator/fake_sbc.h"
#include "tests/unit/simulator/flights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace glider::simulator {
namespace {

constexpr double kSilentAfter = 24 + 8;  // silence_secs and two cycles

SimulationSetup withFaults(const Faults& faults,
                           FakePilot::Plan plan = {.release_s = 1200, .takes_again = true}) {
  SimulationSetup setup = shippedSetup("default");
  setup.scenario.faults = faults;
  setup.duration_s = 6000;
  setup.restart_sbc = [plan] {
    return support::Result<std::unique_ptr<SbcPort>>(std::make_unique<FakeSbc>(plan, 1e9, true));
  };
  setup.sbc = std::move(*setup.restart_sbc());
  return setup;
}

/// When the first event `id` from `after_s` on was; -1 if there is none.
double timeOf(const support::Trace& trace, EventId id, double after_s = 0) {
  for (const support::TraceEvent& event : trace.events) {
    if (event.time_s >= after_s && event.id == id) {
      return event.time_s;
    }
  }
  return -1;
}

void expectHandBackAndReturn(const Faults& faults, double begin_s, double end_s) {
  const support::Trace trace = fly(withFaults(faults));
  const std::string events = eventText(trace);
  const double silent = timeOf(trace, EventId::SbcSilent);
  EXPECT_GT(silent, begin_s) << events;
  EXPECT_LE(silent, begin_s + kSilentAfter) << events;
  const double again = timeOf(trace, EventId::SbcTakesControl, silent);
  EXPECT_GE(again, end_s) << events;
  EXPECT_LE(again, end_s + 60) << events;
  EXPECT_GT(timeOf(trace, EventId::SbcReleasesControl), again) << events;
  EXPECT_GT(timeOf(trace, EventId::NothingLeftToFly), again) << events;
}

Faults onLine(LineWay way, const LineFault& what) {
  Faults faults;
  faults.lines.push_back(what);
  faults.lines.back().way = way;
  return faults;
}

TEST(FaultFlight, PowerCutEndsControlInTimeAndTheProgramStartsAgain) {
  Faults faults;
  faults.power = {{300, 400}};
  expectHandBackAndReturn(faults, 300, 400);
}

TEST(FaultFlight, APortThatVanishesEndsControlInTimeAndTheBoardStartsTheProgramAgain) {
  Faults faults;
  faults.port = {{300, 400}};
  expectHandBackAndReturn(faults, 300, 400);
}

TEST(FaultFlight, AStuckMissionLosesControlThoughItAnswers) {
  Faults faults;
  faults.stuck = {{300, 400}};
  expectHandBackAndReturn(faults, 300, 400);
  EXPECT_NE(timeOf(fly(withFaults(faults)), EventId::SbcStuck), -1)
      << eventText(fly(withFaults(faults)));
}

TEST(FaultFlight, AScienceRebootEndsControlInTime) {
  Faults faults;
  faults.science = {{300, 400}};
  expectHandBackAndReturn(faults, 300, 400);
}

TEST(FaultFlight, AShortScienceRebootCostsNothing) {
  Faults faults;
  faults.science = {{301, 307}};
  const support::Trace trace = fly(withFaults(faults));
  EXPECT_NE(timeOf(trace, EventId::ScienceRestarts), -1) << eventText(trace);
  EXPECT_EQ(timeOf(trace, EventId::SbcSilent), -1) << eventText(trace);
  EXPECT_NE(timeOf(trace, EventId::SbcReleasesControl), -1) << eventText(trace);
}

TEST(FaultFlight, EachDirectionOfEachLineThatIsCutEndsControlInTime) {
  for (const LineWay way :
       {LineWay::ToSbc, LineWay::FromSbc, LineWay::ToFlight, LineWay::FromFlight}) {
    SCOPED_TRACE(static_cast<int>(way));
    expectHandBackAndReturn(onLine(way, {.when = {300, 400}, .cut = true}), 300, 400);
  }
}

TEST(FaultFlight, TheWrongSpeedIsADeadLine) {
  for (const double baud : {57600.0, 230400.0}) {
    expectHandBackAndReturn(onLine(LineWay::ToSbc, {.when = {300, 400}, .heard_at_baud = baud}),
                            300, 400);
  }
}

TEST(FaultFlight, AFlightControllerThatStartsAgainBeginsItsMissionAgain) {
  for (const bool keeps_array : {false, true}) {
    Faults faults;
    faults.flight = {{{300, 330}, keeps_array}};
    const support::Trace trace = fly(withFaults(faults));
    const std::string events = eventText(trace);
    EXPECT_EQ(timeOf(trace, keeps_array ? EventId::MissionRestarts : EventId::FlightRestarts), 332)
        << events;
    EXPECT_EQ(timeOf(trace, EventId::HookbehReady, 300), 332) << events;
    EXPECT_EQ(timeOf(trace, EventId::SbcTakesControl, 300), -1) << "not asked for\n" << events;
    const int time = trace.column("time");
    for (size_t row = 0; row < trace.rowCount(); ++row) {
      EXPECT_FALSE(trace.at(row, time) > 300 && trace.at(row, time) < 330) << "it did nothing";
    }
  }
}

TEST(FaultFlight, AnAbortedMissionDoesNotBeginAgain) {
  Faults faults;
  faults.aborts = {290};
  faults.flight = {{{300, 330}, false}};
  const support::Trace trace = fly(withFaults(faults));
  EXPECT_EQ(timeOf(trace, EventId::SbcTakesControl, 300), -1) << eventText(trace);
}

/// Notes what lies in the sensor array and what becomes of it.
class ArrayWatch final : public FlightObserver {
 public:
  void said(std::span<const uint8_t>, double) override {}
  bool cycle(const CycleView& view) override {
    sequences.push_back(view.array.get(GLIDER_X_HOOK_SEQUENCE));
    states.push_back(view.hook);
    return view.time_s < 40;
  }
  std::vector<double> sequences;
  std::vector<hooks::HookState> states;
};

TEST(FaultFlight, AnInstructionLeftOverLiesInTheArrayAndIsNotFollowed) {
  SimulationSetup setup = shippedSetup("default");  // no SBC is there
  setup.scenario.faults.leftover = {{3, 65530, 12}};
  ArrayWatch watch;
  setup.observer = &watch;
  (void)fly(std::move(setup));
  ASSERT_GT(watch.sequences.size(), 2U);
  EXPECT_EQ(watch.sequences.back(), 65530) << "it was found";
  for (const hooks::HookState state : watch.states) {
    EXPECT_NE(state, hooks::HookState::Active);
  }
}

TEST(CardDamage, DoesWhatItSaysAndTheSameForASeed) {
  const std::vector<uint8_t> good(8 * 4096, 0x5a);
  const auto damaged = [&](CardFault::Kind kind, double amount, uint64_t seed) {
    std::vector<uint8_t> bytes = good;
    damageCard({.at_s = 0, .kind = kind, .amount = amount}, seed, bytes);
    return bytes;
  };
  int turned = 0;
  const auto flipped = damaged(CardFault::Kind::Flips, 5, 1);
  for (size_t i = 0; i < good.size(); ++i) {
    turned += std::popcount(static_cast<unsigned>(flipped[i] ^ good[i]));
  }
  EXPECT_EQ(turned, 5);
  EXPECT_EQ(flipped, damaged(CardFault::Kind::Flips, 5, 1));
  EXPECT_NE(flipped, damaged(CardFault::Kind::Flips, 5, 2));
  EXPECT_EQ(damaged(CardFault::Kind::Cut, 0.25, 1).size(), good.size() / 4);
  EXPECT_EQ(damaged(CardFault::Kind::Zeroed, 1, 1), std::vector<uint8_t>(good.size(), 0));
  const auto some = damaged(CardFault::Kind::Zeroed, 0.5, 1);
  const auto zeros = std::ranges::count(some, uint8_t{0});
  EXPECT_EQ(zeros % 4096, 0);
  EXPECT_GT(zeros, 0);
  EXPECT_LT(zeros, static_cast<ptrdiff_t>(good.size()));
  std::vector<uint8_t> empty;
  damageCard({.at_s = 0, .kind = CardFault::Kind::Flips, .amount = 9}, 1, empty);
  EXPECT_TRUE(empty.empty());
}

TEST(FaultFlight, AnAbortTakesTheVehicleUpForGood) {
  Faults faults;
  faults.aborts = {300};
  const support::Trace trace = fly(withFaults(faults));
  EXPECT_NEAR(timeOf(trace, EventId::Aborts), 300, 0.3) << eventText(trace);
  const auto* up = findEvent(trace, EventId::AbortedAtSurface);
  ASSERT_NE(up, nullptr) << eventText(trace);
  EXPECT_EQ(textOf(*up), "aborted (MS_ABORT_DEVICE_ERROR) and at the surface");
  EXPECT_EQ(timeOf(trace, EventId::SbcTakesControl, 300), -1) << eventText(trace);
}

/// Counts the reports after an abort, and those of them that tell that hookbeh is complete.
struct AbortOnlooker : FlightObserver {
  void said(std::span<const uint8_t> /*bytes*/, double /*now_s*/) override {}
  bool cycle(const CycleView& view) override {
    reports += view.aborted ? 1 : 0;
    const bool told =
        view.array.fresh(GLIDER_X_HOOK_STATE) &&
        view.array.get(GLIDER_X_HOOK_STATE) == static_cast<double>(hooks::HookState::Complete);
    complete += view.aborted && told ? 1 : 0;
    return true;
  }
  int reports = 0, complete = 0;
};

TEST(FaultFlight, AfterAnAbortEachReportSaysThatHookbehIsComplete) {
  Faults faults;
  faults.aborts = {300};
  SimulationSetup setup = withFaults(faults);
  AbortOnlooker observer;
  setup.observer = &observer;
  fly(std::move(setup));
  EXPECT_GE(observer.reports, 10);
  EXPECT_GE(observer.complete + 1, observer.reports) << "the first may have been on its way";
}

TEST(FaultFlight, DamageThatLeavesEnoughIsFlownThrough) {
  for (const LineFault& fault :
       {LineFault{.when = {100, 900}, .loss = 2e-4}, LineFault{.when = {100, 900}, .flips = 2e-4},
        LineFault{.when = {100, 900}, .bursts = 2e-5}, LineFault{.when = {100, 900}, .delay_s = 2},
        LineFault{.when = {100, 900}, .doubled = 1}}) {
    for (const LineWay way : {LineWay::ToSbc, LineWay::FromSbc}) {
      const support::Trace trace = fly(withFaults(onLine(way, fault)));
      EXPECT_EQ(timeOf(trace, EventId::SbcSilent), -1) << eventText(trace);
      EXPECT_NE(timeOf(trace, EventId::SbcReleasesControl), -1) << eventText(trace);
    }
  }
}

TEST(FaultFlight, TheSbcsClockMayJump) {
  Faults faults;
  faults.clock = {{300, 1e6}, {400, -3e6}, {500, 50}};
  const support::Trace trace = fly(withFaults(faults));
  EXPECT_EQ(timeOf(trace, EventId::SbcSilent), -1) << eventText(trace);
  EXPECT_NEAR(timeOf(trace, EventId::SbcReleasesControl), 1206, 12) << eventText(trace);
}

SensorFault onSensor(const char* name, SensorFault::Kind kind, double value = 0) {
  SensorFault fault;
  fault.name = name;
  fault.when = {300, 500};
  fault.kind = kind;
  fault.value = value;
  return fault;
}

TEST(FaultFlight, SensorsFreezeVanishAndLie) {
  using Kind = SensorFault::Kind;
  Faults faults;
  faults.sensors = {onSensor("m_pitch", Kind::Frozen), onSensor("m_heading", Kind::Value, 99)};
  const support::Trace trace = fly(withFaults(faults));
  EXPECT_EQ(valueAt(trace, "m_pitch", 304), valueAt(trace, "m_pitch", 496));
  EXPECT_EQ(valueAt(trace, "m_heading", 400), 99);
  EXPECT_NE(valueAt(trace, "m_heading", 520), 99);
  EXPECT_NE(timeOf(trace, EventId::SbcReleasesControl), -1) << eventText(trace);
}

TEST(SensorDamage, DriftsScalesAndJumps) {
  using Kind = SensorFault::Kind;
  SensorFault drift = onSensor("", Kind::Drift, -0.5);
  SensorFault scale = onSensor("", Kind::Scale, 3);
  SensorFault jumps = onSensor("", Kind::Jumps, 10);
  drift.id = 1, scale.id = 2, jumps.id = 3;
  jumps.share = 0.25;
  SensorDamage damage({drift, scale, jumps}, 1);
  damage.setNow(299);
  EXPECT_EQ(damage.reading(1, 20), 20);
  EXPECT_EQ(damage.reading(2, 20), 20);
  EXPECT_EQ(damage.reading(3, 20), 20);
  damage.setNow(310);
  EXPECT_EQ(damage.reading(1, 20), 15) << "10 s of it";
  EXPECT_EQ(damage.reading(2, 20), 60);
  int jumped = 0, up = 0;
  for (int i = 0; i < 1000; ++i) {
    const double by = *damage.reading(3, 20) - 20;
    EXPECT_LE(std::fabs(by), 10);
    jumped += by != 0;
    up += by < 0;
  }
  EXPECT_NEAR(jumped, 250, 50);
  EXPECT_NEAR(up, jumped / 2.0, 40);
}

TEST(SensorDamage, SwaysAlsoWhereItIsStuck) {
  using Kind = SensorFault::Kind;
  SensorFault frozen = onSensor("", Kind::Frozen), sways = onSensor("", Kind::Sways, 2);
  frozen.id = sways.id = 1;
  sways.period_s = 40;
  SensorDamage damage({frozen, sways}, 1);
  damage.setNow(299);
  EXPECT_EQ(damage.reading(1, 20), 20);
  damage.setNow(300);
  EXPECT_NEAR(*damage.reading(1, 25), 20, 1e-12);
  damage.setNow(310);
  EXPECT_NEAR(*damage.reading(1, 25), 22, 1e-12) << "a quarter of the period";
  damage.setNow(330);
  EXPECT_NEAR(*damage.reading(1, 25), 18, 1e-12);
}

TEST(SensorDamage, IsOffAndLiesNowAndThen) {
  using Kind = SensorFault::Kind;
  SensorFault off = onSensor("", Kind::Offset, 1.5);
  SensorFault lies = onSensor("", Kind::Value, 7);
  off.id = 1, lies.id = 2;
  lies.share = 0.25;
  SensorDamage damage({off, lies}, 1);
  damage.setNow(310);
  EXPECT_EQ(damage.reading(1, 20), 21.5);
  int lied = 0;
  for (int i = 0; i < 1000; ++i) {
    const double reading = *damage.reading(2, 20);
    EXPECT_TRUE(reading == 7 || reading == 20) << reading;
    lied += reading == 7;
  }
  EXPECT_NEAR(lied, 250, 50);
}

/// The readings of a sensor in the flight controller's array.
class ArrayReader final : public FlightObserver {
 public:
  explicit ArrayReader(Sensor sensor) : sensor_(sensor) {}
  void said(std::span<const uint8_t> /*bytes*/, double /*now_s*/) override {}
  bool cycle(const CycleView& view) override {
    constexpr double kBegun = 312;  // s: the fault begins at 300 s
    if (view.time_s > kBegun && view.array.fresh(sensor_)) {
      readings.emplace_back(view.array.get(sensor_), view.true_depth_m);
    }
    return true;
  }
  std::vector<std::pair<double, double>> readings;  ///< with the true depth

 private:
  Sensor sensor_;
};

std::vector<std::pair<double, double>> arrayReadings(Sensor sensor, const SensorFault& fault) {
  ArrayReader reader(sensor);
  Faults faults;
  faults.sensors = {fault};
  SimulationSetup setup = withFaults(faults);
  setup.duration_s = 496;  // the fault ends at 500 s
  setup.observer = &reader;
  fly(std::move(setup));
  return reader.readings;
}

TEST(FaultFlight, OfAScienceSensorActsOnceOnTheFlightController) {
  constexpr double kMoved = 0.1;  // bar: the vehicle sinks while a reading is on its way
  const auto off = arrayReadings(Sensor::sci_water_pressure,
                                 onSensor("sci_water_pressure", SensorFault::Kind::Offset, 0.5));
  ASSERT_GT(off.size(), 20U);
  for (const auto& [bar, depth] : off) {
    EXPECT_NEAR(bar, depth / 10 + 0.5, kMoved);
  }
  const auto scaled = arrayReadings(Sensor::sci_water_pressure,
                                    onSensor("sci_water_pressure", SensorFault::Kind::Scale, 0.5));
  ASSERT_GT(scaled.size(), 20U);
  for (const auto& [bar, depth] : scaled) {
    EXPECT_NEAR(bar, depth / 20, kMoved);
  }
}

TEST(FaultFlight, OfAFieldOfAnInstructionActsInTheSensorArray) {
  const auto depths = arrayReadings(Sensor::sci_hook_depth,
                                    onSensor("sci_hook_depth", SensorFault::Kind::Value, 7));
  ASSERT_FALSE(depths.empty());
  for (const auto& [metres, depth] : depths) {
    EXPECT_EQ(metres, 7) << depth;
  }
}

TEST(FaultFlight, NoSensorsNanReachesTheVehicle) {
  for (uint16_t id = 0; id < GLIDER_SENSOR_COUNT; ++id) {
    SimulationSetup setup = withFaults({});
    const std::string name = setup.platform.sensors[id].name;
    setup.scenario.faults.sensors = {
        onSensor(name.c_str(), SensorFault::Kind::Value, std::nan(""))};
    setup.duration_s = 600;
    const support::Trace trace = fly(std::move(setup));
    for (const char* column : {"true_depth", "true_lat", "true_lon"}) {
      EXPECT_FALSE(std::isnan(valueAt(trace, column, 600))) << name << " " << column;
    }
    EXPECT_FALSE(std::isnan(valueAt(trace, "m_lat", 600))) << name;
  }
}

TEST(FaultFlight, IsNotOverUnderWaterForAnyReadingOfTheDepthSensor) {
  Faults faults;
  faults.sensors = {onSensor("m_depth", SensorFault::Kind::Value, 0)};
  faults.power = {{320, kForever}};
  const support::Trace trace = fly(withFaults(faults, {.top_m = 5, .bottom_m = 50}));
  EXPECT_NE(timeOf(trace, EventId::NothingLeftToFly), -1) << eventText(trace);
  EXPECT_LT(trace.at(trace.rowCount() - 1, trace.column("true_depth")), 1) << eventText(trace);
}

TEST(FaultFlight, OfASensorThatTheVehicleDoesNotHaveIsRefused) {
  Faults faults;
  faults.sensors = {onSensor("m_depht", SensorFault::Kind::Frozen)};
  const auto refused = simulate(withFaults(faults));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().id, support::diagnostics::platformLacksSensor);
  EXPECT_NE(refused.error().message.find("m_depht"), std::string::npos);
}

TEST(FaultFlight, IsDeterministic) {
  const Faults faults = onLine(LineWay::FromSbc, {.when = {100, 900}, .loss = 0.02});
  const std::string first = traceToCsv(fly(withFaults(faults)));
  EXPECT_EQ(first, traceToCsv(fly(withFaults(faults))));
  SimulationSetup other = withFaults(faults);
  other.seed = 2;
  EXPECT_NE(first, traceToCsv(fly(std::move(other))));
}

}  // namespace
}  // namespace glider::simulator
