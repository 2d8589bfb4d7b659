// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/input.h"
#include "codegen/llvm/budget/worst_path.h"

#include <cstdint>

namespace glider::codegen {

/// The numbers of a mission that bound its loops.
struct MissionSize {
  uint64_t sensors = 0;
  uint64_t calls = 0;          ///< places that call C functions
  uint64_t most_readings = 0;  ///< in one frame
  uint64_t always_cases = 0;
  uint64_t stack_depth = 0;
  uint64_t most_note_values = 0;
  uint64_t table_words = 0;  ///< of the largest table of guards
  uint64_t table_turns = 0;
  uint64_t table_columns = 0;
  uint64_t window_bins = 0;  ///< of the largest window
  uint64_t data_bytes = 0;
};

/// The greatest number of readings in a frame: hooks/protocol's kMostSubscriptions.
constexpr uint64_t kMostReadings = 64;

/// For a window of the library's profiles: Windows::kBins of runtime/library/thermotrackyo.cpp.
constexpr uint64_t kLibraryWindowBins = 66;

/// Without data_bytes.
MissionSize sizeOf(const Input& input);

/// The bounds of loops.def for a function, at least 1 if it has a row; empty without one.
Turns turnsIn(const Frame& function, const MissionSize& size);
/// Whether the function is never called, according to loops.def.
bool neverCalled(const std::string& symbol);

}  // namespace glider::codegen
