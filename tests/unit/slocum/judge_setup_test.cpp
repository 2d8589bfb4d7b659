// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the checks of a flight know of its scenario and faults.

#include "simulator/campaign/kinds_of_faults.h"
#include "simulator/slocum/own_mission.h"
#include "tests/unit/slocum/good_flight.h"
#include "vehicles/slocum/oracles/wrong_sensors.h"

namespace glider::slocum::oracles {
namespace {

/// How often an altimeter of this range that loses this share of its echoes receives one, s.
double echoEvery(double range_m, double dropout, std::optional<double> period_s = {}) {
  Scenario scenario = shippedSetup("default").scenario;
  scenario.sensors.altimeter.range_m = range_m;
  scenario.sensors.altimeter.dropout = dropout;
  if (period_s) {
    slocum::Setting& setting = missionFileOf(scenario).sensors.emplace_back();
    setting.name = "c_alt_time";
    setting.value = *period_s;
  }
  return judgeSetup(shippedSetup("default").platform, scenario, {}).echo_every_s;
}

TEST(JudgeSetup, AnAltimeterOfRealLogsReceivesAnEchoInEightySeconds) {
  EXPECT_EQ(echoEvery(100, 0), 4);
  EXPECT_NEAR(echoEvery(36, 0.95), limits::kEchoEverySecs, 1e-6);
  EXPECT_EQ(echoEvery(100, 1), kForever);
  EXPECT_EQ(echoEvery(20, 0), kForever) << "the bottom comes too late";
  EXPECT_EQ(echoEvery(100, 0, -1), 4) << "hookbeh has it read";
}

TEST(JudgeSetup, ALongCycleIsNotATimeWithoutAFlightController) {
  Scenario scenario = shippedSetup("default").scenario;
  const auto is_dark = [&](double gap_s) {
    return judgeSetup(shippedSetup("default").platform, scenario, {}).isDark(gap_s);
  };
  EXPECT_FALSE(is_dark(12));
  EXPECT_TRUE(is_dark(15));
  scenario.cycles = {.mean_s = 4.4, .spread_s = 0.3, .long_share = 0.01, .long_s = 15};
  EXPECT_FALSE(is_dark(19));
  EXPECT_TRUE(is_dark(20));
}

TEST(JudgeSetup, KnowsSensorsByEitherName) {
  Scenario scenario = shippedSetup("default").scenario;
  scenario.faults.sensors.push_back({.name = "altitude", .kind = SensorFault::Kind::Missing});
  const JudgeSetup setup =
      judgeSetup(shippedSetup("default").platform, scenario, kindsOf(scenario.faults));
  EXPECT_EQ(setup.faults.sensors.front().name, "m_altitude");
}

TEST(JudgeSetup, ASensorThatIsStuckAndFlickersIsOneWrongSensor) {
  Scenario scenario = shippedSetup("default").scenario;
  scenario.faults.sensors.push_back({.name = "m_depth", .kind = SensorFault::Kind::Frozen});
  scenario.faults.sensors.push_back(
      {.name = "m_depth", .kind = SensorFault::Kind::Jumps, .value = 1});
  const auto promised = [&] {
    return judgeSetup(shippedSetup("default").platform, scenario, kindsOf(scenario.faults))
        .promise.deepest;
  };
  EXPECT_EQ(promised(), Deepest::TenMetres);
  scenario.faults.sensors.push_back({.name = "m_pitch", .kind = SensorFault::Kind::Frozen});
  EXPECT_EQ(promised(), Deepest::OneAndAHalf);
}

TEST(JudgeSetup, ASensorThatIsStuckAndSwaysDrifts) {
  Faults faults;
  faults.sensors.push_back({.name = "m_depth", .kind = SensorFault::Kind::Frozen});
  faults.sensors.push_back({.name = "m_depth", .kind = SensorFault::Kind::Sways, .value = 1});
  EXPECT_EQ(kindsOf(faults), std::vector{FaultKind::SensorDrift});
}

/// hookbeh then waits longer for a new reading.
TEST(JudgeSetup, ASensorThatIsMissingInSomeCyclesIsSeldom) {
  using Kind = SensorFault::Kind;
  const auto seldom = [](const SensorFault& fault, double now_s) {
    Faults faults;
    faults.sensors.push_back(fault);
    return isSeldom(faults, {"m_depth"}, now_s, 44);
  };
  const SensorFault some{
      .name = "m_depth", .when = {100, 200}, .kind = Kind::Missing, .share = 0.8};
  EXPECT_FALSE(seldom(some, 99));
  EXPECT_TRUE(seldom(some, 100));
  EXPECT_TRUE(seldom(some, 243));
  EXPECT_FALSE(seldom(some, 244));
  EXPECT_FALSE(seldom({.name = "m_depth", .kind = Kind::Missing}, 150)) << "it is never reported";
  EXPECT_FALSE(seldom({.name = "m_depth", .kind = Kind::Jumps, .share = 0.8}, 150));
  EXPECT_FALSE(seldom({.name = "m_pitch", .kind = Kind::Missing, .share = 0.8}, 150));
}

TEST(JudgeSetup, BeforeTheFirstSensorIsWrongAllIsPromised) {
  Scenario scenario = shippedSetup("default").scenario;
  scenario.faults.sensors.push_back(
      {.name = "m_depth", .when = {1000, 2000}, .kind = SensorFault::Kind::Missing});
  const JudgeSetup setup =
      judgeSetup(shippedSetup("default").platform, scenario, kindsOf(scenario.faults));
  EXPECT_TRUE(setup.promiseAt(999).follows);
  EXPECT_EQ(setup.promiseAt(999).control, Control::Kept);
  EXPECT_FALSE(setup.promiseAt(1000).follows);
  EXPECT_EQ(setup.promiseAt(1500).deepest, Deepest::TenMetres);
  EXPECT_EQ(setup.promiseAt(3801).deepest, Deepest::Overshoot);
  EXPECT_TRUE(setup.promiseAt(3801).clearance);
  EXPECT_FALSE(setup.promiseAt(3801).follows) << "what the mission has read still counts";
}

}  // namespace
}  // namespace glider::slocum::oracles
