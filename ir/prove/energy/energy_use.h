// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/sampling.h"
#include "ir/core/mission.h"
#include "platforms/load/board.h"
#include "platforms/load/platform.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace glider::ir::prove {

/// By the place of an instrument that missions switch: for how long it is on, s.
using InstrumentSeconds = std::array<double, kHookMostInstruments>;

/// What a part of a flight asks of the devices that draw power. Two parts add up.
struct EnergyUse {
  double seconds = 0;     ///< how long it lasts
  double powered_s = 0;   ///< of devices that always draw; a bound may count more than it lasts
  double surface_s = 0;   ///< at the surface
  double surfacings = 0;  ///< those that the power table counts
  double pump_out_j = 0;
  double pump_in_j = 0;
  double pitch_battery_s = 0;  ///< how long it moves
  InstrumentSeconds instruments_s{};

  EnergyUse operator+(const EnergyUse& other) const;
  EnergyUse operator-(const EnergyUse& other) const { return *this + other * -1; }
  EnergyUse operator*(double factor) const;
};

/// The share of a device.
struct DeviceEnergy {
  std::string device;
  double joules = 0;
};

/// The most that a vehicle's devices may take: by its power table, each row as far above its number
/// as its spread says.
class GreatestPower {
 public:
  /// `board`: what the SBC draws; none: not counted. Both outlive this.
  GreatestPower(const Mission& mission, const platforms::Platform& platform,
                const std::optional<platforms::BoardPower>& board);

  [[nodiscard]] double joules(const EnergyUse& use) const;
  /// The same by device, the greatest first, those that take nothing left out.
  [[nodiscard]] std::vector<DeviceEnergy> byDevice(const EnergyUse& use) const;

  /// To pump `cc` outwards at `depth_m`, or inwards, J.
  [[nodiscard]] double pumpOut(double cc, double depth_m) const;
  [[nodiscard]] double pumpIn(double cc) const;

 private:
  /// A device with what it takes for each second of a kind, and each surfacing.
  struct Row {
    std::string device;
    platforms::DrawWhen when = platforms::DrawWhen::Always;
    double amount = 0, amount_per_m = 0;
    std::optional<uint32_t> instrument = {};  ///< its place: it is on only then
  };
  [[nodiscard]] static double joules(const Row& row, const EnergyUse& use);
  /// Of pumping as the rows that are about it say.
  [[nodiscard]] double pump(platforms::DrawWhen when, double cc, double depth_m) const;

  std::vector<Row> rows_;
};

/// Whether the mission reads what a device of the power table measures.
bool readsWhatMeasures(const Mission& mission, const platforms::Draw& draw);

/// What is drawn at all times at least, W: by the rows of devices that never rest, each as far
/// below its number as its spread says. The arguments are those of GreatestPower.
double restingPower(const Mission& mission, const platforms::Platform& platform,
                    const std::optional<platforms::BoardPower>& board);

}  // namespace glider::ir::prove
