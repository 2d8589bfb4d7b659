// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/simulator/propelled_vehicle.h"
#include "tests/unit/simulator/second_propelled.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <string>

/// The model of vehicles with a propeller against published numbers, against what was measured of
/// the LAUV, and against a second vehicle.
namespace glider::simulator {
namespace {

/// A steady turn of Fossen's REMUS 100.
struct Turn {
  double rpm, rudder_deg, u, v, r;
};

/// Ours, neutral as his is. Within 1 % in speed ahead, 2 % in the rate of turn and 5 % across.
void expectTurn(const Turn& turn) {
  PropelledFlight remus("remus100", 0, propelledWater(5000), 10);
  remus.command = {.fin_rad = turn.rudder_deg * kDegree, .rpm = turn.rpm};
  remus.fly(300);
  const BodyVelocity& v = remus.state.body;
  EXPECT_NEAR(v.surge, turn.u, 0.01 * turn.u) << turn.rpm << ' ' << turn.rudder_deg;
  EXPECT_NEAR(v.yaw, turn.r, 0.02 * turn.r + 1e-9) << turn.rpm << ' ' << turn.rudder_deg;
  // His propeller's torque heels the hull, which then slips a little without a rudder.
  const double slip = turn.rudder_deg == 0 ? 3e-4 : 0.05 * std::fabs(turn.v);
  EXPECT_NEAR(v.sway, turn.v, slip) << turn.rpm << ' ' << turn.rudder_deg;
}

/// His model after 300 s, rounded to four digits.
TEST(PropellerReference, TheRemusMeetsFossensSteadyTurns) {
  constexpr Turn kTurns[] = {{500, 0, 0.8314, 0, 0},
                             {500, 5, 0.8276, -0.0519, 0.01339},
                             {500, 10, 0.8218, -0.0699, 0.02333},
                             {1000, 0, 1.6741, 0, 0},
                             {1000, 5, 1.6645, -0.1163, 0.03652},
                             {1000, 10, 1.6515, -0.1529, 0.06087},
                             {1525, 0, 2.5536, 0, 0},
                             {1525, 5, 2.5375, -0.1849, 0.06300},
                             {1525, 10, 2.5168, -0.2406, 0.10286}};
  for (const Turn& turn : kTurns) {
    expectTurn(turn);
  }
}

TEST(PropellerReference, TheRemusMeetsFossensTable) {
  const auto path = std::filesystem::path(GLIDER_SOURCE_DIR) /
                    "../shared/data/ocean/remus100_fossen_reference.csv";
  std::ifstream in(path);
  if (!in) {
    GTEST_SKIP() << "the reference table is not here: " << path;
  }
  int rows = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'n') {
      continue;
    }
    // n_rpm, rudder_deg, u, v, w, p, q, r, …
    std::stringstream cells(line);
    double numbers[8] = {};
    for (double& number : numbers) {
      std::string cell;
      ASSERT_TRUE(std::getline(cells, cell, ',')) << line;
      number = std::stod(cell);
    }
    expectTurn({numbers[0], numbers[1], numbers[2], numbers[3], numbers[7]});
    ++rows;
  }
  EXPECT_EQ(rows, 20);
}

/// The static thrust and its loss follow from the propeller's coefficients, and mass, fins and
/// damping from the hull's.
TEST(PropellerReference, TheNumbersOfTheRemusFollowFromItsShape) {
  const platforms::PropellerMotion& remus = *propelledPlatform("remus100").motion->propelled;
  const double rho = 1026, d = 0.14, deduction = 0.9;
  EXPECT_NEAR(remus.propeller.static_thrust_n_s2, deduction * rho * std::pow(d, 4) * 0.4566, 1e-5);
  EXPECT_NEAR(remus.propeller.advance_loss_n_s2_m,
              deduction * rho * std::pow(d, 3) * 0.944 * (0.4566 - 0.1798) / 0.6632, 1e-5);
  EXPECT_NEAR(remus.hull.mass_kg, 4.0 / 3 * std::numbers::pi * rho * 0.8 * 0.095 * 0.095, 1e-3);
  EXPECT_NEAR(remus.hull.surge_drag_n_s2_m2, 0.5 * rho * 0.42 * std::numbers::pi * 0.095 * 0.095,
              1e-3);
  EXPECT_NEAR(remus.horizontal.fin_force_n_s2_m2, 0.5 * rho * 2 * 0.00665 * 0.5, 1e-3);
  EXPECT_NEAR(remus.vertical.fin_force_n_s2_m2, 0.5 * rho * 2 * 0.00665 * 0.7, 1e-3);
  const double swings = std::sqrt(0.02 * 9.81 * remus.hull.mass_kg / remus.hull.inertia_kg_m2);
  EXPECT_NEAR(remus.vertical.turn_damping_nm_s, 2 * 0.8 * swings * remus.hull.inertia_kg_m2, 2e-3);
  EXPECT_NEAR(remus.hull.surge_damping_n_s_m, (remus.hull.mass_kg + remus.hull.added_surge_kg) / 20,
              1e-4);
}

/// The yo between 10 and 1 m that DUNE's simulated LAUV flew: 150 m north in 118 s, pitches of
/// -14.8 and 13.9 degrees, 0.35 m/s down and up; the turns were commanded at 9 and 2 m, and it
/// turned at 9.12 and 1.71 m.
TEST(PropellerReference, TheLauvFliesTheYoThatWasMeasured) {
  PropelledFlight lauv("lauv", buoyancyOf("lauv"), propelledWater(100), 1.7);
  lauv.command.rpm = 1200;
  bool dives = true;
  double deepest = 0, shallowest = 10, down = 0, up = 0, nose_down = 0, nose_up = 0;
  for (int i = 0; i < 118 * 4; ++i) {
    dives = dives ? lauv.state.depth_m < 9 : lauv.state.depth_m <= 2;
    steerToDepth(lauv, dives ? 10 : 1, 15 * kDegree);
    lauv.fly(0.25);
    deepest = std::max(deepest, lauv.state.depth_m);
    nose_down = std::min(nose_down, lauv.state.pitch_rad);
    nose_up = std::max(nose_up, lauv.state.pitch_rad);
    if (i > 40 * 4) {
      shallowest = std::min(shallowest, lauv.state.depth_m);
      down = std::max(down, -lauv.state.up_mps);
      up = std::max(up, lauv.state.up_mps);
    }
  }
  EXPECT_NEAR(lauv.state.y_m, 150, 10);
  EXPECT_NEAR(nose_down, -14.8 * kDegree, 4 * kDegree);
  EXPECT_NEAR(nose_up, 13.9 * kDegree, 4 * kDegree);
  EXPECT_NEAR(deepest, 9.12, 0.4);
  EXPECT_NEAR(shallowest, 1.71, 0.4);
  EXPECT_NEAR(down, 0.35, 0.05);
  EXPECT_NEAR(up, 0.35, 0.05);
}

/// One flight of both from rest through `legs`; both are deep in water of one density.
struct PropelledLeg {
  double seconds, rpm, rudder, stern;
};

void flyWithSecond(const std::string& name, double buoyancy_kg,
                   std::initializer_list<PropelledLeg> legs) {
  const platforms::PropellerMotion& motion = *propelledPlatform(name).motion->propelled;
  PropelledFlight one(name, buoyancy_kg, propelledWater(5000), 2000);
  SecondPropelled second(motion);
  SecondPropelled::State two{};
  Triple place{0, 0, 2000};  // north, east, down
  double heading = 0, now = 0;
  const double density = Ocean(propelledWater(5000)).density(2000, 0, 0, 0);
  second.lift = 9.81 * (density * (motion.hull.mass_kg + buoyancy_kg) / 1025 - motion.hull.mass_kg);
  for (const PropelledLeg& leg : legs) {
    one.command = {.fin_rad = leg.rudder, .rpm = leg.rpm, .stern_plane_rad = leg.stern};
    for (int i = 0; i < 4 * leg.seconds; ++i, now += 0.25) {
      one.fly(0.25);
      second.turns_to = leg.rpm / 60;
      second.rudder_to = leg.rudder;
      second.stern_to = leg.stern;
      for (int k = 0; k < 250; ++k) {
        second.moveMotors(0.001);
        const SecondPropelled::State rate = second.rate(two);
        for (size_t n = 0; n < two.size(); ++n) {
          two[n] += rate[n] * 0.001;
        }
        const Triple moves = SecondPropelled::toEarth({two[0], two[1], two[2]}, two[5], heading);
        for (size_t n = 0; n < place.size(); ++n) {
          place[n] += moves[n] * 0.001;
        }
        heading += two[4] / std::cos(two[5]) * 0.001;
      }
      // The first moves its motors a substep before its hull.
      const BodyVelocity& v = one.state.body;
      const double first[] = {v.surge, v.sway, v.heave, v.pitch, v.yaw, one.state.pitch_rad};
      for (size_t n = 0; n < two.size(); ++n) {
        ASSERT_NEAR(first[n], two[n], 0.015) << name << " part " << n << " at " << now;
      }
    }
  }
  EXPECT_NEAR(one.state.depth_m, place[2], 0.02 * std::fabs(place[2] - 2000) + 0.1) << name;
  EXPECT_NEAR(std::remainder(one.state.heading_rad - heading, 2 * std::numbers::pi), 0, 0.05);
  EXPECT_NEAR(one.state.y_m, place[0], 2) << name;
  EXPECT_NEAR(one.state.x_m, place[1], 2) << name;
}

TEST(PropellerReference, ASecondVehicleFliesTheSame) {
  for (const std::string name : {"lauv", "remus100"}) {
    for (const double buoyancy_kg : {0.0, 0.7}) {
      flyWithSecond(name, buoyancy_kg,
                    {{30, 1000, 0, 0},
                     {30, 1000, 0.15, -0.05},
                     {20, 1400, -0.2, 0.08},
                     {30, 600, -0.1, -0.02},
                     {40, 0, 0.1, 0},
                     {30, 1500, 0.02, 0.1}});
    }
  }
}

/// The state in which nothing changes, by Newton's method on the second vehicle from `guess`.
SecondPropelled::State steady(const SecondPropelled& vehicle, SecondPropelled::State s) {
  constexpr size_t kCount = 6;
  for (int round = 0; round < 60; ++round) {
    const SecondPropelled::State f = vehicle.rate(s);
    double a[kCount][kCount + 1];
    for (size_t column = 0; column < kCount; ++column) {
      SecondPropelled::State beside = s;
      beside[column] += 1e-6;
      const SecondPropelled::State there = vehicle.rate(beside);
      for (size_t row = 0; row < kCount; ++row) {
        a[row][column] = (there[row] - f[row]) / 1e-6;
        a[row][kCount] = -f[row];
      }
    }
    for (size_t pivot = 0; pivot < kCount; ++pivot) {  // Gauss, with the greatest in the column
      size_t best = pivot;
      for (size_t row = pivot; row < kCount; ++row) {
        best = std::fabs(a[row][pivot]) > std::fabs(a[best][pivot]) ? row : best;
      }
      std::swap(a[pivot], a[best]);
      for (size_t row = 0; row < kCount; ++row) {
        const double factor = row == pivot ? 0 : a[row][pivot] / a[pivot][pivot];
        for (size_t column = pivot; column <= kCount; ++column) {
          a[row][column] -= factor * a[pivot][column];
        }
      }
    }
    for (size_t n = 0; n < kCount; ++n) {
      s[n] += 0.7 * a[n][kCount] / a[n][n];
    }
  }
  return s;
}

/// Long flights end where the forces balance.
TEST(PropellerReference, FlightsSettleWhereTheForcesBalance) {
  for (const std::string name : {"lauv", "remus100"}) {
    for (const double rpm : {700.0, 1000.0, 1400.0}) {
      for (const double rudder : {0.0, 0.1, 0.25}) {
        PropelledFlight one(name, 0, propelledWater(5000), 20);
        one.command = {.fin_rad = rudder, .rpm = rpm};
        one.fly(300);
        SecondPropelled second(*propelledPlatform(name).motion->propelled);
        second.turns = rpm / 60;
        second.rudder = rudder;
        const BodyVelocity& v = one.state.body;
        const SecondPropelled::State found =
            steady(second, {rpm / 700, -0.1 * rudder, 0, 0, rudder, 0});
        EXPECT_NEAR(v.surge, found[0], 2e-3) << name << rpm << ' ' << rudder;
        EXPECT_NEAR(v.sway, found[1], 2e-3) << name << rpm << ' ' << rudder;
        EXPECT_NEAR(v.yaw, found[4], 2e-3) << name << rpm << ' ' << rudder;
      }
    }
  }
}

}  // namespace
}  // namespace glider::simulator
