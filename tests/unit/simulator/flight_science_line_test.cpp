// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/line/flight_science_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// The vendor's line between the two computers: how late, in which order and what noise does to it.
namespace glider::simulator {
namespace {

struct Arrival {
  double at_s;
  PassingValue value;
};

/// What arrives until `until_s`, looked at every tenth of a second.
std::vector<Arrival> arrivals(LineDirection& line, double& now_s, double until_s) {
  std::vector<Arrival> all;
  for (; now_s < until_s; now_s += 0.1) {
    line.setNow(now_s);
    while (const auto one = line.next()) {
      all.push_back({now_s, *one});
    }
  }
  return all;
}

Faults of(const LineFault& fault) {
  Faults faults;
  faults.lines = {fault};
  return faults;
}

TEST(FlightScienceLine, ValuesAreLateByWhatTheLogsAndThePlatformFileSay) {
  FlightScienceLine line({}, 1);
  double now = 0;
  std::vector<double> lags;
  for (uint16_t i = 0; i < 400; ++i) {
    const double sent = now;
    line.to_flight.send({.id = i, .value = 1});
    for (const Arrival& one : arrivals(line.to_flight, now, sent + 9)) {
      lags.push_back(one.at_s - sent);
    }
  }
  ASSERT_EQ(lags.size(), 400U);
  std::ranges::sort(lags);
  EXPECT_GT(lags.front(), 0.19);
  EXPECT_NEAR(lags[200], 2.3, 0.4) << "the median";
  EXPECT_LE(lags[370], 4.5);
  EXPECT_GT(lags.back(), 6);
  EXPECT_LE(lags.back(), 8.2);
}

TEST(FlightScienceLine, ValuesOfOtherSensorsMayOvertakeButNoOlderOne) {
  LineDirection line({}, LineWay::ToFlight, kLagToFlight, 1);
  double now = 0;
  std::vector<Arrival> all;
  for (int i = 0; i < 200; ++i) {
    line.send({.id = 1, .value = 1.0 * i});
    line.send({.name = "u_mission_param_a", .value = 1.0 * i});
    for (const Arrival& one : arrivals(line, now, now + 1)) {
      all.push_back(one);
    }
  }
  for (const Arrival& one : arrivals(line, now, now + 9)) {
    all.push_back(one);
  }
  ASSERT_EQ(all.size(), 400U);
  double newest[2] = {-1, -1};
  bool overtook = false;
  for (const Arrival& one : all) {
    const size_t which = one.value.id == 1 ? 0 : 1;
    EXPECT_GT(one.value.value, newest[which]);
    newest[which] = one.value.value;
    overtook = overtook || newest[0] != newest[1];
  }
  EXPECT_TRUE(overtook);
  EXPECT_EQ(newest[0], 199);
  EXPECT_EQ(newest[1], 199);
}

TEST(FlightScienceLine, KeepsSixDecimalsAndSendsNoUnknownValue) {
  LineDirection line({}, LineWay::FromFlight, kLagToScience, 1);
  double now = 0;
  line.send({.id = 1, .value = 12.3456789});
  line.send({.id = 2, .value = std::numeric_limits<double>::quiet_NaN()});
  const std::vector<Arrival> all = arrivals(line, now, 2);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].value.value, 12.345679);
}

TEST(FlightScienceLine, AConsoleSuspendsItAndThenItGoesOn) {
  Faults faults;
  faults.console = {{10, 60}};
  LineDirection line(faults, LineWay::ToFlight, kLagToFlight, 1);
  double now = 0;
  (void)arrivals(line, now, 20);
  for (uint16_t i = 0; i < 50; ++i) {
    line.send({.id = i, .value = 1});
  }
  EXPECT_TRUE(arrivals(line, now, 60).empty());
  EXPECT_EQ(arrivals(line, now, 68.5).size(), 50U);
}

TEST(FlightScienceLine, LosesWhatNoiseHasDamaged) {
  const auto arrive = [](const LineFault& fault) {
    LineDirection line(of(fault), LineWay::ToFlight, kLagToFlight, 1);
    double now = 0;
    for (uint16_t i = 0; i < 1000; ++i) {
      line.send({.id = i, .value = 20.5});
    }
    return arrivals(line, now, 100).size();
  };
  // "20.500000" and six characters more.
  EXPECT_EQ(arrive({.way = LineWay::ToFlight, .cut = true}), 0U);
  EXPECT_EQ(arrive({.way = LineWay::ToFlight, .heard_at_baud = 57600}), 0U);
  EXPECT_EQ(arrive({.way = LineWay::FromFlight, .cut = true}), 1000U) << "of the other direction";
  EXPECT_EQ(arrive({.way = LineWay::ToFlight, .when = {5, 9}, .cut = true}), 1000U) << "not yet";
  EXPECT_NEAR(static_cast<double>(arrive({.way = LineWay::ToFlight, .loss = 0.01})),
              1000 * std::pow(0.99, 15), 40);
  EXPECT_NEAR(static_cast<double>(arrive({.way = LineWay::ToFlight, .flips = 0.05})),
              1000 * std::pow(0.95, 15), 60);
  const size_t bursts = arrive({.way = LineWay::ToFlight, .bursts = 0.002, .burst_bytes = 150});
  EXPECT_LT(bursts, 850U) << "ten values a burst";
  EXPECT_GT(bursts, 600U);
}

TEST(FlightScienceLine, FaultsMakeItLateAndRepeatOldValues) {
  LineDirection late(of({.way = LineWay::ToFlight, .delay_s = 30}), LineWay::ToFlight, kLagToFlight,
                     1);
  double now = 0;
  late.send({.id = 1, .value = 1});
  EXPECT_TRUE(arrivals(late, now, 30).empty());
  EXPECT_EQ(arrivals(late, now, 38.5).size(), 1U);
  LineDirection repeats(of({.way = LineWay::ToFlight, .replayed = 0.5}), LineWay::ToFlight,
                        kLagToFlight, 1);
  now = 0;
  int older = 0;
  double newest = -1;
  for (int i = 0; i < 100; ++i) {
    repeats.send({.id = 1, .value = 1.0 * i});
    for (const Arrival& one : arrivals(repeats, now, now + 10)) {
      older += one.value.value < newest ? 1 : 0;
      newest = std::max(newest, one.value.value);
    }
  }
  EXPECT_GT(older, 20);
}

TEST(FlightScienceLine, WithoutPowerWhatIsOnItsWayIsLost) {
  LineDirection line({}, LineWay::ToFlight, kLagToFlight, 1);
  double now = 0;
  line.send({.id = 1, .value = 1});
  line.dropUnsent();
  EXPECT_TRUE(arrivals(line, now, 9).empty());
  line.send({.id = 1, .value = 1});
  line.setNow(now + 9);
  line.dropArrived();
  EXPECT_FALSE(line.next());
}

}  // namespace
}  // namespace glider::simulator
