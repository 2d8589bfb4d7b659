// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/flight_model.h"

#include "tests/unit/simulator/slocum_vehicle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace glider::simulator {
namespace {

constexpr double kDegreeRad = std::numbers::pi / 180;
constexpr double kCc = 1e-6;
constexpr double kDbar = 1e4;

struct Case {
  double drag, pitch_deg, pumped_cc, force, attack_deg, glide_deg, speed, horizontal, vertical;
};

/// Published-model numbers at 20 dbar in water of 1025 kg/m3, to their printed digits.
TEST(FlightModel, GivesTheReferenceNumbers) {
  const Case cases[] = {
      {0.10, -26, -225, -2.326, -1.571, -27.571, 0.4413, 0.3912, -0.2042},
      {0.15, -20, -225, -2.326, -3.253, -23.253, 0.3122, 0.2869, -0.1233},
      {0.15, -26, -225, -2.326, -2.365, -28.365, 0.3584, 0.3154, -0.1703},
      {0.15, -26, -250, -2.578, -2.365, -28.365, 0.3773, 0.3320, -0.1792},
      {0.15, -35, -225, -2.326, -1.621, -36.621, 0.4134, 0.3318, -0.2466},
      {0.20, -26, -225, -2.326, -3.161, -29.161, 0.3088, 0.2697, -0.1505},
  };
  for (const Case& c : cases) {
    FlightCoefficients coefficients = slocumSettings().flight;
    coefficients.drag = c.drag;
    const double force = netBuoyancy(coefficients, 1025, 20 * kDbar, c.pumped_cc * kCc);
    const SteadyFlight flight = steadyFlight(coefficients, c.pitch_deg * kDegreeRad, force, 1025);
    EXPECT_NEAR(force, c.force, 5e-4);
    EXPECT_NEAR(flight.attack / kDegreeRad, c.attack_deg, 5e-4);
    EXPECT_NEAR((c.pitch_deg * kDegreeRad + flight.attack) / kDegreeRad, c.glide_deg, 6e-4);
    EXPECT_NEAR(flight.speed, c.speed, 5e-5);
    EXPECT_NEAR(flight.horizontal, c.horizontal, 5e-5);
    EXPECT_NEAR(flight.vertical, c.vertical, 5e-5);
    EXPECT_FALSE(flight.stalled);
  }
}

TEST(FlightModel, GivesTheExactCase) {
  const FlightCoefficients coefficients = slocumSettings().flight;
  const double force = netBuoyancy(coefficients, 1025, 0, -225 * kCc);
  const SteadyFlight flight = steadyFlight(coefficients, -0.454, force, 1025);
  EXPECT_NEAR(force, -2.26243125, 1e-11);
  EXPECT_NEAR(flight.attack, -0.041244772297, 1e-12);
  EXPECT_NEAR(flight.speed, 0.353541690321, 1e-12);
  EXPECT_NEAR(flight.horizontal, 0.311064507871, 1e-12);
  EXPECT_NEAR(flight.vertical, -0.168019637953, 1e-12);
}

std::vector<double> numbers(const std::string& line) {
  std::vector<double> out;
  std::stringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) {
    out.push_back(std::stod(cell));
  }
  return out;
}

TEST(FlightModel, AgreesWithTheReferenceTable) {
  const auto path =
      std::filesystem::path(GLIDER_SOURCE_DIR) / "../shared/data/ocean/flight_reference.csv";
  std::ifstream in(path);
  if (!in) {
    GTEST_SKIP() << "the reference table is not here: " << path;
  }
  size_t rows = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'C') {
      continue;
    }
    // Cd0, rho, dbar, pitch_deg, pitch_rad, cc, N, alpha_rad, alpha_deg, glide_deg, U, u, w, …
    const std::vector<double> v = numbers(line);
    ASSERT_GE(v.size(), 13U);
    FlightCoefficients coefficients = slocumSettings().flight;
    coefficients.drag = v[0];
    const double force = netBuoyancy(coefficients, v[1], v[2] * kDbar, v[5] * kCc);
    const SteadyFlight flight = steadyFlight(coefficients, v[3] * kDegreeRad, force, v[1]);
    ASSERT_NEAR(force, v[6], 1e-8 * std::fabs(v[6]) + 1e-9) << line;
    if (v[10] == 0) {
      EXPECT_TRUE(flight.stalled) << line;
    } else {
      ASSERT_NEAR(flight.attack, v[7], 1e-8 * std::fabs(v[7])) << line;
      ASSERT_NEAR(flight.speed, v[10], 1e-8 * v[10]) << line;
      ASSERT_NEAR(flight.horizontal, v[11], 1e-8 * v[11]) << line;
      ASSERT_NEAR(flight.vertical, v[12], 1e-8 * std::fabs(v[12])) << line;
    }
    ++rows;
  }
  EXPECT_EQ(rows, 1869U);
}

TEST(FlightModel, StallsWhereThereIsNoGlide) {
  const FlightCoefficients coefficients = slocumSettings().flight;
  for (const double pitch : {0.0, 10.9 * kDegreeRad, -10.9 * kDegreeRad}) {
    const SteadyFlight flight = steadyFlight(coefficients, pitch, -2, 1025);
    EXPECT_TRUE(flight.stalled);
    EXPECT_EQ(flight.horizontal, 0);
    EXPECT_LT(flight.vertical, -0.05);
  }
  const SteadyFlight against = steadyFlight(coefficients, 0.4, -2, 1025);
  EXPECT_TRUE(against.stalled) << "nose up but heavy";
  EXPECT_LT(against.vertical, 0);
  EXPECT_FALSE(steadyFlight(coefficients, 11.1 * kDegreeRad, 2, 1025).stalled);
  EXPECT_TRUE(std::isnan(angleOfAttack(coefficients, 0)));
  EXPECT_EQ(steadyFlight(coefficients, 0.4, 0, 1025).speed, 0);
}

}  // namespace
}  // namespace glider::simulator
