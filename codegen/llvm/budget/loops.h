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

/// What a frame can bring: hooks/protocol's kMostSubscriptions.
constexpr uint64_t kMostReadings = 64;

/// Of a window of the library's profiles: Windows::kBins of runtime/library/thermotrackyo.cpp.
constexpr uint64_t kLibraryWindowBins = 66;

/// Without data_bytes.
MissionSize sizeOf(const Input& input);

/// What loops.def says of a function, at least 1 for what has a row; nothing without one.
Turns turnsIn(const Frame& function, const MissionSize& size);
/// Whether loops.def says that the function is never called.
bool neverCalled(const std::string& symbol);

}  // namespace glider::codegen
