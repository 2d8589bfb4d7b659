// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/packet_reader.h"
#include "hooks/transport/byte_stream.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/abi/imc_mission.h"
#include "runtime/checkpoint/checkpoint.h"
#include "runtime/front_seat/inner_seat.h"
#include "runtime/front_seat/refusals.h"
#include "runtime/imc/course.h"
#include "runtime/imc/plan.h"
#include "runtime/imc/readings.h"

#include <stdint.h>

namespace glider::runtime::imc {

/// The line to the vehicle.
struct VehicleLine {
  GliderByteStream stream;
  /// Ends the connection; the stream opens it again by itself, however it has ended, and reports
  /// kGliderStreamClosed while there is none. Null: the line cannot be opened again.
  void (*renew)(void* self) = nullptr;
  void* self = nullptr;
};

/// Joins a mission's program to a vehicle that is steered by IMC. To the program it is a vehicle
/// that speaks the hook protocol: a stream() of its frames. To the vehicle it is a back seat. No
/// heap; it must not move.
class Backseat {
 public:
  /// `mission` outlives it. `checkpoint`: of the program that it goes on from; null: none.
  Backseat(const GliderMission& mission, const GliderImcMission& imc, const VehicleLine& line,
           const LinkFacts* checkpoint);
  Backseat(const Backseat&) = delete;
  Backseat& operator=(const Backseat&) = delete;

  /// The program's end.
  [[nodiscard]] GliderByteStream stream() { return inner_.stream(); }
  /// Reports in the log what the vehicle refuses.
  [[nodiscard]] AfterTick afterTick() { return refusals_.afterTick(); }
  /// Counts the bytes that arrived and belong to no packet.
  [[nodiscard]] const uint32_t* damaged() const { return &damaged_; }

  /// So many answers that end the plan leave before the program ends.
  static constexpr uint32_t kReleaseCycles = 8;

 private:
  static void hear(void* self);
  static void answer(void* self);
  static bool closed(void* self) { return static_cast<Backseat*>(self)->line_closed_; }
  static bool reading(void* self, uint16_t id, double* value);
  static void instruct(void* self, const hooks::Instruction& instruction);
  static void state(void* self, hooks::SeatState* state);
  static double clock(void* self);

  void take(const hooks::imc::Packet& packet);
  void lookAtCycle();
  void followPlan();
  void noteFailure();
  /// The program has steered before: it goes on, rather than begins.
  [[nodiscard]] bool goesOn() const { return resumes_ || lost_session_ != 0; }
  [[nodiscard]] hooks::HookState unheld() const;
  [[nodiscard]] bool isUpToDate();
  bool startsPlan();
  void release();
  [[nodiscard]] hooks::HookAnswer decide(const hooks::Instruction& instruction);
  [[nodiscard]] double missionTime() const;
  [[nodiscard]] Place here() const { return {readings_.latitude(), readings_.longitude()}; }
  template <typename Message>
  void send(const Message& message);
  void sendReference();
  void tell();
  bool fill();
  void flush();
  [[nodiscard]] bool isInDoubt() const;
  void dropConnection();

  const GliderDictionary& dictionary_;
  GliderImcMission imc_;
  VehicleLine line_;
  bool line_closed_ = false;
  bool virtual_time_ = false;
  uint32_t damaged_ = 0;
  hooks::imc::PacketReader packets_;
  Readings readings_;
  Plan plan_;
  Course course_;
  Refusals refusals_;
  uint16_t vehicle_;    ///< its address; 0: not known yet
  double began_s_;      ///< by the vehicle's clock; NaN: not yet
  bool resumes_;        ///< it goes on from a checkpoint
  bool asked_ = false;  ///< the program has asked for control since it lost it
  bool another_vehicle_ =
      false;  ///< states of two vehicles arrive: whose plan it would be is not known
  double newest_cycle_s_ = -1;  ///< whole seconds of the vehicle's clock

  hooks::HookState state_ = hooks::HookState::Absent;
  hooks::HookAnswer answer_ = hooks::HookAnswer::None;
  uint16_t answered_ = 0;
  uint32_t session_ = 0, lost_session_ = 0;
  uint32_t releasing_ = 0;  ///< answers since the release was asked for, 0: it was not
  uint16_t release_ = 0;    ///< its number

  static constexpr uint32_t kMostTold = 4;      ///< entries in an answer: the seat keeps the others
  static constexpr uint32_t kMostBytes = 2048;  ///< of an answer
  uint8_t out_[kMostBytes];
  uint32_t out_next_ = 0, out_end_ = 0;
  static constexpr uint32_t kMostStuck = 5;
  uint32_t stuck_ = 0;  ///< cycles since the line took all of an answer
  uint8_t in_[64];
  uint32_t in_next_ = 0, in_end_ = 0;
  InnerSeat inner_;
};

}  // namespace glider::runtime::imc
