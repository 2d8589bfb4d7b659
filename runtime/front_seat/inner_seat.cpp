// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/front_seat/inner_seat.h"

#include "hooks/protocol/numbers.h"

namespace glider::runtime {

/// What has arrived from the vehicle, as frames for the program.
int32_t InnerSeat::read(void* self, uint8_t* bytes, uint32_t capacity) {
  auto& seat = *static_cast<InnerSeat*>(self);
  const GliderByteStream end = seat.inner_.right();
  int32_t count = end.read(end.self, bytes, capacity);
  if (count == 0) {
    seat.outer_.hear(seat.outer_.self);
    count = end.read(end.self, bytes, capacity);
  }
  return count == 0 && seat.outer_.closed(seat.outer_.self)
             ? static_cast<int32_t>(kGliderStreamClosed)
             : count;
}

int32_t InnerSeat::readInner(void* self, uint8_t* bytes, uint32_t capacity) {
  const GliderByteStream end = static_cast<InnerSeat*>(self)->inner_.left();
  return end.read(end.self, bytes, capacity);
}

/// What the seat sends; the program owes an answer from now on.
int32_t InnerSeat::writeInner(void* self, const uint8_t* bytes, uint32_t count) {
  auto& seat = *static_cast<InnerSeat*>(self);
  const GliderByteStream end = seat.inner_.left();
  const int32_t taken = end.write(end.self, bytes, count);
  seat.lockstep_.toSbc(bytes, taken > 0 ? static_cast<uint32_t>(taken) : 0);
  return taken;
}

int32_t InnerSeat::write(void* self, const uint8_t* bytes, uint32_t count) {
  auto& seat = *static_cast<InnerSeat*>(self);
  const GliderByteStream end = seat.inner_.right();
  const int32_t taken = end.write(end.self, bytes, count);
  const GliderByteStream line = seat.line();
  seat.seat_.serve(seat.outer_.clock(seat.outer_.self), seat.state(), seat.vehicle(), line);
  seat.seat_.finish(line, 0);
  const bool owed = !seat.lockstep_.settled();
  seat.lockstep_.fromSbc(bytes, taken > 0 ? static_cast<uint32_t>(taken) : 0);
  if (owed && seat.lockstep_.settled()) {
    seat.outer_.answer(seat.outer_.self);
  }
  return taken;
}

void InnerSeat::cycle() {
  cycles_ = (cycles_ + 1) % hooks::kMostSession;
  const GliderByteStream end = line();
  seat_.serve(outer_.clock(outer_.self), state(), vehicle(), end);
  seat_.watch(state());
  seat_.tick(state(), vehicle());
  seat_.finish(end, 0);
}

hooks::SeatState InnerSeat::state() const {
  hooks::SeatState state;
  outer_.state(outer_.self, &state);
  constexpr double kMostSeconds = 4294967295.0;
  const double clock = outer_.clock(outer_.self);
  state.cycle = cycles_;
  state.clock_s = clock > 0 && clock < kMostSeconds ? static_cast<uint32_t>(clock) : 0;
  return state;
}

bool InnerSeat::reading(void* self, uint16_t id, double* value) {
  auto& seat = *static_cast<InnerSeat*>(self);
  return seat.outer_.reading(seat.outer_.self, id, value);
}

void InnerSeat::instruct(void* self, const hooks::SensorList* instruction) {
  auto& seat = *static_cast<InnerSeat*>(self);
  hooks::InstructionWords words;
  for (const hooks::InstructionWord& word : hooks::kInstructionWords) {
    for (uint32_t i = 0; i < instruction->count; ++i) {
      if (instruction->values[i].id == hooks::sensorOf(seat.dictionary_, word.role)) {
        words.*word.word = instruction->values[i].value;
      }
    }
  }
  hooks::Instruction decoded;
  if (hooks::instructionOf(words, &decoded)) {
    seat.outer_.instruct(seat.outer_.self, decoded);
  }
}

}  // namespace glider::runtime
