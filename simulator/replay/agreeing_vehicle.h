// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/values.h"
#include "hooks/seat/seat.h"
#include "hooks/transport/memory.h"
#include "platforms/load/dictionary.h"
#include "simulator/replay/replay.h"
#include "simulator/sensors/provided.h"

#include <map>
#include <vector>

namespace glider::simulator {

/// A vehicle of any family around the real seat, which accepts every instruction and whose sensors
/// report given values.
class AgreeingVehicle {
 public:
  /// `sbc` outlives this.
  AgreeingVehicle(const platforms::Platform& platform, SbcPort& sbc)
      : sbc_(sbc),
        numbers_(platform),
        dictionary_(platform),
        seat_(dictionary_.get(), {.virtual_time = true, .obeys = kEverything}) {}

  /// A flight cycle before that of `offerControl`: the vehicle floats at the surface, and does
  /// not offer control yet. A mission begins only after it has seen the surface.
  void floatAtSurface();
  /// A flight cycle in which control is offered; the sensors have the readings of `start`.
  void offerControl(const ReplayTick& start);
  /// True if the SBC has asked for control: its mission has started with that cycle's readings, at
  /// mission time 0.
  [[nodiscard]] bool askedForControl() const { return session_ != 0; }
  /// A flight cycle under the SBC's control, at a mission time after 0.
  void tick(const ReplayTick& tick);

  [[nodiscard]] hooks::SbcView sbc() const { return seat_.sbc(); }
  /// True if the SBC's mission has ended.
  [[nodiscard]] bool finished() const;

 private:
  /// All that a mission may need of a vehicle. It allows no naps: x_hook_nap_secs is not known.
  static constexpr uint16_t kEverything = hooks::kFeatureFixedFin | hooks::kFeatureActuators |
                                          hooks::kFeatureSampling | hooks::kFeatureNaps;

  void show(const std::vector<ReplayReading>& readings);
  /// One flight cycle at vehicle time `time`, s.
  void cycle(double time);
  void exchange(double time);
  void carry(double time);
  void passOverEvents();
  static bool reading(void* self, uint16_t id, double* value);
  static void write(void* self, const hooks::SensorList* instruction);

  SbcPort& sbc_;
  SensorNumbers numbers_;
  platforms::Dictionary dictionary_;
  hooks::Seat seat_;
  hooks::MemoryLine sbc_line_;
  hooks::SeatState state_;               ///< in this cycle
  std::map<uint16_t, double> readings_;  ///< of this cycle
  std::vector<uint8_t> waiting_;         ///< bytes of the SBC that the line had no room for
  double origin_s_ = 0;                  ///< vehicle time of mission time 0
  hooks::HookState hook_state_ = hooks::HookState::Waiting;
  uint32_t session_ = 0;   ///< of the newest instruction
  uint32_t sequence_ = 0;  ///< its number
};

}  // namespace glider::simulator
