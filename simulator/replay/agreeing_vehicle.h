// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/flight_science_link/flight_science_link.h"
#include "hooks/hookprog/hookprog.h"
#include "hooks/protocol/values.h"
#include "hooks/transport/memory.h"
#include "platforms/load/dictionary.h"
#include "simulator/replay/replay.h"
#include "simulator/sensors/provided.h"

#include <map>
#include <vector>

namespace glider::simulator {

/// A vehicle around the real hookprog whose hookbeh accepts every instruction, and whose sensors
/// report given values.
class AgreeingVehicle {
 public:
  /// `sbc` outlives this.
  AgreeingVehicle(const platforms::Platform& platform, SbcPort& sbc)
      : sbc_(sbc),
        numbers_(platform),
        dictionary_(platform),
        hookprog_(dictionary_.get(), {.virtual_time = true}),
        flight_(dictionary_.get()) {}

  /// A flight cycle before that of `offerControl`: the vehicle floats at the surface, and hookbeh
  /// waits for its start condition. A mission begins only after it has seen the surface.
  void floatAtSurface();
  /// A flight cycle in which hookbeh is ready; the sensors have the readings of `start`.
  void offerControl(const ReplayTick& start);
  /// True if the SBC has asked for control: its mission has started with that cycle's readings, at
  /// mission time 0.
  [[nodiscard]] bool askedForControl() const { return session_ != 0; }
  /// A flight cycle under the SBC's control, at a mission time after 0.
  void tick(const ReplayTick& tick);

  [[nodiscard]] hooks::SbcView sbc() const { return hookprog_.sbc(); }
  /// True if the SBC's mission has ended.
  [[nodiscard]] bool finished() const;

 private:
  void show(const std::vector<ReplayReading>& readings);
  /// One flight cycle at vehicle time `time`, s.
  void cycle(double time);
  void report(double time);
  void exchange(double time);
  void hearInstructions();
  void passOverEvents();
  static double ownSensor(void* self, uint16_t id, bool* fresh);

  SbcPort& sbc_;
  SensorNumbers numbers_;
  platforms::Dictionary dictionary_;
  hooks::Hookprog hookprog_;
  hooks::FlightScienceLink flight_;
  hooks::MemoryLine sbc_line_;
  hooks::MemoryLine flight_science_link_;
  std::map<uint16_t, double> science_;     ///< not reported yet
  std::vector<hooks::SensorUpdate> told_;  ///< of the flight controller, of this cycle
  std::vector<uint8_t> waiting_;           ///< bytes of the SBC that the line had no room for
  double origin_s_ = 0;                    ///< vehicle time of mission time 0
  hooks::HookState hook_state_ = hooks::HookState::Waiting;
  double session_ = 0;
  double sequence_ = 0;
  uint32_t cycles_ = 0;
};

}  // namespace glider::simulator
