// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/vehicle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

// Rates of a 100 m pump (35-40 cc/s in real logs), of the pitch battery and of the fin motor.
constexpr double kPumpRate = 37.5;     // cc/s
constexpr double kBatteryRate = 0.15;  // in/s
constexpr double kFinRate = 0.098;     // rad/s

// Trim: tan pitch = T1 V + T2 x + T3, V in m3, x the battery's position in m; a published Slocum
// fit.
constexpr double kTrimPump = 1235;
constexpr double kTrimBattery = -28.8;
constexpr double kTrimOffset = 0.14;
constexpr double kMetresPerInch = 0.0254;
constexpr double kPitchLag = 3;  // s, the hull's swing after weight and volume have moved

// Yaw: tau dr/dt = c sin(fin) U^2 - r, a published Slocum fit.
constexpr double kYawGain = 0.5;  // rad s/m2
constexpr double kYawLag = 15;    // s

// Mass and added mass (0.92 of it across the hull) against a drag that is quadratic around 0.35
// m/s.
constexpr double kSpeedLag = 8;  // s

constexpr double kPascalPerDbar = 1e4;
constexpr double kCubicMetresPerCc = 1e-6;

/// The share of a first-order lag's distance that one step covers.
double share(double lag) {
  return 1 - std::exp(-Vehicle::kStep / lag);
}

}  // namespace

Vehicle::Vehicle(const VehicleSettings& settings)
    : coefficients_(settings.flight),
      // At the surface before a mission: pumped out, battery and fin in the middle.
      pump_{kPumpLimitCc, kPumpLimitCc, kPumpRate, -kPumpLimitCc, kPumpLimitCc},
      battery_position_{0, 0, kBatteryRate, -kBatteryLimitIn, kBatteryLimitIn},
      fin_{0, 0, kFinRate, -kFinLimitRad, kFinLimitRad},
      battery_(settings.battery),
      heading_(settings.initial_heading_rad) {}

void Vehicle::movePitch() {
  static const double kShare = share(kPitchLag);
  const double wanted =
      std::atan(kTrimPump * pump_.position * kCubicMetresPerCc +
                kTrimBattery * battery_position_.position * kMetresPerInch + kTrimOffset);
  pitch_ += (wanted - pitch_) * kShare;
}

void Vehicle::turn(double speed) {
  static const double kShare = share(kYawLag);
  turn_rate_ += (kYawGain * std::sin(fin_.position) * speed * speed - turn_rate_) * kShare;
  constexpr double kTurn = 2 * std::numbers::pi;
  heading_ += turn_rate_ * kStep;
  heading_ -= kTurn * std::floor(heading_ / kTurn);
}

void Vehicle::limitDepth(double water_depth) {
  if (depth_ <= 0) {
    depth_ = 0;
    up_ = std::min(up_, 0.0);
  } else if (depth_ >= water_depth) {
    depth_ = water_depth;
    up_ = std::max(up_, 0.0);
  }
}

void Vehicle::step(const Ocean& ocean, double now_s) {
  static const double kShare = share(kSpeedLag);
  battery_.idle(kStep, sbc_alive_);
  battery_.pump(pump_.step(kStep), depth_);
  battery_position_.step(kStep);
  fin_.step(kStep);
  movePitch();

  const double density = ocean.density(depth_, x_, y_, now_s);
  const double buoyancy = netBuoyancy(coefficients_, density, depth_ * kPascalPerDbar,
                                      pump_.position * kCubicMetresPerCc);
  const bool floating = depth_ <= 0 && buoyancy >= 0;
  const SteadyFlight steady =
      floating ? SteadyFlight{} : steadyFlight(coefficients_, pitch_, buoyancy, density);
  ahead_ += (steady.horizontal - ahead_) * kShare;
  up_ += (steady.vertical - up_) * kShare;
  turn(std::hypot(ahead_, up_));

  const Current current = ocean.current(depth_, x_, y_);
  x_ += (ahead_ * std::sin(heading_) + current.east) * kStep;
  y_ += (ahead_ * std::cos(heading_) + current.north) * kStep;
  depth_ -= (up_ + ocean.verticalCurrent(depth_, x_, y_, now_s)) * kStep;
  limitDepth(ocean.waterDepth(x_, y_));
}

}  // namespace glider::simulator
