// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/image.h"
#include "ir/core/mission.h"

#include <cstdint>
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
  /// For any call of the program, at address `call`, by the rows of callees.def.
  [[nodiscard]] std::vector<uint64_t> inProgram(uint64_t call) const;

 private:
  const Image& image_;
  std::vector<uint64_t> polls_;  // of the SBC's own sensors
};

/// How many calls of a function may be active at one time, by callees.def; 1 without a row.
uint64_t callsAtOnce(const std::string& symbol);

}  // namespace glider::codegen
