// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/instruction.h"
#include "hooks/protocol/lockstep.h"
#include "hooks/seat/seat.h"
#include "hooks/transport/byte_stream.h"
#include "hooks/transport/memory.h"

#include <new>
#include <stdint.h>

namespace glider::runtime {

/// What an InnerSeat asks of the code that speaks to the vehicle. Only `hear` calls the seat, and
/// only its cycle(): the bound of the stack rests on that (codegen/llvm/budget/callees.def).
struct OuterSeat {
  void* self;
  /// Takes what has arrived from the vehicle; calls InnerSeat::cycle() when a cycle is complete.
  void (*hear)(void* self);
  /// The program has answered a cycle: sends the vehicle what is in force.
  void (*answer)(void* self);
  /// The line to the vehicle is closed for good.
  bool (*closed)(void* self);
  /// Takes the value of a sensor that was reported since the last time; false if it was not.
  bool (*reading)(void* self, uint16_t id, double* value);
  /// An instruction whose check value is right.
  void (*instruct)(void* self, const hooks::Instruction& instruction);
  /// What the vehicle, or what stands for it, is doing.
  void (*state)(void* self, hooks::SeatState* state);
  /// By the vehicle's clock, s.
  double (*clock)(void* self);
};

/// To the program of a mission it is a vehicle that speaks the hook protocol, in memory: for a
/// vehicle that has another way to be steered. No heap; it must not move.
class InnerSeat {
 public:
  /// `dictionary` outlives it.
  InnerSeat(const GliderDictionary& dictionary, const OuterSeat& outer)
      : dictionary_(dictionary), outer_(outer), seat_(dictionary) {}
  InnerSeat(const InnerSeat&) = delete;
  InnerSeat& operator=(const InnerSeat&) = delete;

  /// The program's end.
  [[nodiscard]] GliderByteStream stream() { return {this, read, write}; }
  /// All readings of a cycle are there.
  void cycle();
  /// From now on the program does not keep its own time; only before there is a link.
  void useVirtualTime() { ::new (&seat_) hooks::Seat(dictionary_, {.virtual_time = true}); }

  [[nodiscard]] uint32_t cycles() const { return cycles_; }
  [[nodiscard]] hooks::SbcView sbc() const { return seat_.sbc(); }
  hooks::SeatEvent nextEvent() { return seat_.nextEvent(); }

 private:
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count);
  static int32_t readInner(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t writeInner(void* self, const uint8_t* bytes, uint32_t count);
  static bool reading(void* self, uint16_t id, double* value);
  static void instruct(void* self, const hooks::SensorList* instruction);
  static void beat(void* /*self*/, uint32_t /*heartbeat*/, bool /*asleep*/) {}

  [[nodiscard]] GliderByteStream line() { return {this, readInner, writeInner}; }
  [[nodiscard]] hooks::SeatVehicle vehicle() { return {this, reading, instruct, beat}; }
  [[nodiscard]] hooks::SeatState state() const;

  const GliderDictionary& dictionary_;
  OuterSeat outer_;
  hooks::Seat seat_;
  hooks::MemoryLine inner_;  ///< its left end is the seat's, its right end the program's
  hooks::Lockstep lockstep_;
  uint32_t cycles_ = 0;
};

}  // namespace glider::runtime
