// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/inflection.h"

#include <cmath>

namespace glider::simulator {
namespace {

constexpr double kPumpThere = 10;       // cc, the pump's dead zone
constexpr double kBatteryThere = 0.05;  // in

}  // namespace

bool Inflection::isNeeded(const Targets& to, const Vehicle& vehicle) {
  const bool crosses = (to.pump_cc > 0) != (vehicle.pumpedCc() > 0);
  return crosses && std::fabs(to.pump_cc - vehicle.pumpedCc()) > vehicle.limits().pump_cc &&
         std::fabs(to.battery_in - vehicle.batteryPositionIn()) > kBatteryThere;
}

void Inflection::begin(const Targets& to, const Vehicle& vehicle) {
  const bool climbs = to.pump_cc > vehicle.pumpedCc();
  const bool aft = to.battery_in < vehicle.batteryPositionIn();
  to_ = to;
  ballast_first_ = climbs == aft;
  stage_ = Stage::First;
}

bool Inflection::arrived(bool ballast, const Vehicle& vehicle) const {
  return ballast ? std::fabs(vehicle.pumpedCc() - to_.pump_cc) <= kPumpThere
                 : std::fabs(vehicle.batteryPositionIn() - to_.battery_in) <= kBatteryThere;
}

void Inflection::command(bool ballast, Vehicle& vehicle) const {
  if (ballast) {
    vehicle.commandPump(to_.pump_cc);
  } else {
    vehicle.commandBatteryPosition(to_.battery_in);
  }
}

void Inflection::cycle(Vehicle& vehicle) {
  if (stage_ == Stage::First && arrived(ballast_first_, vehicle)) {
    stage_ = Stage::Second;
  }
  if (stage_ == Stage::Second && arrived(!ballast_first_, vehicle)) {
    stage_ = Stage::Done;
  }
  if (active()) {
    command(stage_ == Stage::First ? ballast_first_ : !ballast_first_, vehicle);
  }
}

}  // namespace glider::simulator
