// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/values.h"
#include "simulator/seat/masked.h"
#include "simulator/seat/sensor_array.h"

#include <cstdint>
#include <span>

struct HookbehOutputs;

namespace glider::hooks {
using ::HookbehOutputs;
}  // namespace glider::hooks

namespace glider::simulator {

/// The state of the vehicle after a control cycle.
struct CycleView {
  double time_s = 0;
  hooks::HookState hook = hooks::HookState::Absent;
  double true_depth_m = 0;
  bool aborted = false;  ///< the flight controller has aborted its mission
  bool ended = false;    ///< the flight controller's mission is over
  const SensorArray& array;
  double mission_s = 0;         ///< of the flight controller's mission, which may have restarted
  double clearance_m = 0;       ///< true, over the bottom
  double used_J = 0;            ///< of the batteries, since the flight began
  double volts = 0;             ///< true, of the batteries
  bool commanded_whole = true;  ///< heading, pitch and pump were commanded, by any behaviour
  const hooks::HookbehOutputs* hookbeh = nullptr;  ///< what it commanded; null when it does not run
  uint8_t masked = 0;  ///< which slots hookbeh did not fill last, as hooks::kMaskedHeading…
  double east_m = 0, north_m = 0;  ///< true, of where the flight began
  double pumped_cc = 0;            ///< true position of the pump
  double left_J = 1e9;             ///< what the batteries can still give

  /// A behaviour above hookbeh controlled pitch or pump.
  [[nodiscard]] bool overridden() const { return masksPitchOrPump(masked); }
};

/// Observes a mission in flight, at points where no fault has an effect.
class FlightObserver {
 public:
  virtual ~FlightObserver() = default;
  /// The SBC sends `bytes`, seen at its own end of the line.
  virtual void said(std::span<const uint8_t> bytes, double now_s) = 0;
  /// A control cycle is over. False: nothing more needs to be observed, and the flight may end
  /// here.
  virtual bool cycle(const CycleView& view) = 0;
};

}  // namespace glider::simulator
