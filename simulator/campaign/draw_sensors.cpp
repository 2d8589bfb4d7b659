// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/draw_sensors.h"

#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace glider::simulator {
namespace {

/// A sensor that missions and hookbeh depend on, and the range of its plausible readings.
struct Plausible {
  const char* name;
  double lowest, highest;
};
constexpr auto kSensors = std::to_array<Plausible>({
    {"m_depth", 0, 65},
    {"m_depth", 0, 3},  // the one that they depend on most
    {"m_depth", 0, 30},
    {"m_depth", 50, 70},
    {"m_pitch", -0.6, 0.6},
    {"m_altitude", 0, 100},
    {"m_present_secs_into_mission", 0, 5000},
    {"m_present_time", 1.25e9, 1.2500001e9},
    {"m_cycle_number", 0, 3000},
    {"sci_water_pressure", 0, 6.5},
    {"m_pressure", 0, 6.5},
    {"m_depth_rate", -0.3, 0.3},
});
/// Sensors that hookbeh's limits do not depend on, and the CTD, which hookbeh can work without.
constexpr auto kOtherSensors = std::to_array<Plausible>({
    {"m_heading", 0, 6.28},
    {"m_lat", 3909, 3912},
    {"m_lon", -7352, -7348},
    {"sci_water_temp", 5, 25},
    {"sci_water_pressure", 0, 6.5},
    {"m_battery", 9.8, 15},
});
/// Fields of an instruction, in which the check value detects faults, and the heartbeat.
constexpr auto kHookSensors = std::to_array<Plausible>({
    {"sci_hook_heartbeat", 0, 100},
    {"sci_hook_session", 1, 4},
    {"sci_hook_control", 0, 3},
    {"sci_hook_vertical", 0, 5},
    {"sci_hook_depth", 0, 60},
    {"sci_hook_pitch", -0.6, 0.6},
    {"sci_hook_heading", 0, 6},
    {"sci_hook_check", 0, 4294967295},
    {"sci_hook_sequence", 1, 65535},
});
/// Readings that none of these sensors can give.
constexpr std::array<double, 6> kNonsense = {-1e9, -50, 1e-30, 180, 5000, 1e30};

SensorFault::Kind howOf(SensorFaultKind kind, Draw& draw) {
  switch (kind) {
    case SensorFaultKind::SensorFrozen:
      return SensorFault::Kind::Frozen;
    case SensorFaultKind::SensorMissing:
      return SensorFault::Kind::Missing;
    case SensorFaultKind::SensorDrift:
      return SensorFault::Kind::Drift;
    case SensorFaultKind::SensorScale:
      return SensorFault::Kind::Scale;
    case SensorFaultKind::SensorJumps:
      return SensorFault::Kind::Jumps;
    case SensorFaultKind::HookSensor:
    case SensorFaultKind::OtherSensor:
      return static_cast<SensorFault::Kind>(draw.below(3));
    case SensorFaultKind::SensorStuck:
    case SensorFaultKind::SensorNan:
    case SensorFaultKind::SensorRange:
      break;
  }
  return SensorFault::Kind::Value;
}

std::span<const Plausible> sensorsOf(SensorFaultKind kind) {
  if (kind == SensorFaultKind::HookSensor) {
    return kHookSensors;
  }
  return kind == SensorFaultKind::OtherSensor ? std::span<const Plausible>(kOtherSensors)
                                              : kSensors;
}

double valueOf(SensorFaultKind kind, const Plausible& sensor, Draw& draw) {
  const double range = sensor.highest - sensor.lowest;
  switch (kind) {
    case SensorFaultKind::SensorNan:
      return std::nan("");
    case SensorFaultKind::SensorRange:
      return kNonsense[draw.below(kNonsense.size())];
    case SensorFaultKind::SensorDrift:  // through its range in ten minutes to ten hours
      return (draw.chance(0.5) ? 1 : -1) * range / draw.scale(600, 36000);
    case SensorFaultKind::SensorScale:
      return draw.chance(0.1) ? -1 : draw.scale(0.1, 3);
    case SensorFaultKind::SensorJumps:
      return range * draw.scale(0.05, 1);
    case SensorFaultKind::HookSensor:
      return std::round(draw.between(sensor.lowest, sensor.highest));
    case SensorFaultKind::SensorFrozen:
    case SensorFaultKind::SensorStuck:
    case SensorFaultKind::SensorMissing:
    case SensorFaultKind::OtherSensor:
      break;
  }
  return draw.between(sensor.lowest, sensor.highest);
}

/// A heartbeat that does not advance may also alternate between two old values.
void addOldHeartbeats(const SensorFault& first, Draw& draw, Faults& faults) {
  if (first.name == std::string_view("sci_hook_heartbeat") &&
      first.kind == SensorFault::Kind::Value) {
    SensorFault second = first;
    second.value += 1;
    second.share = draw.between(0.1, 0.9);
    faults.sensors.push_back(second);
  }
}

/// A failing CTD may instead report the absolute pressure, or be off by as much in the other
/// direction: it then never agrees with the depth.
bool isOffset(SensorFaultKind kind, const Plausible& sensor, Draw& draw) {
  return kind == SensorFaultKind::OtherSensor &&
         sensor.name == std::string_view("sci_water_pressure") && draw.chance(0.5);
}

SensorFault offsetOf(const Plausible& sensor, Draw& draw) {
  SensorFault fault;
  fault.name = sensor.name;
  fault.kind = SensorFault::Kind::Offset;
  fault.value = (draw.chance(0.5) ? 1 : -1) * draw.between(0.6, 3);  // bar
  return fault;
}

/// Adds a pressure that is stuck and flickers by up to `jump_bar`.
void addStuckPressure(const char* name, double jump_bar, const Span& when, Faults& faults) {
  SensorFault fault;
  fault.name = name;
  fault.when = when;
  faults.sensors.push_back(fault);
  fault.kind = SensorFault::Kind::Jumps;
  fault.value = jump_bar;
  faults.sensors.push_back(fault);
}

/// Adds a slow sine, to the truth or to a reading that is stuck.
void addSway(const Plausible& sensor, Draw& draw, Faults& faults) {
  SensorFault sways;
  sways.name = sensor.name;
  sways.kind = SensorFault::Kind::Sways;
  sways.value = (sensor.highest - sensor.lowest) * draw.scale(0.01, 0.1);
  sways.period_s = draw.scale(20, 400);
  SensorFault frozen;
  frozen.name = sensor.name;
  const bool stuck = draw.chance(0.5);
  for (const Span& span : draw.windows()) {
    sways.when = frozen.when = span;
    if (stuck) {
      faults.sensors.push_back(frozen);
    }
    faults.sensors.push_back(sways);
  }
}

}  // namespace

void addBothPressures(Draw& draw, Faults& faults) {
  const double jump_bar = draw.scale(1e-4, 0.3);  // a millimetre to three metres
  for (const Span& span : draw.windows()) {
    addStuckPressure("m_pressure", jump_bar, span, faults);
    addStuckPressure("sci_water_pressure", jump_bar, span, faults);
  }
}

void addSensor(SensorFaultKind kind, Draw& draw, Faults& faults) {
  const std::span<const Plausible> sensors = sensorsOf(kind);
  const Plausible& sensor = sensors[draw.below(static_cast<uint32_t>(sensors.size()))];
  if (isOffset(kind, sensor, draw)) {
    return faults.sensors.push_back(offsetOf(sensor, draw));
  }
  SensorFault fault;
  fault.name = sensor.name;
  if (kind == SensorFaultKind::SensorDrift && draw.chance(0.3)) {
    return addSway(sensor, draw, faults);
  }
  fault.kind = howOf(kind, draw);
  fault.value = valueOf(kind, sensor, draw);
  fault.share = draw.chance(0.3) ? 1 : draw.scale(0.01, 1);
  fault.share = fault.kind == SensorFault::Kind::Value ? 1 : fault.share;
  // A stuck sensor may still waver a little.
  SensorFault wavers = fault;
  wavers.kind = SensorFault::Kind::Jumps;
  wavers.value = (sensor.highest - sensor.lowest) * draw.scale(1e-5, 0.01);
  const bool stuck = kind == SensorFaultKind::SensorFrozen || kind == SensorFaultKind::SensorStuck;
  const bool flickers = stuck && draw.chance(0.3);
  for (const Span& span : draw.windows()) {
    fault.when = wavers.when = span;
    faults.sensors.push_back(fault);
    if (flickers) {
      faults.sensors.push_back(wavers);
    }
    addOldHeartbeats(fault, draw, faults);
  }
}

}  // namespace glider::simulator
