// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A program that begins again, without a checkpoint, while the vehicle still has the targets of an
// earlier one.

#include "flights/in_process_sbc.h"
#include "simulator/simulator.h"
#include "tests/world/fleet.h"
#include "tests/world/port_flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace glider::tests {
namespace {

constexpr double kShallow = 6, kDeep = 60;  // m, of the mission's first state and the second
constexpr double kShallowFor = 1200;        // s
constexpr double kOvershoot = 5;            // m
constexpr double kUpWithin = 400;           // s: from 60 m

FlyingMission mission() {
  return *loadMission("restart",
                      "mission restart\n\n"
                      "flightprofile stays(bottom: length)\nbegin\n"
                      "  entry do descend(bottom, 26 deg) end\n"
                      "end\n\n"
                      "state shallow\nbegin\n"
                      "  flightprofile stays(6 m)\n"
                      "  sensors missiontime, depth\n"
                      "  events\n    case missiontime > 20 min goto deep\nend\n\n"
                      "state deep\nbegin\n"
                      "  flightprofile stays(60 m)\n"
                      "  sensors missiontime, depth\n"
                      "  events\n    case missiontime > 5 h exit\nend\n");
}

/// Where the vehicle is, and when each program's mission began.
class RestartWatch final : public simulator::FlightObserver {
 public:
  void said(std::span<const uint8_t>, double) override {}
  bool cycle(const simulator::CycleView& view) override {
    depth_m_ = view.true_depth_m;
    if (view.time_s >= late_s_) {
      late_deepest_m_ = std::max(late_deepest_m_, depth_m_);
    }
    if (programs_.empty()) {
      return true;
    }
    Program& now = programs_.back();
    if (now.began_s < 0) {
      return true;
    }
    if (view.time_s < now.began_s + kShallowFor) {
      now.deepest_m = std::max(now.deepest_m, depth_m_);
    }
    deepest_m_ = std::max(deepest_m_, depth_m_);
    return true;
  }
  /// From then on lateDeepest() counts, s.
  void lookFrom(double late_s) { late_s_ = late_s; }
  [[nodiscard]] double lateDeepest() const { return late_deepest_m_; }
  void starts() { programs_.emplace_back(); }
  void polled(double now_s) {
    if (programs_.back().began_s < 0) {
      programs_.back().began_s = now_s;
      programs_.back().began_m = depth_m_;
    }
  }
  struct Program {
    double began_s = -1;   ///< its mission; negative: it has not
    double began_m = 0;    ///< the depth then
    double deepest_m = 0;  ///< in its first state
  };
  [[nodiscard]] const std::vector<Program>& programs() const { return programs_; }
  [[nodiscard]] double deepest() const { return deepest_m_; }

 private:
  std::vector<Program> programs_;
  double depth_m_ = 0, deepest_m_ = 0;
  double late_s_ = 1e9, late_deepest_m_ = 0;
};

/// What happens to the SBC and to the science computer.
struct Outage {
  double cut_s = 0;  ///< the SBC has no power from then on
  double lasts_s = 120;
  double science_s = 1e9;   ///< a restart: the vehicle reports the number of its mission file again
  bool keeps_card = false;  ///< else it is empty afterwards
};

RestartWatch fly(const Outage& outage, slocum::Release release) {
  const FlyingMission flown = mission();
  simulator::Scenario scenario;
  for (simulator::Scenario& one : scenarios()) {
    if (one.name == "default") {
      scenario = std::move(one);
    }
  }
  scenario.ocean.bottom = {.depth_m = 90};
  const PortFlight flight = planned(flown, scenario, {.release = release, .greatest_depth_m = 60});
  RestartWatch watch;
  simulator::SimulationSetup setup = setupOf(flown, flight, 1);
  watch.lookFrom(outage.cut_s + outage.lasts_s + kUpWithin);
  const auto kept = std::make_shared<flights::Card>();
  setup.restart_sbc = [&]() -> support::Result<std::unique_ptr<simulator::SbcPort>> {
    watch.starts();
    auto sbc = std::make_unique<flights::InProcessSbc>(
        flown.loaded, *flights::chooseParameters(flown.flown->mission, {}),
        outage.keeps_card ? kept : std::make_shared<flights::Card>(), true, portEnd(flight));
    sbc->watch([&watch](const GliderContext&, double now_s) { watch.polled(now_s); });
    return sbc;
  };
  setup.sbc = *setup.restart_sbc();
  setup.scenario.faults.power.push_back({outage.cut_s, outage.cut_s + outage.lasts_s});
  setup.scenario.faults.science.push_back({outage.science_s, outage.science_s + 20});
  setup.duration_s = 3 * 3600;
  setup.observer = &watch;
  EXPECT_TRUE(simulator::simulate(std::move(setup)).has_value());
  return watch;
}

TEST(PortRestart, WithoutItsCheckpointAProgramBeginsAgainAtTheSurfaceWithoutTheOldTarget) {
  for (const auto release : {slocum::Release::Common, slocum::Release::MissionModes}) {
    for (const double cut_s : {1700.0, 1800.0, 1900.0, 2000.0, 2400.0}) {
      const RestartWatch watch = fly({.cut_s = cut_s, .science_s = cut_s + 200}, release);
      ASSERT_EQ(watch.programs().size(), 2U);
      const RestartWatch::Program& again = watch.programs().back();
      ASSERT_GT(again.began_s, cut_s) << cut_s;
      EXPECT_LE(again.began_m, slocum().world.start_depth_m) << cut_s;
      EXPECT_LE(again.deepest_m, kShallow + kOvershoot) << cut_s;
      EXPECT_GT(again.deepest_m, kShallow - 1) << "it flies";
      EXPECT_GT(watch.deepest(), kDeep) << "later as deep as before";
    }
  }
}

/// Its mission is over, but the vehicle would dive to the targets of the first program until its
/// own timer, for hours.
TEST(PortRestart, AProgramThatIsBackTooLateBringsTheVehicleUp) {
  for (const auto release : {slocum::Release::Common, slocum::Release::MissionModes}) {
    for (const double lasts_s : {301.0, 420.0, 1800.0}) {
      const RestartWatch watch =
          fly({.cut_s = 2000, .lasts_s = lasts_s, .keeps_card = true}, release);
      ASSERT_EQ(watch.programs().size(), 2U);
      EXPECT_GT(watch.deepest(), kDeep);
      EXPECT_LT(watch.lateDeepest(), 3) << lasts_s;
    }
  }
  const RestartWatch in_time =
      fly({.cut_s = 2000, .lasts_s = 200, .keeps_card = true}, slocum::Release::Common);
  EXPECT_GT(in_time.lateDeepest(), kDeep) << "it goes on";
}

TEST(PortRestart, WhichMissionFileFliesIsNotKnownBeforeTheVehicleSaysIt) {
  const RestartWatch watch = fly({.cut_s = 2000}, slocum::Release::Common);
  EXPECT_LT(watch.programs().back().began_s, 0) << "the vehicle is left to its own timer";
}

}  // namespace
}  // namespace glider::tests
