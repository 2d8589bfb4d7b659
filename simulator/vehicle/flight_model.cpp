// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/flight_model.h"

#include <cmath>
#include <limits>

namespace glider::simulator {
namespace {

// A stalled hull moves broadside: 1.5 m long, 0.22 m wide (the vehicle's geometry); cross-flow drag
// of a cylinder 1.1, as in Hall and Anstee's (DSTO-TR-2576) model of a hull of this shape.
constexpr double kBroadsideArea = 1.5 * 0.22;
constexpr double kBroadsideDrag = 1.1;

SteadyFlight broadside(double buoyancy, double density) {
  SteadyFlight flight;
  flight.stalled = true;
  flight.speed = std::sqrt(2 * std::fabs(buoyancy) / (density * kBroadsideArea * kBroadsideDrag));
  flight.vertical = std::copysign(flight.speed, buoyancy);
  return flight;
}

}  // namespace

double netBuoyancy(const FlightCoefficients& c, double density, double pressure_pa,
                   double pumped_m3) {
  const double hull = c.hull_volume_m3 * (1 - c.compressibility_per_pa * pressure_pa);
  return kGravity * density * (hull + pumped_m3) - c.mass_kg * kGravity;
}

double angleOfAttack(const FlightCoefficients& c, double pitch) {
  // Roots of h(a) = C_D0 + C_D1 a^2 - (a_h + a_w) a tan(pitch + a), for a pitch made positive.
  // Newton's method from 0, where h is positive and decreasing, converges to the smallest root.
  constexpr int kMostSteps = 60;
  constexpr double kQuarterTurn = 1.57;
  const double theta = std::fabs(pitch);
  const double lift = c.hull_lift + c.wing_lift;
  double a = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const double t = std::tan(theta + a);
    const double h = c.drag + c.induced_drag * a * a - lift * a * t;
    const double slope = 2 * c.induced_drag * a - lift * (t + a * (1 + t * t));
    const double next = a - h / slope;
    if (!(next >= 0) || theta + next >= kQuarterTurn) {
      break;
    }
    if (std::fabs(next - a) <= 1e-15) {
      return std::copysign(next, pitch);
    }
    a = next;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

SteadyFlight steadyFlight(const FlightCoefficients& c, double pitch, double buoyancy,
                          double density) {
  const double attack = std::fabs(pitch) < kStallPitch ? std::numeric_limits<double>::quiet_NaN()
                                                       : angleOfAttack(c, pitch);
  const double glide = pitch + attack;
  const double squared =
      2 * buoyancy * std::sin(glide) /
      (density * c.reference_area_m2 * (c.drag + c.induced_drag * attack * attack));
  if (!(squared >= 0)) {
    return broadside(buoyancy, density);
  }
  const double speed = std::sqrt(squared);
  return {attack, speed, speed * std::cos(glide), speed * std::sin(glide), false};
}

}  // namespace glider::simulator
