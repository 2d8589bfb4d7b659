// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/flight_controller.h"

#include "hooks/protocol/decimal.h"
#include "hooks/protocol/numbers.h"
#include "simulator/slocum/flight/skeleton.h"
#include "simulator/slocum/own_mission.h"
#include "tests/slocum.h"
#include "tests/unit/simulator/flights.h"
#include "tests/unit/simulator/slocum_vehicle.h"
#include "vehicles/slocum/mission_files/read.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>

/// The flight controller without noise, cycle by cycle: its sensors against the true vehicle, what
/// goes over the flight-science link, and how missions end.
namespace glider::simulator {
namespace {

constexpr double kNoArgument = std::numeric_limits<double>::quiet_NaN();

SensorSettings noiseless() {
  SensorSettings settings;
  settings.depth.noise_m = settings.attitude.pitch_rad = settings.attitude.heading_rad = 0;
  settings.gps.noise_m = 0;
  settings.altimeter.noise_m = 0;
  settings.altimeter.range_m = 40;
  return settings;
}

OceanSettings stillWater(double depth) {
  OceanSettings settings;
  settings.density = 1025;
  settings.bottom.depth_m = depth;
  return settings;
}

class Controller {
 public:
  /// `lacks`: a sensor that the vehicle does not have.
  Controller(const std::string& mission, double water_depth, const std::string& lacks = "")
      : setup_(without(setupWith(mission), lacks)),
        ocean(stillWater(water_depth)),
        controller(setup_.platform, missionFileOf(setup_.scenario), noiseless(), 1, frame_, 2025,
                   journal) {}

  /// Cycles until `seconds` are over, calling `after` behind each.
  void fly(double seconds, const std::function<void()>& after) {
    for (const double end = now + seconds; now < end && !controller.end(); now += 4) {
      depth = vehicle.depth();
      line.setNow(now);
      controller.cycle(now, ocean, vehicle, line);
      after();
      for (int i = 0; i < 16; ++i) {
        vehicle.step(ocean, now + 0.25 * i);
      }
    }
  }
  [[nodiscard]] double read(uint16_t id) const { return controller.array().get(id); }

 private:
  /// The numbers of the other sensors stay.
  static SimulationSetup without(SimulationSetup setup, const std::string& lacks) {
    for (platforms::PlatformSensor& sensor : setup.platform.sensors) {
      sensor.name = sensor.name == lacks ? "m_nothing" : sensor.name;
    }
    return setup;
  }

  SimulationSetup setup_;
  LocalFrame frame_{39, -73};

 public:
  Ocean ocean;
  Vehicle vehicle = slocumVehicle();
  FlightScienceLine line{{}, 1};
  Journal journal;
  FlightController controller;
  double now = 0, depth = 0;
};

const std::string kFlownYo =
    "behavior: set_heading\n b_arg: use_heading(bool) 1\n b_arg: heading_value(rad) 0.5\n"
    "behavior: yo\n b_arg: num_half_cycles_to_do(nodim) 2\n b_arg: d_target_depth(m) 25\n"
    " b_arg: c_target_depth(m) 3\n b_arg: end_action(enum) 0\n";
const std::string kFlownSurface =
    "behavior: surface\n b_arg: start_when(enum) 1\n b_arg: end_action(enum) 0\n";

TEST(FlightController, SensorsSayWhatTheVehicleDoes) {
  Controller c(kFlownSurface + kFlownYo, 60);
  double last_depth = 0;
  int echoes = 0, cycles = 0;
  c.fly(400, [&] {
    const Vehicle& v = c.vehicle;
    ASSERT_EQ(c.read(GLIDER_M_PRESENT_SECS_INTO_MISSION), c.now);
    ASSERT_EQ(c.read(GLIDER_M_CYCLE_NUMBER), cycles);
    ASSERT_EQ(c.read(GLIDER_M_PRESENT_TIME), 1.25e9 + c.now);
    ASSERT_NEAR(c.read(GLIDER_M_DEPTH), c.depth, 1e-5);
    ASSERT_NEAR(c.read(GLIDER_M_PRESSURE), c.depth / 10, 1e-6) << "bar";
    ASSERT_NEAR(c.read(GLIDER_M_DEPTH_RATE), cycles == 0 ? 0 : (c.depth - last_depth) / 4, 1e-6);
    ASSERT_NEAR(c.read(GLIDER_M_PITCH), v.pitch(), 1e-6);
    ASSERT_NEAR(c.read(GLIDER_M_BALLAST_PUMPED), v.pumpedCc(), 1e-4);
    ASSERT_NEAR(c.read(GLIDER_M_BATTPOS), v.batteryPositionIn(), 1e-6);
    ASSERT_NEAR(c.read(GLIDER_M_FIN), v.fin(), 1e-6);
    ASSERT_EQ(c.read(GLIDER_M_ROLL), 0);
    ASSERT_NEAR(c.read(GLIDER_M_BATTERY), v.battery().voltage(), 1e-6);
    ASSERT_NEAR(c.read(GLIDER_M_COULOMB_AMPHR_TOTAL), v.battery().ampHours(), 1e-6);
    ASSERT_EQ(c.read(GLIDER_M_VACUUM), 8);
    if (c.depth > 20.001) {
      ASSERT_NEAR(c.read(GLIDER_M_ALTITUDE), 60 - c.depth, 1e-5);
      ASSERT_NEAR(c.read(GLIDER_M_WATER_DEPTH), 60, 1e-4) << "depth and altitude together";
      ASSERT_TRUE(c.controller.array().fresh(GLIDER_M_ALTITUDE));
      ++echoes;
    } else if (c.depth < 19.999) {
      ASSERT_FALSE(c.controller.array().fresh(GLIDER_M_ALTITUDE)) << "beyond 40 m";
      ASSERT_FALSE(c.controller.array().fresh(GLIDER_M_WATER_DEPTH));
    }
    last_depth = c.depth;
    ++cycles;
  });
  EXPECT_GT(echoes, 5);
}

TEST(FlightController, DepthStateByTheRateThatItReports) {
  Controller c(kFlownSurface + kFlownYo, 100);
  double last = 0;
  std::map<int, int> seen;
  bool down = true;
  c.fly(700, [&] {
    const double rate = (c.depth - last) / 4;
    last = c.depth;
    const int state = static_cast<int>(c.read(GLIDER_M_DEPTH_STATE));
    ++seen[state];
    if (c.depth < 0.499) {
      ASSERT_EQ(state, 0) << "at the surface";
    } else if (c.depth > 0.501 && rate > 0.048) {
      ASSERT_EQ(state, 1) << "dives at " << rate;
    } else if (c.depth > 0.501 && rate < -0.048) {
      ASSERT_EQ(state, 2) << "climbs at " << rate;
      down = false;
    } else if (c.depth > 0.501 && std::fabs(rate) < 0.047) {
      ASSERT_EQ(state, 3) << "hovers at " << rate;
    }
  });
  EXPECT_FALSE(down);
  EXPECT_GT(seen[1], 20);
  EXPECT_GT(seen[2], 20);
  EXPECT_GT(seen[3], 0);
  EXPECT_GT(seen[0], 2);
}

TEST(FlightController, ScienceWritesItsOwnSensorsOnly) {
  Controller c(kFlownSurface + kFlownYo, 100);
  for (const auto& [id, value] : {std::pair<uint16_t, double>{GLIDER_M_BATTERY, 1.5},
                                  {GLIDER_SCI_WATER_TEMP, 17.5},
                                  {GLIDER_M_WATER_DEPTH, 3},
                                  {GLIDER_X_MISSION_STATUS, 9}}) {
    c.line.to_flight.send({.id = id, .value = value});
  }
  c.fly(12, [] {});
  EXPECT_EQ(c.read(GLIDER_SCI_WATER_TEMP), 17.5);
  EXPECT_GT(c.read(GLIDER_M_BATTERY), 14);
  EXPECT_TRUE(std::isnan(c.read(GLIDER_M_WATER_DEPTH)));
  EXPECT_EQ(c.read(GLIDER_X_MISSION_STATUS), 0);
}

TEST(FlightController, SendsWhatIsFreshOfItsOwn) {
  Controller c(kFlownSurface + kFlownYo, 100);
  c.fly(200, [&] {
    std::map<uint16_t, double> got;
    c.line.setNow(c.now + 1);
    while (const auto one = c.line.to_science.next()) {
      got[one->id] = one->value;
    }
    const SensorArray& array = c.controller.array();
    for (uint16_t id = 0; id < array.size(); ++id) {
      const bool goes = !array.ofScience(id) && array.fresh(id) && !std::isnan(array.get(id));
      ASSERT_EQ(got.contains(id), goes) << id;
      if (goes) {
        ASSERT_EQ(got[id], hooks::asSixDecimals(array.get(id))) << id;
      }
    }
  });
}

TEST(FlightController, ReportsTheCommandsInForce) {
  Controller c(kFlownSurface + kFlownYo, 100);
  c.fly(100, [] {});
  EXPECT_EQ(c.read(GLIDER_C_HEADING), 0.5);
  EXPECT_NEAR(c.read(GLIDER_C_PITCH), -0.4538, 1e-6);
  EXPECT_EQ(c.read(GLIDER_C_BALLAST_PUMPED), -233) << "-260 within the pump's limits";
  EXPECT_TRUE(std::isnan(c.read(GLIDER_M_DIST_TO_WPT)));
  EXPECT_EQ(c.controller.layer(), 2) << "the yo, third in the file";
  EXPECT_EQ(c.controller.hookState(), hooks::HookState::Absent);
  EXPECT_FALSE(c.controller.hookActive());
}

TEST(FlightController, KnowsItsWaypoint) {
  Controller c(kFlownSurface +
                   "behavior: goto_wpt\n b_arg: wpt_units(enum) 2\n b_arg: wpt_x(lon) -7300.0\n"
                   " b_arg: wpt_y(lat) 3901.0\n b_arg: stop_when(enum) 5\n" +
                   kFlownYo,
               100);
  c.fly(4, [] {});
  // A minute of latitude at 39 degrees: 111,014.8 m / 60.
  EXPECT_NEAR(c.read(GLIDER_M_DIST_TO_WPT), 1850.2, 0.5);
  EXPECT_EQ(c.controller.waypointLatitude(), 3901.0);
  EXPECT_EQ(c.controller.waypointLongitude(), -7300.0);
}

/// The times of the cycles in which each of `sensors` is read during 100 s of a dive.
std::map<uint16_t, std::vector<double>> readingTimes(const std::string& sensors_in,
                                                     const std::vector<uint16_t>& sensors) {
  // A dive to an altitude would switch the altimeter on.
  Controller c(kFlownSurface + kFlownYo +
                   " b_arg: d_target_altitude(m) -1\nbehavior: sensors_in\n" + sensors_in,
               30);
  std::map<uint16_t, std::vector<double>> times;
  c.fly(100, [&] {
    for (const uint16_t sensor : sensors) {
      if (c.controller.array().fresh(sensor)) {
        times[sensor].push_back(c.now);
      }
    }
  });
  return times;
}

TEST(FlightController, SensorsInSaysHowOftenEachDeviceIsRead) {
  struct Row {
    const char* setting;
    std::vector<uint16_t> sensors;
  };
  const std::vector<double> every_40 = {0, 40, 80};
  for (const Row& row :
       {Row{"c_att_time", {GLIDER_M_PITCH, GLIDER_M_ROLL, GLIDER_M_HEADING}},
        Row{"c_pressure_time", {GLIDER_M_PRESSURE, GLIDER_M_DEPTH, GLIDER_M_DEPTH_RATE}},
        Row{"u_battery_time", {GLIDER_M_BATTERY}}, Row{"u_vacuum_time", {GLIDER_M_VACUUM}},
        Row{"c_leakdetect_time", {GLIDER_M_LEAKDETECT_VOLTAGE}}}) {
    const auto with = [&](int period) {
      return readingTimes(fmt::format(" b_arg: {}(sec) {}\n", row.setting, period), row.sensors);
    };
    auto as_fast_as_possible = with(0), seldom = with(40), off = with(-1);
    for (const uint16_t sensor : row.sensors) {
      EXPECT_EQ(as_fast_as_possible[sensor].size(), 25U) << row.setting;
      EXPECT_EQ(seldom[sensor], every_40) << row.setting;
      EXPECT_TRUE(off[sensor].empty()) << row.setting;
    }
  }
  const std::vector<uint16_t> echoes = {GLIDER_M_ALTITUDE, GLIDER_M_WATER_DEPTH};
  auto pings = readingTimes("", echoes);
  EXPECT_GT(pings[GLIDER_M_ALTITUDE].size(), 10U);
  auto seldom = readingTimes(" b_arg: c_alt_time(sec) 40\n", echoes);
  EXPECT_EQ(seldom[GLIDER_M_ALTITUDE], (std::vector<double>{40, 80}));
  EXPECT_EQ(seldom[GLIDER_M_WATER_DEPTH], (std::vector<double>{40, 80}));
  EXPECT_TRUE(readingTimes(" b_arg: c_alt_time(sec) -1\n", echoes).empty());
}

/// As comet's log of SPIRAL.MI shows: the dive that it needs the altitude for turns at it.
TEST(FlightController, ADiveToAnAltitudeSwitchesTheAltimeterOn) {
  Controller c(kFlownSurface + kFlownYo +
                   " b_arg: d_target_altitude(m) 4\nbehavior: sensors_in\n"
                   " b_arg: c_alt_time(sec) -1\n",
               22);
  double deepest = 0;
  size_t pings = 0, on_climbs = 0;
  c.fly(400, [&] {
    deepest = std::max(deepest, c.depth);
    const bool fresh = c.controller.array().fresh(GLIDER_M_ALTITUDE);
    pings += fresh ? 1U : 0U;
    on_climbs += fresh && c.depth < deepest - 6 ? 1U : 0U;
  });
  EXPECT_GT(pings, 5U);
  EXPECT_EQ(on_climbs, 0U) << "it is off where no altitude is asked for";
  EXPECT_GT(deepest, 15);
  EXPECT_LT(deepest, 21.5);
}

TEST(FlightController, ADepthRateIsOverTheTimeBetweenTwoReadings) {
  Controller c(kFlownSurface + kFlownYo + "behavior: sensors_in\n b_arg: c_pressure_time(sec) 20\n",
               100);
  std::map<double, double> depths;
  c.fly(100, [&] { depths[c.now] = c.depth; });
  EXPECT_NEAR(c.read(GLIDER_M_DEPTH_RATE), (depths[80] - depths[60]) / 20, 1e-6);
  EXPECT_GT(c.read(GLIDER_M_DEPTH_RATE), 0.05);
}

TEST(FlightController, WithoutGpsThereIsNoFix) {
  const auto fixes = [](const char* gps) {
    Controller c("behavior: prepare_to_dive\n b_arg: wait_time(s) 100\nbehavior: sensors_in\n" +
                     std::string(" b_arg: c_gps_on(bool) ") + gps + "\nbehavior: nop_cmds\n" +
                     " b_arg: nop_heading(bool) 1\n b_arg: nop_pitch(bool) 1\n" +
                     " b_arg: nop_bpump(bool) 1\n",
                 100);
    int found = 0;
    std::vector<double> held;
    c.fly(120, [&] {
      found += c.controller.array().fresh(GLIDER_M_GPS_LAT) ? 1 : 0;
      if (c.read(GLIDER_C_BALLAST_PUMPED) > 200) {
        held.push_back(c.now);
      }
    });
    return std::pair(found, held.size());
  };
  EXPECT_EQ(fixes("0"), (std::pair<int, size_t>(30, 0))) << "prepare_to_dive has its fix at once";
  EXPECT_EQ(fixes("60"), (std::pair<int, size_t>(2, 0)));
  EXPECT_EQ(fixes("-1"), (std::pair<int, size_t>(0, 30)))
      << "it holds the pump out for 100 s, and nop_cmds leaves it there";
}

TEST(FlightController, AFaultThatKeepsAFixFromTheSensorsLeavesTheVehicleWithoutOne) {
  const auto times = [](std::vector<uint16_t> missing) {
    Controller c(
        "behavior: prepare_to_dive\n b_arg: wait_time(s) 100\nbehavior: nop_cmds\n"
        " b_arg: nop_heading(bool) 1\n b_arg: nop_pitch(bool) 1\n"
        " b_arg: nop_bpump(bool) 1\n",
        100);
    std::vector<SensorFault> faults;
    for (const uint16_t id : missing) {
      SensorFault fault;
      fault.id = id;
      fault.kind = SensorFault::Kind::Missing;
      faults.push_back(fault);
    }
    SensorDamage damage(faults, 1);
    c.controller.damageBy(&damage);
    double held = -1;
    c.fly(120, [&] {
      damage.setNow(c.now);
      held = c.read(GLIDER_C_BALLAST_PUMPED) > 200 ? c.now : held;
    });
    return std::pair(held, std::isnan(c.read(GLIDER_M_GPS_MAG_VAR)));
  };
  EXPECT_EQ(times({}), std::pair(-1.0, false)) << "it has its fix at once";
  for (const std::vector<uint16_t>& missing :
       {std::vector<uint16_t>{GLIDER_M_GPS_LAT, GLIDER_M_GPS_LON},
        {GLIDER_M_GPS_LAT},
        {GLIDER_M_GPS_LON}}) {
    EXPECT_EQ(times(missing).first, 116) << "nop_cmds leaves the pump where it is";
    EXPECT_TRUE(times(missing).second);
  }
}

/// The positions of fixes are optional sensors of a platform.
TEST(FlightController, AVehicleThatDoesNotShowItsFixesHasThem) {
  for (const char* lacks : {"m_gps_lat", "m_gps_lon"}) {
    Controller c(
        "behavior: prepare_to_dive\n b_arg: wait_time(s) 100\nbehavior: nop_cmds\n"
        " b_arg: nop_heading(bool) 1\n b_arg: nop_pitch(bool) 1\n"
        " b_arg: nop_bpump(bool) 1\n",
        100, lacks);
    c.fly(8, [] {});
    EXPECT_FALSE(c.read(GLIDER_C_BALLAST_PUMPED) > 200) << "it waits for a fix without " << lacks;
    EXPECT_FALSE(std::isnan(c.read(GLIDER_M_GPS_MAG_VAR)));
  }
}

/// LMC: the origin is where the mission starts, and y points to magnetic north.
TEST(FlightController, LocalCoordinatesAreMagnetic) {
  Controller c(kFlownSurface + kFlownYo, 100);
  c.controller.startAt(300, -200);
  c.vehicle = slocumVehicle();
  c.fly(4, [] {});
  const double variation = c.read(GLIDER_M_GPS_MAG_VAR);
  ASSERT_GT(variation, 0.2) << "12 degrees west";
  EXPECT_EQ(c.read(GLIDER_M_X_LMC), 0);
  EXPECT_EQ(c.read(GLIDER_M_Y_LMC), 0);
  const Planar began = c.controller.reckoned();
  c.fly(300, [] {});
  // The heading is 0.5 rad from magnetic north, the reckoning without a current.
  const double x = c.read(GLIDER_M_X_LMC), y = c.read(GLIDER_M_Y_LMC);
  ASSERT_GT(std::hypot(x, y), 20);
  const Planar now = c.controller.reckoned();
  const double true_way = std::atan2(now.east - began.east, now.north - began.north);
  EXPECT_NEAR(std::atan2(x, y), true_way + variation, 1e-5);
  EXPECT_NEAR(std::hypot(x, y), std::hypot(now.east - began.east, now.north - began.north), 1e-3);
}

TEST(FlightController, AFailedDeviceBringsItUp) {
  Controller c(kFlownSurface + kFlownYo, 100);
  c.fly(200, [] {});
  ASSERT_GT(c.vehicle.depth(), 10);
  c.controller.failDevice(c.now);
  EXPECT_TRUE(c.controller.aborted());
  c.fly(4, [] {});
  EXPECT_EQ(c.read(GLIDER_X_MISSION_STATUS), 16);
  EXPECT_EQ(c.read(GLIDER_C_BALLAST_PUMPED), 233);
  EXPECT_NEAR(c.read(GLIDER_C_PITCH), 0.4538, 1e-6);
  EXPECT_TRUE(std::isnan(c.read(GLIDER_C_HEADING))) << "fin in the middle";
  EXPECT_EQ(c.controller.layer(), -1);
  double surfaced = kNoArgument;
  c.fly(2000, [&] {
    if (std::isnan(surfaced) && c.depth < 0.5) {
      surfaced = c.now;
    }
  });
  ASSERT_TRUE(c.controller.end());
  EXPECT_EQ(c.controller.end()->id, EventId::AbortedAtSurface);
  EXPECT_EQ(c.controller.end()->values, std::vector<EventValue>{"MS_ABORT_DEVICE_ERROR"});
  // The last cycle under water was 4 s before: 12 s after it the mission is over.
  EXPECT_EQ(c.now - 4, surfaced + 8);
}

TEST(FlightController, EndsNormallyWithItsSurface) {
  Controller c(kFlownSurface + kFlownYo, 100);
  c.fly(2000, [] {});
  ASSERT_TRUE(c.controller.end());
  EXPECT_EQ(c.controller.end()->id, EventId::MissionEndsNormally);
  EXPECT_FALSE(c.controller.aborted());
  EXPECT_EQ(c.read(GLIDER_X_MISSION_STATUS), 0);
}

/// Every bound of a b_arg: at it the file is accepted, beyond it refused.
TEST(Skeleton, BoundsAreInclusive) {
  struct Row {
    const char* behaviour;
    const char* argument;
    double lowest, highest;
  };
  const auto refused = [](const Row& row, double value) {
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    const uint32_t file = sources.add(
        "x.mi",
        fmt::format(
            "behavior: {}\n b_arg: {}(X) {}\n{}", row.behaviour, row.argument, value,
            std::string_view(row.behaviour) == "goto_wpt" ? "b_arg: wpt_units(enum) 2\n" : ""));
    const auto mission = slocum::readMission(sources, file, diagnostics);
    EXPECT_TRUE(mission);
    checkSkeleton(*mission, {file, 0, 0}, diagnostics);
    for (const auto& d : diagnostics.sorted()) {
      if (support::code(d.id) == "GL5107") {
        return true;
      }
    }
    return false;
  };
  for (const Row& row :
       {Row{"yo", "num_half_cycles_to_do", -1, 999999}, Row{"yo", "d_target_depth", 0, 2000},
        Row{"yo", "c_target_depth", 0, 2000}, Row{"yo", "d_pitch_value", -1.2, 1.2},
        Row{"yo", "c_pitch_value", -1.2, 1.2}, Row{"surface", "c_pitch_value", -1.2, 1.2},
        Row{"goto_wpt", "wpt_x", -18000, 18000}, Row{"goto_wpt", "wpt_y", -9000, 9000}}) {
    EXPECT_FALSE(refused(row, row.lowest)) << row.argument;
    EXPECT_FALSE(refused(row, row.highest)) << row.argument;
    EXPECT_FALSE(refused(row, (row.lowest + row.highest) / 2)) << row.argument;
    EXPECT_TRUE(refused(row, row.lowest - 0.01)) << row.argument;
    EXPECT_TRUE(refused(row, row.highest + 0.01)) << row.argument;
  }
  for (const char* wait : {"gps_wait_time", "keystroke_wait_time"}) {
    EXPECT_FALSE(refused({"surface", wait, 0, 0}, 0));
    EXPECT_FALSE(refused({"surface", wait, 0, 0}, 1e9));
    EXPECT_TRUE(refused({"surface", wait, 0, 0}, -1));
  }
}

}  // namespace
}  // namespace glider::simulator
