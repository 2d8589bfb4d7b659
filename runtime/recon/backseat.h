// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/line_reader.h"
#include "hooks/transport/byte_stream.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/abi/recon_mission.h"
#include "runtime/checkpoint/checkpoint.h"
#include "runtime/front_seat/inner_seat.h"
#include "runtime/front_seat/refusals.h"
#include "runtime/front_seat/seat_session.h"
#include "runtime/recon/course.h"
#include "runtime/recon/readings.h"
#include "runtime/recon/takeover.h"
#include "runtime/recon/vehicle_clock.h"

#include <stdint.h>

namespace glider::runtime::recon {

/// Joins a mission's program to a vehicle that is steered by RECON. To the program it is a vehicle
/// that speaks the hook protocol: a stream() of its frames. To the vehicle it is a payload
/// computer. No heap; it must not move.
class Backseat {
 public:
  /// `mission` outlives it. `line`: to the vehicle. `checkpoint`: of the program that it goes on
  /// from; null: none.
  Backseat(const GliderMission& mission, const GliderReconMission& recon,
           const GliderByteStream& line, const LinkFacts* checkpoint);
  Backseat(const Backseat&) = delete;
  Backseat& operator=(const Backseat&) = delete;

  /// The program's end.
  [[nodiscard]] GliderByteStream stream() { return inner_.stream(); }
  /// The program has ended its mission, or does not go on with it: whether it may end. Not while
  /// the vehicle obeys: then the answers end the override, up to SeatSession::kReleaseAnswers of
  /// them.
  bool mayEnd();
  /// Reports in the log what has no effect on the vehicle.
  [[nodiscard]] AfterTick afterTick() { return refusals_.afterTick(); }
  /// Counts the bytes that arrived and belong to no line.
  [[nodiscard]] const uint32_t* damaged() const { return &damaged_; }

 private:
  static void hear(void* self);
  static void answer(void* self);
  static bool closed(void* self) { return static_cast<Backseat*>(self)->line_closed_; }
  static bool reading(void* self, uint16_t id, double* value);
  static void instruct(void* self, const hooks::Instruction& instruction);
  static void state(void* self, hooks::SeatState* state);
  static double clock(void* self);

  void take(const hooks::recon::Line& line);
  void takeState(const hooks::recon::State& said);
  void lookAtCycle();
  [[nodiscard]] SeatHold hold() const {
    return {takeover_.follows(), takeover_.isTaken(), isNearSurface()};
  }
  [[nodiscard]] bool isNearSurface() const;
  [[nodiscard]] bool asksForControl() const;
  [[nodiscard]] double missionTime() const;
  template <typename Message>
  void send(const Message& message);
  void sendGoals();
  void request(bool on);
  void release();
  void tell();
  bool fill();
  void flush();

  const GliderDictionary& dictionary_;
  uint32_t start_depth_cm_;  ///< no mission begins below; 0: at any depth
  GliderReconMission recon_;
  GliderByteStream line_;
  bool line_closed_ = false;
  bool virtual_time_ = false;
  uint32_t damaged_ = 0;
  hooks::recon::LineReader lines_;
  VehicleClock clock_;
  Readings readings_;
  Takeover takeover_;
  Course course_;
  SeatSession session_;
  Refusals refusals_;
  uint32_t requests_ = 0;  ///< of the same kind, one after another, without effect
  /// So many are needed to know that they have none: some are lost, and the answer takes its time.
  static constexpr uint32_t kInVain = 10;
  double began_s_;              ///< by the vehicle's clock; NaN: not yet
  double newest_cycle_s_ = -1;  ///< whole seconds of the vehicle's clock

  static constexpr uint32_t kMostTold = 4;      ///< events in an answer: the seat keeps the others
  static constexpr uint32_t kMostBytes = 2048;  ///< of an answer
  char out_[kMostBytes];
  uint32_t out_next_ = 0, out_end_ = 0;
  uint8_t in_[64];
  uint32_t in_next_ = 0, in_end_ = 0;
  InnerSeat inner_;
};

}  // namespace glider::runtime::recon
