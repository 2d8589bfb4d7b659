// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/instruction.h"
#include "hooks/seat/seat.h"
#include "platforms/load/dictionary.h"
#include "simulator/seat/sensor_array.h"
#include "simulator/seat/simulated_seat.h"

#include <optional>
#include <string>

namespace glider::simulator {

/// The one computer of a toy: the seat of the SBC is in it, it does at once what the SBC instructs,
/// and it climbs when the SBC has been silent for a while or has released control.
class ToySeat final : public SimulatedSeat {
 public:
  explicit ToySeat(const SeatSetup& setup);

  void startAt(const Vehicle& /*vehicle*/) override {}
  void begin(double /*now_s*/, SerialLine& /*sbc*/) override {}
  bool isDown(double /*now_s*/) override { return false; }
  void put(const std::string& /*sensor*/, double /*value*/) override {}
  void cycle(double now_s, bool sbc_gone, Vehicle& vehicle) override;
  bool serve(double now_s, const Vehicle& vehicle, SerialLine& sbc) override;

  hooks::SeatEvent nextEvent() override { return seat_.nextEvent(); }
  [[nodiscard]] hooks::SbcView sbc() const override { return seat_.sbc(); }
  [[nodiscard]] bool inControl() const override {
    return state_.hook_state == hooks::HookState::Active;
  }
  void noteTransition() override {}

  [[nodiscard]] double reading(uint16_t id) const override { return array_.get(id); }
  [[nodiscard]] double recorded(uint16_t id) const override { return array_.get(id); }
  [[nodiscard]] CycleView view(double now_s) const override;
  [[nodiscard]] const std::optional<News>& end() const override { return end_; }

  [[nodiscard]] std::span<const Column> firstColumns() const override;
  [[nodiscard]] std::span<const Column> secondColumns() const override { return {}; }

 private:
  static bool reading(void* self, uint16_t id, double* value);
  static void write(void* self, const hooks::SensorList* instruction);
  static void beat(void* self, uint32_t heartbeat, bool asleep);
  void obey(const hooks::Instruction& instruction);
  void steer(Vehicle& vehicle) const;

  const platforms::Platform& platform_;
  platforms::Dictionary dictionary_;
  SensorArray array_;
  hooks::Seat seat_;
  hooks::SeatState state_;
  hooks::Instruction obeyed_;
  bool cycle_is_new_ = false;
  double now_s_ = 0;
  double beat_s_ = 0;
  std::string why_;
  std::optional<News> end_;
};

}  // namespace glider::simulator
