// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/runtime.h"

/// The context of a running mission in a store that may lose its power at any write
/// (runtime/README.md, "Checkpoints").
namespace glider::runtime {

/// What a mission needs in addition to its context to continue.
struct LinkFacts {
  double vehicle_time = 0;  ///< of the vehicle's newest frame, s
  // The moment from which mission time counts, in both times, s.
  double anchor_vehicle = 0;
  double anchor_mission = 0;
  uint32_t session = 0;      ///< of the newest handshake; 0: none yet
  uint32_t instruction = 0;  ///< number of the newest instruction
  uint32_t clock = 0;        ///< of the vehicle in that frame, s since 1970; 0: unknown
  uint32_t reserved = 0;
};

class Checkpoint {
 public:
  /// Written in turn, so that all but one remain whole if a write fails or is interrupted.
  static constexpr uint32_t kSlots = 3;
  /// A slot begins at a multiple of this many bytes.
  static constexpr uint32_t kBlock = 4096;
  /// The least distance between two slots, bytes: what a card may erase and rewrite as one piece,
  /// and lose if its power fails meanwhile. The greatest allocation unit of cards of up to 32 GB
  /// (SD Physical Layer Simplified Specification 4.10, table 4-47).
  static constexpr uint32_t kEraseBlock = 4U << 20U;
  /// The longest time between checkpoints if nothing else requires one, s of mission time.
  static constexpr double kMostApart = 20;

  /// The size of a slot, bytes: whole blocks with room for a head and a context (of which only a
  /// part is kept).
  static constexpr uint32_t slotBytes(uint32_t context_bytes) {
    return (context_bytes + uint32_t{sizeof(Head)} + kBlock - 1) / kBlock * kBlock;
  }
  /// Where a slot begins in the store of a mission with a context of this size, bytes.
  static constexpr uint32_t offsetOf(uint32_t slot, uint32_t context_bytes) {
    return slot * (kEraseBlock + slotBytes(context_bytes));
  }
  /// The total size of the slots, bytes: a file of this size never grows.
  static constexpr uint32_t storeBytes(uint32_t context_bytes) {
    return offsetOf(kSlots - 1, context_bytes) + slotBytes(context_bytes);
  }

  enum class Found : uint8_t {
    Nothing,  ///< the store is empty, or there is none
    Good,     ///< it is in the context
    Broken,   ///< there were checkpoints of this program, but none is whole
    Foreign,  ///< the checkpoints found belong to another program
  };
  enum class Kept : uint8_t { NotDue, Written, Failed };

  /// `program`: see GliderRuntimeOptions. A store without functions keeps nothing.
  Checkpoint(const GliderStore& store, uint32_t program) : store_(store), program_(program) {}

  /// The newest whole checkpoint of this program, into `context`, which is laid out for its
  /// mission. For any result, the context must be made again if the checkpoint is not used. Later
  /// checkpoints are written after the one found.
  Found find(GliderContext& context, LinkFacts& facts);

  /// Keeps the context if something changed that must not be lost (a transition, a variable, the
  /// command in force, an instruction's number), or if the newest is kMostApart old. Returns when
  /// it would survive a power cut.
  Kept keep(const GliderContext& context, const LinkFacts& facts);

 private:
  struct Head {
    uint32_t magic;
    uint32_t check;  ///< CRC-32C over everything after it: the rest of the head, then the body
    uint32_t program;
    uint32_t number;  ///< increases by 1 with each checkpoint
    uint32_t bytes;   ///< of the body
    uint32_t reserved;
    LinkFacts facts;
  };
  [[nodiscard]] bool readHead(uint32_t slot, Head& head) const;
  [[nodiscard]] bool readBody(const Head& head, GliderContext& context) const;
  [[nodiscard]] bool isDue(const GliderContext& context, const LinkFacts& facts,
                           uint32_t digest) const;
  [[nodiscard]] bool write(const GliderContext& context, const LinkFacts& facts);

  GliderStore store_;
  uint32_t program_;
  uint32_t number_ = 0;  ///< of the newest
  // Of the newest that was written by this program:
  bool any_ = false;
  double time_ = 0;  ///< mission time
  uint32_t instruction_ = 0;
  uint32_t digest_ = 0;
};

}  // namespace glider::runtime
