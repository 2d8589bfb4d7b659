// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/draw_faults.h"

#include "simulator/campaign/draw.h"
#include "simulator/campaign/draw_sensors.h"
#include "simulator/family/family.h"

#include <algorithm>

namespace glider::simulator {
namespace {

void addCheckpoints(Draw& draw, Faults& faults) {
  constexpr double kMostFlips = 3000;
  for (const Span& span : draw.passing(10, 250)) {
    faults.power.push_back(span);
    CardFault fault;
    fault.at_s = 0.5 * (span.from_s + span.to_s);
    fault.kind = static_cast<CardFault::Kind>(draw.below(3));
    fault.amount =
        fault.kind == CardFault::Kind::Flips ? draw.scale(1, kMostFlips) : draw.between(0, 1);
    faults.card.push_back(fault);
  }
}

void addClock(Draw& draw, Faults& faults) {
  const uint32_t count = 1 + draw.below(4);
  for (uint32_t i = 0; i < count; ++i) {
    faults.clock.push_back({draw.moment(), (draw.chance(0.5) ? 1 : -1) * draw.scale(1, 1e6)});
  }
}

void addLeftOver(Draw& draw, Faults& faults) {
  constexpr uint32_t kMostSequence = 65535, kNearTheEnd = 20, kSessions = 4;
  Leftover leftover;
  leftover.session = 1 + draw.below(kSessions);
  // Numbers wrap: in half of the draws they are about to.
  leftover.sequence = static_cast<uint16_t>(
      draw.chance(0.5) ? kMostSequence - draw.below(kNearTheEnd) : 1 + draw.below(kMostSequence));
  leftover.depth_m = draw.between(2, 30);
  faults.leftover.push_back(leftover);
}

void addLine(LineFaultKind kind, Draw& draw, Faults& faults) {
  LineFault fault;
  fault.way = draw.anyWay();
  std::vector<LineWay> ways;
  switch (kind) {
    case LineFaultKind::ByteLoss:
      fault.loss = draw.scale(1e-4, 0.3);
      break;
    case LineFaultKind::BitFlips:
      fault.flips = draw.scale(1e-4, 0.3);
      break;
    case LineFaultKind::Bursts:
      fault.bursts = draw.scale(1e-5, 0.01);
      fault.burst_bytes = draw.scale(2, 2000);
      break;
    case LineFaultKind::Delay:
      fault.delay_s = draw.scale(0.05, 20);
      break;
    case LineFaultKind::DoubledFrames:
      fault.doubled = draw.between(0.05, 1);
      break;
    case LineFaultKind::OldFrames:
      fault.replayed = draw.between(0.05, 0.5);
      // The flight controller repeats no earlier value.
      fault.way = fault.way == LineWay::FromFlight ? LineWay::ToFlight : fault.way;
      break;
    case LineFaultKind::HalfOpen:
      fault.way = draw.chance(0.5) ? LineWay::ToSbc : LineWay::FromSbc;
      fault.cut = true;
      break;
    case LineFaultKind::LineCut:
      fault.cut = true;
      ways = {LineWay::ToSbc, LineWay::FromSbc};
      break;
    case LineFaultKind::BaudMismatch:
      fault.heard_at_baud = draw.chance(0.5) ? 57600 : 230400;
      ways = {LineWay::ToSbc, LineWay::FromSbc};
      break;
    case LineFaultKind::LateLine:
      fault.delay_s = draw.between(2, 40);
      fault.way = LineWay::ToFlight;
      break;
    case LineFaultKind::FlightScience:
      fault.cut = true;
      fault.way = draw.chance(0.5) ? LineWay::ToFlight : LineWay::FromFlight;
      ways = draw.chance(0.5) ? std::vector{LineWay::ToFlight, LineWay::FromFlight}
                              : std::vector<LineWay>{};
  }
  for (const Span& span : draw.windows()) {
    fault.when = span;
    for (const LineWay way : ways.empty() ? std::vector{fault.way} : ways) {
      fault.way = way;
      faults.lines.push_back(fault);
    }
  }
}

void addFlightRestart(Draw& draw, Faults& faults) {
  const bool keeps_array = draw.chance(0.5);
  for (const Span& span : draw.passing(4, 200)) {
    faults.flight.push_back({span, keeps_array});
  }
}

void addWindows(const std::vector<Span>& windows, std::vector<Span>& spans) {
  spans.insert(spans.end(), windows.begin(), windows.end());
}

DrawnArgs drawArgs(Draw& draw, const FlightTimes& times) {
  DrawnArgs args;
  args.start_secs = draw.chance(0.5) ? 0 : draw.between(1, 200);
  args.max_depth_m = std::max(5.0, times.deepest_m * draw.between(0.4, 1.2));
  args.min_altitude_m = draw.between(2, 8);
  args.max_pitch_rad = draw.between(0.4, 0.75);
  args.hold_secs = draw.chance(0.3) ? 0 : draw.between(4, 60);
  // Includes more than the pump's range, and the wrong sign: a pilot's error.
  args.dive_pump_cc = draw.chance(0.2) ? draw.between(150, 1000) : -draw.between(150, 1000);
  args.climb_pump_cc = draw.chance(0.2) ? -draw.between(150, 1000) : draw.between(150, 1000);
  return args;
}

/// False for a fault that nothing on board can detect without a CTD (docs/depths.md), and for one
/// that does not concern the depth.
bool showsWithoutCtd(FaultKind kind) {
  return kind != FaultKind::SensorDrift && kind != FaultKind::SensorScale &&
         kind != FaultKind::HookSensor;
}

void addOne(FaultKind kind, Draw& draw, DrawnFaults& drawn);

void addSeveral(Draw& draw, DrawnFaults& drawn) {
  const uint32_t count = 2 + draw.below(3);
  for (uint32_t i = 0; i < count; ++i) {
    addOne(draw.otherKind(), draw, drawn);
  }
}

void addOne(FaultKind kind, Draw& draw, DrawnFaults& drawn) {
  Faults& faults = drawn.faults;
  drawn.kinds.push_back(kind);
  switch (kind) {
    case FaultKind::None:
      return;
    case FaultKind::Port:
      return addWindows(draw.windows(), faults.port);
    case FaultKind::Power:
      return addWindows(draw.windows(), faults.power);
    case FaultKind::Stuck:
      return addWindows(draw.windows(), faults.stuck);
    case FaultKind::Science:
      return addWindows(draw.passing(2, 300), faults.science);
    case FaultKind::Console:
      return addWindows(draw.passing(2, 300), faults.console);
    case FaultKind::Checkpoints:
      return addCheckpoints(draw, faults);
    case FaultKind::FlightRestart:
      return addFlightRestart(draw, faults);
    case FaultKind::FlightAbort:
      return faults.aborts.push_back(draw.moment());
    case FaultKind::LeftOver:
      return addLeftOver(draw, faults);
    case FaultKind::Clock:
      return addClock(draw, faults);
    case FaultKind::TightLimits:
      drawn.args = drawArgs(draw, draw.times());
      return;
    case FaultKind::ShallowWater:
      drawn.water_depth_m = std::max(12.0, draw.times().deepest_m * draw.between(0.5, 1.2));
      return draw.chance(0.5) ? addOne(FaultKind::DeafAltimeter, draw, drawn) : void();
    case FaultKind::BothPressures:
      return addBothPressures(draw, faults);
    case FaultKind::NoCtd:
      drawn.vehicle.no_ctd = true;
      return;
    case FaultKind::DeafAltimeter:  // as in real logs: echoes in 4 to 5 % of cycles, from 36 m at
                                    // most
      drawn.vehicle.altimeter_range_m = draw.between(30, 36);
      drawn.vehicle.altimeter_dropout = draw.between(0.8, 0.95);
      return;
    case FaultKind::SlowPressure:
      drawn.vehicle.pressure_every_s = draw.between(4, 16);
      return;
    case FaultKind::Several:
      return addSeveral(draw, drawn);
#define LINE_FAULT(name, ...) case FaultKind::name:
#include "simulator/campaign/fault_kinds.def"
      return addLine(static_cast<LineFaultKind>(kind), draw, faults);
#define SENSOR_FAULT(name, ...) case FaultKind::name:
#include "simulator/campaign/fault_kinds.def"
      addSensor(static_cast<SensorFaultKind>(kind), draw, faults);
      return showsWithoutCtd(kind) && draw.chance(0.25) ? addOne(FaultKind::NoCtd, draw, drawn)
                                                        : void();
  }
}

}  // namespace

const char* nameOf(Manner manner) {
  switch (manner) {
    case Manner::Once:
      return "once";
    case Manner::Recurring:
      return "recurring";
    case Manner::Together:
      return "with another";
    case Manner::Handshake:
      return "in the handshake";
    case Manner::Exit:
      return "in the exit";
    case Manner::ForGood:
      return "for good";
  }
  return "";
}

DrawnFaults drawFaults(FaultKind kind, Manner manner, uint64_t seed, const FlightTimes& times) {
  Draw draw(seed, manner, times);
  DrawnFaults drawn;
  addOne(kind, draw, drawn);
  if (manner == Manner::Together && kind != FaultKind::None && kind != FaultKind::Several) {
    addOne(draw.otherKind(), draw, drawn);
  }
  return drawn;
}

bool DrawnFaults::lasts() const {
  return args || water_depth_m || vehicle.differs() || !faults.sensors.empty();
}

void DrawnFaults::applyTo(const platforms::Platform& platform, Scenario& scenario) const {
  Faults possible = faults;  // those of sensors that this vehicle lacks are none
  std::erase_if(possible.sensors,
                [&](const SensorFault& fault) { return platform.find(fault.name) == nullptr; });
  scenario.faults.add(possible);
  if (vehicle.no_ctd) {
    scenario.sensors.ctd.dropout = 1;
  }
  if (vehicle.altimeter_range_m > 0) {
    scenario.sensors.altimeter.range_m = vehicle.altimeter_range_m;
    scenario.sensors.altimeter.dropout = vehicle.altimeter_dropout;
  }
  if (water_depth_m) {
    scenario.ocean.bottom.depth_m = *water_depth_m;
  }
  if (const Family* family = familyOf(platform); family != nullptr && scenario.own.has_value()) {
    family->apply_drawn(*this, scenario.own);
  }
}

}  // namespace glider::simulator
