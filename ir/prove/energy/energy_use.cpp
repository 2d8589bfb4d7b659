// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/energy/energy_use.h"

#include <algorithm>

namespace glider::ir::prove {

using platforms::Draw;
using platforms::DrawWhen;

EnergyUse EnergyUse::operator+(const EnergyUse& other) const {
  EnergyUse sum{seconds + other.seconds,
                powered_s + other.powered_s,
                surface_s + other.surface_s,
                surfacings + other.surfacings,
                pump_out_j + other.pump_out_j,
                pump_in_j + other.pump_in_j,
                pitch_battery_s + other.pitch_battery_s,
                instruments_s};
  for (size_t i = 0; i < sum.instruments_s.size(); ++i) {
    sum.instruments_s[i] += other.instruments_s[i];
  }
  return sum;
}

EnergyUse EnergyUse::operator*(double factor) const {
  EnergyUse product{seconds * factor,         powered_s * factor,  surface_s * factor,
                    surfacings * factor,      pump_out_j * factor, pump_in_j * factor,
                    pitch_battery_s * factor, instruments_s};
  for (double& one : product.instruments_s) {
    one *= factor;
  }
  return product;
}

bool readsWhatMeasures(const Mission& mission, const Draw& draw) {
  return std::ranges::any_of(mission.sensors, [&](const Sensor& sensor) {
    return std::ranges::find(draw.sensors, sensor.vehicle_name) != draw.sensors.end();
  });
}

namespace {

/// Whether a state says how often the instrument of a row reads.
bool switches(const Mission& mission, const Draw& draw) {
  return draw.instrument && std::ranges::any_of(mission.states, [&](const State& state) {
           return std::ranges::find(state.sampling, *draw.instrument, &Sampling::place) !=
                  state.sampling.end();
         });
}

}  // namespace

GreatestPower::GreatestPower(const Mission& mission, const platforms::Platform& platform,
                             const std::optional<platforms::BoardPower>& board) {
  for (const Draw& draw : platform.power.draws) {
    const double most = 1 + draw.spread;
    if (draw.when != DrawWhen::Read || readsWhatMeasures(mission, draw) ||
        switches(mission, draw)) {
      rows_.push_back(
          {draw.device, draw.when, draw.amount * most, draw.amount_per_m * most, draw.instrument});
    }
  }
  if (board) {
    rows_.push_back({std::string(platforms::kSbcDevice), DrawWhen::Always,
                     board->running_W * (1 + board->spread), 0});
  }
}

double GreatestPower::joules(const Row& row, const EnergyUse& use) {
  if (row.instrument) {
    return row.amount * use.instruments_s.at(*row.instrument);
  }
  switch (row.when) {
    case DrawWhen::Always:
    case DrawWhen::Read:
    case DrawWhen::Fin:  // it may always move
      return row.amount * use.powered_s;
    case DrawWhen::Surface:
      return row.amount * use.surface_s;
    case DrawWhen::Surfacing:
      return row.amount * use.surfacings;
    case DrawWhen::PumpOut:
      return use.pump_out_j;
    case DrawWhen::PumpIn:
      return use.pump_in_j;
    case DrawWhen::PitchBattery:
      return row.amount * use.pitch_battery_s;
  }
  return 0;
}

double GreatestPower::joules(const EnergyUse& use) const {
  double sum = 0;
  for (const Row& row : rows_) {
    sum += joules(row, use);
  }
  return sum;
}

std::vector<DeviceEnergy> GreatestPower::byDevice(const EnergyUse& use) const {
  std::vector<DeviceEnergy> all;
  for (const Row& row : rows_) {
    auto known = std::ranges::find(all, row.device, &DeviceEnergy::device);
    if (known == all.end()) {
      known = all.insert(all.end(), {row.device, 0});
    }
    known->joules += joules(row, use);
  }
  std::erase_if(all, [](const DeviceEnergy& one) { return !(one.joules > 0); });
  std::ranges::stable_sort(all, std::ranges::greater(), &DeviceEnergy::joules);
  return all;
}

double GreatestPower::pump(DrawWhen when, double cc, double depth_m) const {
  double sum = 0;
  for (const Row& row : rows_) {
    sum += row.when == when ? cc * (row.amount + row.amount_per_m * depth_m) : 0;
  }
  return sum;
}

double GreatestPower::pumpOut(double cc, double depth_m) const {
  return pump(DrawWhen::PumpOut, cc, depth_m);
}

double GreatestPower::pumpIn(double cc) const {
  return pump(DrawWhen::PumpIn, cc, 0);
}

namespace {

/// An SBC that naps may do so nearly all the time: nothing says that a mission must run it.
double leastOf(const platforms::BoardPower& board, bool naps) {
  const double watts = !naps ? board.running_W : board.sleep ? board.sleep->asleep_W : 0;
  return watts * (1 - board.spread);
}

}  // namespace

double restingPower(const Mission& mission, const platforms::Platform& platform,
                    const std::optional<platforms::BoardPower>& board) {
  double watts = board ? leastOf(*board, mission.nap_s.has_value()) : 0;
  for (const Draw& draw : platform.power.draws) {
    // A vehicle may lack what is drawn for while the mission reads it.
    if (draw.when == DrawWhen::Always && !switches(mission, draw)) {
      watts += draw.amount * (1 - draw.spread);
    }
  }
  return watts;
}

}  // namespace glider::ir::prove
