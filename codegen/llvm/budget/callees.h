// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/image.h"
#include "ir/core/mission.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace glider::codegen {

/// The functions that a call through a pointer may reach, in the executable of a mission.
class Callees {
 public:
  /// Both must outlive it.
  Callees(const Image& image, const ir::Mission& mission);

  /// For a call in a tick, made from these frames: only the runtime makes such calls, of functions
  /// that the mission's tables name. The innermost frame that makes one decides; where the line
  /// tables have no information it may be any of them.
  [[nodiscard]] std::vector<uint64_t> inTick(const std::vector<Frame>& frames) const;
  /// For any call of the program, at address `call`, by the rows of callees.def: but none of the
  /// groups of functions that are `excluded`, a bit each.
  [[nodiscard]] std::vector<uint64_t> inProgram(uint64_t call, uint32_t excluded) const;
  /// The groups of which no function is called through a pointer while that at `entry` is active,
  /// by the rows of callees.def.
  [[nodiscard]] uint32_t excludedBy(uint64_t entry) const;

 private:
  struct Group {
    uint32_t group = 0;  ///< a bit
    uint32_t excluded = 0;
  };

  const Image& image_;
  std::vector<uint64_t> polls_;       // of the SBC's own sensors
  std::map<uint64_t, Group> groups_;  // of those that are in one
};

/// How many calls of a function may be active at one time, by callees.def; 1 without a row.
uint64_t callsAtOnce(const std::string& symbol);

}  // namespace glider::codegen
