// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/checkpoint/checkpoint.h"

#include "hooks/protocol/crc.h"

#include <stddef.h>

namespace glider::runtime {
namespace {

constexpr uint32_t kMagic = 0x334B4C47;  // "GLK3": the format's version is its last letter
constexpr uint32_t kAnyMagic = kMagic & 0xFFFFFFU;

/// The part of a context that a resume needs: everything after its pointers, up to what only one
/// tick needs (results of C functions, the memory of guard tables, notes). It is contiguous and
/// contains no pointer.
struct Body {
  explicit Body(const GliderContext& context)
      : bytes(reinterpret_cast<const uint8_t*>(&context.mission_time)),
        size(static_cast<uint32_t>(reinterpret_cast<const uint8_t*>(context.calls) - bytes)) {}
  const uint8_t* bytes;
  uint32_t size;
};
static_assert(offsetof(GliderContext, mission_time) ==
                  offsetof(GliderContext, note_values) + sizeof(double*) &&
              "no pointer stands behind mission_time");

/// The first checkpoint, number 1, goes to the first slot: a file that has any has that one.
uint32_t placeOf(uint32_t number, const GliderContext& context) {
  return Checkpoint::offsetOf((number - 1) % Checkpoint::kSlots, context.mission->context_bytes);
}

uint32_t digestOf(const void* from, const void* to, uint32_t before) {
  const auto* bytes = static_cast<const uint8_t*>(from);
  return hooks::crc32c(bytes, static_cast<uint32_t>(static_cast<const uint8_t*>(to) - bytes),
                       before);
}

/// What must not be lost even if no transition was made: variables, and the command in force.
uint32_t digestOf(const GliderContext& context) {
  return digestOf(context.variables, context.temporals,
                  digestOf(&context.vertical, &context.refused_commands, 0));
}

}  // namespace

bool Checkpoint::readHead(uint32_t slot, Head& head) const {
  constexpr auto kBytes = static_cast<int32_t>(sizeof(Head));
  return store_.read(store_.self, slot, reinterpret_cast<uint8_t*>(&head), sizeof head) == kBytes &&
         (head.magic & 0xFFFFFFU) == kAnyMagic;
}

bool Checkpoint::readBody(const Head& head, GliderContext& context) const {
  const Body body(context);
  const uint32_t at = placeOf(head.number, context) + sizeof head;
  return store_.read(store_.self, at, const_cast<uint8_t*>(body.bytes), body.size) ==
             static_cast<int32_t>(body.size) &&
         head.check ==
             hooks::crc32c(body.bytes, body.size, digestOf(&head.program, &head + 1, 0)) &&
         context.state < context.mission->state_count &&
         context.stack_depth <= context.mission->stack_limit;
}

Checkpoint::Found Checkpoint::find(GliderContext& context, LinkFacts& facts) {
  Found found = Found::Nothing;
  const uint32_t body = Body(context).size;
  uint32_t below = UINT32_MAX;
  for (uint32_t tried = 0; tried < kSlots && store_.read != nullptr; ++tried) {
    Head newest{};
    for (uint32_t slot = 0; slot < kSlots; ++slot) {
      Head head;
      if (!readHead(offsetOf(slot, context.mission->context_bytes), head)) {
        continue;
      }
      if (head.magic != kMagic || head.program != program_ || head.bytes != body) {
        found = found == Found::Nothing ? Found::Foreign : found;
      } else if ((head.number - 1) % kSlots == slot && head.number < below &&
                 head.number > newest.number) {
        newest = head;
      }
    }
    if (newest.number == 0) {
      break;
    }
    if (readBody(newest, context)) {
      number_ = newest.number;
      facts = newest.facts;
      return Found::Good;
    }
    found = Found::Broken;
    below = newest.number;
  }
  return found;
}

bool Checkpoint::isDue(const GliderContext& context, const LinkFacts& facts,
                       uint32_t digest) const {
  return !any_ || context.moved_list != GLIDER_NO_LIST || digest != digest_ ||
         facts.instruction != instruction_ || context.mission_time - time_ >= kMostApart;
}

bool Checkpoint::write(const GliderContext& context, const LinkFacts& facts) {
  const Body body(context);
  // A failed write is tried again in the same slot: the newest whole checkpoint is never
  // overwritten.
  Head head{kMagic, 0, program_, number_ + 1, body.size, 0, facts};
  head.check = hooks::crc32c(body.bytes, body.size, digestOf(&head.program, &head + 1, 0));
  const uint32_t at = placeOf(head.number, context);
  constexpr auto kBytes = static_cast<int32_t>(sizeof(Head));
  return store_.write(store_.self, at, reinterpret_cast<const uint8_t*>(&head), sizeof head) ==
             kBytes &&
         store_.write(store_.self, at + sizeof head, body.bytes, body.size) ==
             static_cast<int32_t>(body.size) &&
         store_.sync(store_.self) == 0;
}

Checkpoint::Kept Checkpoint::keep(const GliderContext& context, const LinkFacts& facts) {
  if (store_.write == nullptr) {
    return Kept::NotDue;
  }
  const uint32_t digest = digestOf(context);
  if (!isDue(context, facts, digest)) {
    return Kept::NotDue;
  }
  if (!write(context, facts)) {
    return Kept::Failed;
  }
  ++number_;
  any_ = true;
  time_ = context.mission_time;
  instruction_ = facts.instruction;
  digest_ = digest;
  return Kept::Written;
}

}  // namespace glider::runtime
