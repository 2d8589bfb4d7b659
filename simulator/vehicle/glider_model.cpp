// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/glider_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

constexpr double kMetresPerInch = 0.0254;
constexpr double kPascalPerDbar = 1e4;
constexpr double kCubicMetresPerCc = 1e-6;

/// The share of a first-order lag's distance that one step covers.
double share(double lag_s) {
  return 1 - std::exp(-VehicleModel::kStep / lag_s);
}

void limitDepth(VehicleState& s, double water_depth_m) {
  if (s.depth_m <= 0) {
    s.depth_m = 0;
    s.up_mps = std::min(s.up_mps, 0.0);
  } else if (s.depth_m >= water_depth_m) {
    s.depth_m = water_depth_m;
    s.up_mps = std::max(s.up_mps, 0.0);
  }
}

}  // namespace

GliderModel::GliderModel(const platforms::Motion& motion, const platforms::Envelope& envelope,
                         const VehicleSettings& settings)
    : motion_(motion),
      pump_cc_(envelope.pump_cc),
      fin_rad_(envelope.fin_rad),
      settings_(settings),
      pitch_share_(share(motion.pitch_lag_s)),
      yaw_share_(share(motion.yaw_lag_s)),
      speed_share_(share(motion.speed_lag_s)) {}

VehicleState GliderModel::start() const {
  VehicleState state;
  state.x_m = settings_.start_x_m;
  state.y_m = settings_.start_y_m;
  state.heading_rad = settings_.initial_heading_rad;
  // Pumped out, battery and fin in the middle.
  state.pump = {pump_cc_, pump_cc_, motion_.pump_rate_cc_s, -pump_cc_, pump_cc_};
  state.pitch_battery = {0, 0, motion_.pitch_battery_rate_in_s, -motion_.pitch_battery_limit_in,
                         motion_.pitch_battery_limit_in};
  state.fin = {0, 0, motion_.fin_rate_rad_s, -fin_rad_, fin_rad_};
  return state;
}

void GliderModel::moveMotors(VehicleState& s, const VehicleCommand& command) const {
  s.pump.target = command.pump_cc;
  s.pitch_battery.target = command.pitch_battery_in;
  s.fin.target = command.fin_rad;
  s.pump.step(kStep);
  s.pitch_battery.step(kStep);
  s.fin.step(kStep);
}

void GliderModel::movePitch(VehicleState& s) const {
  const double wanted = std::atan(
      motion_.trim_pump_per_m3 * s.pump.position * kCubicMetresPerCc -
      motion_.trim_battery_per_m * s.pitch_battery.position * kMetresPerInch + motion_.trim_offset);
  s.pitch_rad += (wanted - s.pitch_rad) * pitch_share_;
}

double GliderModel::buoyancy(const VehicleState& s, double density) const {
  return netBuoyancy(settings_.flight, density, s.depth_m * kPascalPerDbar,
                     s.pump.position * kCubicMetresPerCc);
}

void GliderModel::moveThroughWater(VehicleState& s, double density, bool aground) const {
  const double lift = buoyancy(s, density);
  const bool rests = aground || (s.depth_m <= 0 && lift >= 0);
  const SteadyFlight steady =
      rests ? SteadyFlight{} : steadyFlight(settings_.flight, s.pitch_rad, lift, density);
  s.ahead_mps += (steady.horizontal - s.ahead_mps) * speed_share_;
  s.up_mps += (steady.vertical - s.up_mps) * speed_share_;
}

void GliderModel::turn(VehicleState& s, double speed_mps) const {
  s.turn_rate_rad_s +=
      (motion_.yaw_gain_rad_s_m2 * std::sin(s.fin.position) * speed_mps * speed_mps -
       s.turn_rate_rad_s) *
      yaw_share_;
  constexpr double kTurn = 2 * std::numbers::pi;
  s.heading_rad += s.turn_rate_rad_s * kStep;
  s.heading_rad -= kTurn * std::floor(s.heading_rad / kTurn);
}

void GliderModel::step(VehicleState& s, const VehicleCommand& command, const Ocean& ocean,
                       double now_s) const {
  moveMotors(s, command);
  movePitch(s);
  const double density = ocean.density(s.depth_m, s.x_m, s.y_m, now_s);
  // A heavy vehicle lies on the bottom: friction stops it within some seconds and keeps it there in
  // the current, and the water above a bottom neither rises nor sinks.
  const bool aground =
      s.depth_m > 0 && s.depth_m >= ocean.waterDepth(s.x_m, s.y_m) && buoyancy(s, density) < 0;
  moveThroughWater(s, density, aground);
  turn(s, std::hypot(s.ahead_mps, s.up_mps));
  const Planar current = aground ? Planar{} : ocean.current(s.depth_m, s.x_m, s.y_m);
  s.x_m += (s.ahead_mps * std::sin(s.heading_rad) + current.east) * kStep;
  s.y_m += (s.ahead_mps * std::cos(s.heading_rad) + current.north) * kStep;
  const double rises = aground ? 0 : ocean.verticalCurrent(s.depth_m, s.x_m, s.y_m, now_s);
  s.depth_m -= (s.up_mps + rises) * kStep;
  limitDepth(s, ocean.waterDepth(s.x_m, s.y_m));
}

}  // namespace glider::simulator
