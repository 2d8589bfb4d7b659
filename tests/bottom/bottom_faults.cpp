// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/bottom/bottom_faults.h"

#include "simulator/faults/faults.h"

namespace glider::tests {
namespace {

using simulator::Scenario;
using simulator::SensorFault;
using Kind = SensorFault::Kind;

void add(Scenario& scenario, double from_s, Kind kind, double value = 0, double share = 1) {
  SensorFault fault;
  fault.name = "m_altitude";
  fault.kind = kind;
  fault.value = value;
  fault.share = share;
  fault.when = {from_s, simulator::kForever};
  scenario.faults.sensors.push_back(fault);
}

/// m_altitude is wrong in this way.
auto reads(Kind kind, double value = 0, double share = 1) {
  return [=](Scenario& scenario, double from_s) { add(scenario, from_s, kind, value, share); };
}

/// The altimeter itself, from the start.
auto receives(double range_m, double share) {
  return [=](Scenario& scenario, double /*from_s*/) {
    scenario.sensors.altimeter.range_m = range_m;
    scenario.sensors.altimeter.dropout = 1 - share;
    scenario.sensors.altimeter.given = true;  // the trace then shows its echoes
  };
}

void sticks(Scenario& scenario, double from_s) {
  add(scenario, from_s, Kind::Frozen);
  add(scenario, from_s, Kind::Jumps, 0.1);
}

}  // namespace

const std::vector<AltimeterFault>& altimeterFaults() {
  static const std::vector<AltimeterFault> kFaults = {
      {"none", BottomRule::Never, [](Scenario&, double) {}},
      {"not read by the mission file", BottomRule::Never, [](Scenario&, double) {}, true},
      {"noise of 1 m", BottomRule::Never,
       [](Scenario& s, double) { s.sensors.altimeter.noise_m = 1; }},
      {"jumps by up to 5 m", BottomRule::Never, reads(Kind::Jumps, 5, 0.5)},
      {"range of 10 m", BottomRule::Never, receives(10, 1)},
      {"receives 5 % of echoes, to 36 m", BottomRule::Rare, receives(36, 0.05)},
      {"reads half", BottomRule::Never, reads(Kind::Scale, 0.5)},
      {"reads 5 m too little", BottomRule::Never, reads(Kind::Offset, -5)},
      {"reads 1.3 times", BottomRule::Never, reads(Kind::Scale, 1.3)},
      {"reads twice", BottomRule::Once, reads(Kind::Scale, 2)},
      {"reads 20 m too much", BottomRule::Once, reads(Kind::Offset, 20)},
      {"dead", BottomRule::Once, reads(Kind::Missing)},
      {"stuck", BottomRule::Once, reads(Kind::Frozen)},
      {"stuck, and flickers", BottomRule::Once, sticks},
      {"always 30 m", BottomRule::Once, reads(Kind::Value, 30)},
  };
  return kFaults;
}

}  // namespace glider::tests
