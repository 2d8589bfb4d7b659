// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Depth sensors that are stuck but look alive, as devised by a hostile review, each from several
// times of the flight onwards.

#include "platforms/load/platform.h"
#include "simulator/simulator.h"
#include "support/check.h"
#include "tests/depths/depth_faults.h"
#include "tests/depths/depth_flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glider::tests {
namespace {

using simulator::SensorFault;
using Kind = SensorFault::Kind;

SensorFault wrong(const char* name, Kind kind, double value, double share, simulator::Span when) {
  SensorFault out;
  out.name = name;
  out.kind = kind;
  out.value = value;
  out.share = share;
  out.when = when;
  return out;
}

/// Stuck from `from_s` on, and seven readings in ten are up to `by` beside that.
void addFlicker(simulator::Faults& faults, const char* name, double from_s, double by) {
  const simulator::Span when{from_s, simulator::kForever};
  faults.sensors.push_back(wrong(name, Kind::Frozen, 0, 1, when));
  faults.sensors.push_back(wrong(name, Kind::Jumps, by, 0.7, when));
}

constexpr Plan kYo26{.top_m = 4, .bottom_m = 58};
constexpr Plan kYo45{.top_m = 4, .bottom_m = 58, .pitch_rad = 0.785};
constexpr Plan kHover50{.bottom_m = 50, .hovers = true};

/// A vehicle, heavier by `heavy_kg`, under a hookbeh with this max_depth.
struct Flight {
  Plan plan;
  double greatest_m = 60;
  double hours = 1.2;
  double heavy_kg = 0;
};

/// The deepest of flights whose faults begin at moments 80 s apart.
template <typename Make>
double deepest(const Flight& flight, const Make& faults) {
  double deepest = 0;
  for (int k = 0; k < 7; ++k) {
    simulator::Scenario scenario = diveScenario(hookbehSkeleton(flight.greatest_m), 500);
    scenario.duration_s = flight.hours * 3600;
    scenario.vehicle.flight.mass_kg += flight.heavy_kg;
    scenario.faults = faults(600 + 80.0 * k);
    deepest = std::max(deepest, flyDive(&flight.plan, scenario, 1).deepest_m);
  }
  return deepest;
}

/// Without a CTD.
auto flickers(double by) {
  return [by](double from_s) {
    simulator::Faults faults;
    faults.sensors.push_back(noCtd());
    addFlicker(faults, "m_depth", from_s, by);
    return faults;
  };
}

TEST(StubbornDepths, FlickerByAnyAmount) {
  for (const double by : {0.01, 0.4, 1.1, 1.6, 3.0}) {
    EXPECT_LT(deepest({kYo26}, flickers(by)), 70) << by;
    EXPECT_LT(deepest({kYo45}, flickers(by)), 70) << by;
    EXPECT_LT(deepest({kHover50}, flickers(by)), 70) << by;
  }
}

TEST(StubbornDepths, OfAHeavyVehicle) {
  EXPECT_LT(deepest({kHover50, 60, 3, 0.07}, flickers(0.01)), 70);
  EXPECT_LT(deepest({kHover50, 60, 3, 0.09}, flickers(0.01)), 70);
  const Plan deep{.top_m = 4, .bottom_m = 195, .pitch_rad = 0.785};
  EXPECT_LT(deepest({deep, 200, 3, 0.08}, flickers(0.01)), 210);
}

TEST(StubbornDepths, AtZeroFromTheStartOfAShallowHover) {
  for (const double bottom : {1.5, 2.0, 4.0}) {
    const Plan plan{.bottom_m = bottom, .hovers = true};
    EXPECT_LT(deepest({plan, 30, 2},
                      [](double from_s) {
                        simulator::Faults faults;
                        faults.sensors = {noCtd(), wrong("m_depth", Kind::Value, 0, 1,
                                                         {from_s - 600, simulator::kForever})};
                        return faults;
                      }),
              40)
        << bottom;
  }
}

TEST(StubbornDepths, ThatWereMissingForAWhile) {
  for (const Plan& plan : {kYo26, kYo45}) {
    EXPECT_LT(
        deepest({plan},
                [](double from_s) {
                  simulator::Faults faults;
                  faults.sensors = {
                      noCtd(), wrong("m_depth", Kind::Missing, 0, 1, {from_s, from_s + 140}),
                      wrong("m_depth", Kind::Value, 0, 1, {from_s + 140, simulator::kForever})};
                  return faults;
                }),
        70);
  }
}

TEST(StubbornDepths, BothTheVehiclesAndTheCtds) {
  for (const Plan& plan : {kYo45, kHover50}) {
    EXPECT_LT(deepest({plan},
                      [](double from_s) {
                        simulator::Faults faults;
                        addFlicker(faults, "m_depth", from_s, 0.01);
                        addFlicker(faults, "sci_water_pressure", from_s, 0.001);
                        return faults;
                      }),
              90);
  }
}

TEST(StubbornDepths, AndAPitchThatIsWrong) {
  EXPECT_LT(deepest({kYo26},
                    [](double from_s) {
                      simulator::Faults faults = flickers(0.01)(from_s);
                      faults.sensors.push_back(
                          wrong("m_pitch", Kind::Value, 1.5, 1, {0, simulator::kForever}));
                      return faults;
                    }),
            90);
}

/// Flies with SBCs that take control again, as boards do when they have power again.
Dived flyOn(const Plan& plan, simulator::Faults faults) {
  simulator::Scenario scenario = diveScenario(hookbehSkeleton(60), 500);
  scenario.duration_s = 1.2 * 3600;
  scenario.faults = std::move(faults);
  return flyDive(&plan, scenario, 1, true);
}

TEST(StubbornDepths, FromARestartOfTheFlightControllerOn) {
  for (const Plan& plan : {kYo26, kYo45}) {
    for (int k = 0; k < 7; ++k) {
      const double from_s = 600 + 80.0 * k;
      simulator::Faults faults;
      faults.sensors = {noCtd(),
                        wrong("m_depth", Kind::Value, 0, 1, {from_s - 8, simulator::kForever})};
      faults.flight.push_back({{from_s - 8, from_s}});
      faults.power = {{from_s - 8, from_s - 4}};
      EXPECT_LT(flyOn(plan, faults).deepest_m, 90) << from_s;
    }
  }
}

TEST(StubbornDepths, NoGuardComesInWhereTheSbcAloneIsCutOff) {
  for (const bool ctd : {true, false}) {
    for (int k = 0; k < 14; ++k) {
      const double from_s = 600 + 40.0 * k;
      simulator::Faults faults;
      faults.power = {{from_s, from_s + 30}};
      if (!ctd) {
        faults.sensors.push_back(noCtd());
      }
      const Plan plan{.top_m = 4, .bottom_m = 55};
      const Dived dived = flyOn(plan, faults);
      EXPECT_TRUE(dived.guards.empty()) << from_s << (ctd ? "" : ", no CTD") << ": guard "
                                        << *dived.guards.begin() << " at " << dived.guarded_s;
      EXPECT_GT(dived.dives, 3);
    }
  }
}

}  // namespace
}  // namespace glider::tests
