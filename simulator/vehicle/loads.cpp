// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/loads.h"

#include "hooks/protocol/sampling.h"

#include <algorithm>
#include <cmath>

namespace glider::simulator {

using platforms::Draw;
using platforms::DrawWhen;

Loads::Loads(const BatterySettings& settings)
    : propeller_(settings.power.propeller),
      sbc_W_(settings.sbc_W.value_or(0)),
      sbc_asleep_W_(settings.sbc_asleep_W.value_or(sbc_W_)),
      propeller_device_(platforms::placeOf(settings.power, platforms::kPropellerDevice)),
      sbc_device_(platforms::placeOf(settings.power, platforms::kSbcDevice)) {
  for (const Draw& draw : settings.power.draws) {
    rows_.push_back({draw, platforms::placeOf(settings.power, draw.device)});
  }
}

void Loads::read(std::span<const std::string> sensors) {
  for (Row& row : rows_) {
    row.is_read = std::ranges::any_of(row.draw.sensors, [&](const std::string& sensor) {
      return std::ranges::find(sensors, sensor) != sensors.end();
    });
  }
}

void Loads::order(uint32_t sampling) {
  for (Row& row : rows_) {
    if (row.draw.instrument) {
      row.on = platforms::shareOn(row.draw, hookSamplingOf(sampling, *row.draw.instrument));
    }
  }
}

double Loads::joules(const Row& row, const Doings& doings) {
  const Draw& draw = row.draw;
  const auto during = [&](bool on) { return on ? draw.amount * doings.seconds : 0; };
  switch (draw.when) {
    case DrawWhen::Always:
      return during(true) * row.on.value_or(1);
    case DrawWhen::Surface:
      return during(doings.at_surface);
    case DrawWhen::Surfacing:
      return doings.surfaces ? draw.amount : 0;
    case DrawWhen::Read:
      return row.on ? during(true) * *row.on : during(row.is_read && doings.sbc_powered);
    case DrawWhen::PumpOut:
      return std::max(doings.pumped_cc, 0.0) * (draw.amount + draw.amount_per_m * doings.depth_m);
    case DrawWhen::PumpIn:
      return std::max(-doings.pumped_cc, 0.0) * draw.amount;
    case DrawWhen::PitchBattery:
      return during(doings.pitch_battery_moves);
    case DrawWhen::Fin:
      return during(doings.fin_moves);
  }
  return 0;
}

void Loads::draw(Battery& battery, const Doings& doings) const {
  for (const Row& row : rows_) {
    battery.use(row.device, joules(row, doings));
  }
  if (!propeller_.rpm.empty()) {
    battery.use(propeller_device_, powerAt(propeller_, doings.rpm) * doings.seconds);
  }
  const double sbc_W = doings.sbc_asleep ? sbc_asleep_W_ : sbc_W_;
  battery.use(sbc_device_, doings.sbc_powered ? sbc_W * doings.seconds : 0);
}

double powerAt(const platforms::PropellerPower& power, double rpm) {
  const auto next = std::ranges::upper_bound(power.rpm, rpm);
  if (next == power.rpm.begin()) {
    return power.watt.front();
  }
  if (next == power.rpm.end()) {
    return power.watt.back();
  }
  const auto i = static_cast<size_t>(next - power.rpm.begin());
  const double share = (rpm - power.rpm[i - 1]) / (power.rpm[i] - power.rpm[i - 1]);
  return std::lerp(power.watt[i - 1], power.watt[i], share);
}

}  // namespace glider::simulator
