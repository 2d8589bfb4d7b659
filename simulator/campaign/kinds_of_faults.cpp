// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/kinds_of_faults.h"

#include <cmath>
#include <set>
#include <string>

namespace glider::simulator {

FaultKind kindOf(const SensorFault& fault) {
  if (fault.name.starts_with("sci_hook")) {
    return FaultKind::HookSensor;
  }
  switch (fault.kind) {
    case SensorFault::Kind::Frozen:
      return FaultKind::SensorFrozen;
    case SensorFault::Kind::Value:
      return std::isnan(fault.value) ? FaultKind::SensorNan : FaultKind::SensorStuck;
    case SensorFault::Kind::Missing:
      return FaultKind::SensorMissing;
    case SensorFault::Kind::Drift:
    case SensorFault::Kind::Offset:
    case SensorFault::Kind::Sways:  // slow and smooth: without a CTD nothing tells it from motion
      return FaultKind::SensorDrift;
    case SensorFault::Kind::Scale:
      return FaultKind::SensorScale;
    case SensorFault::Kind::Jumps:
      break;
  }
  return FaultKind::SensorJumps;
}

std::vector<FaultKind> kindsOf(const Faults& faults) {
  std::vector<FaultKind> kinds;
  const auto add = [&](bool there, FaultKind kind) {
    if (there) {
      kinds.push_back(kind);
    }
  };
  for (const LineFault& fault : faults.lines) {
    add(true, fault.cut || fault.heard_at_baud > 0 ? FaultKind::LineCut : FaultKind::ByteLoss);
  }
  // A sensor that is stuck and flickers, or sways, has two entries, and is one wrong sensor.
  std::set<std::string> seen;
  for (const SensorFault& fault : faults.sensors) {
    if (fault.kind == SensorFault::Kind::Sways) {
      add(seen.insert(fault.name).second, kindOf(fault));
    }
  }
  for (const SensorFault& fault : faults.sensors) {
    add(seen.insert(fault.name).second, kindOf(fault));
  }
  add(!faults.power.empty(), FaultKind::Power);
  add(!faults.port.empty(), FaultKind::Port);
  add(!faults.stuck.empty(), FaultKind::Stuck);
  add(!faults.science.empty(), FaultKind::Science);
  add(!faults.console.empty(), FaultKind::Console);
  add(!faults.clock.empty(), FaultKind::Clock);
  add(!faults.card.empty(), FaultKind::Checkpoints);
  add(!faults.flight.empty(), FaultKind::FlightRestart);
  add(!faults.leftover.empty(), FaultKind::LeftOver);
  add(!faults.aborts.empty(), FaultKind::FlightAbort);
  return kinds;
}

}  // namespace glider::simulator
