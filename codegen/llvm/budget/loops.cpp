// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/loops.h"

#include "ir/core/ops.h"
#include "ir/core/window_shape.h"
#include "runtime/abi/glider_abi.h"

#include <algorithm>
#include <string_view>

namespace glider::codegen {
namespace {

struct LoopRow {
  std::string_view file, function;
  uint64_t (*outer)(const MissionSize& m);
  uint64_t (*inner)(const MissionSize& m);  // null: no nested loops
};

#define COUNT(turns) [](const MissionSize& m) -> uint64_t { return (void)m, turns; }
constexpr LoopRow kRows[] = {
#define LOOP(file, function, turns, why) {file, function, COUNT(turns), nullptr},
#define LOOPS(file, function, turns, inner, why) {file, function, COUNT(turns), COUNT(inner)},
#define NEVER(function, why)
#include "codegen/llvm/budget/loops.def"
#undef LOOP
#undef LOOPS
#undef NEVER
};
#undef COUNT

constexpr std::string_view kNever[] = {
#define LOOP(file, function, turns, why)
#define LOOPS(file, function, turns, inner, why)
#define NEVER(function, why) function,
#include "codegen/llvm/budget/loops.def"
#undef LOOP
#undef LOOPS
#undef NEVER
};

void take(MissionSize& size, const ir::GuardTable& table) {
  constexpr uint64_t kBits = 32;
  size.table_words = std::max<uint64_t>(size.table_words, (table.rows.size() + kBits - 1) / kBits);
  // Along a column, each row begins to hold and ends at most once.
  size.table_turns = std::max<uint64_t>(size.table_turns, 2 * table.rows.size());
  size.table_columns = std::max<uint64_t>(size.table_columns, table.columns.size());
}

}  // namespace

MissionSize sizeOf(const Input& input) {
  const ir::Mission& mission = input.mission;
  MissionSize size;
  size.sensors = mission.sensors.size();
  size.calls = mission.uses.size();
  size.most_readings = kMostReadings;
  size.always_cases = mission.always.size();
  size.stack_depth = input.stack_depth;
  size.most_note_values = GLIDER_MOST_NOTE_VALUES;
  take(size, mission.always_table);
  for (const ir::State& state : mission.states) {
    take(size, state.table);
  }
  if (std::ranges::any_of(mission.behaviours,
                          [](const ir::Behaviour& one) { return !one.symbol.empty(); })) {
    size.window_bins = kLibraryWindowBins;
  }
  for (const ir::Temporal& temporal : mission.temporals) {
    if (ir::isWindow(temporal.kind) && temporal.leg == ir::Leg::None) {
      size.window_bins = std::max<uint64_t>(size.window_bins, ir::windowShape(temporal).bins);
    }
  }
  return size;
}

Turns turnsIn(const Frame& function, const MissionSize& size) {
  const auto row = std::ranges::find_if(kRows, [&](const LoopRow& one) {
    return one.file == function.file && one.function == function.function;
  });
  if (row == std::end(kRows)) {
    return {};
  }
  const uint64_t inner = row->inner == nullptr ? 0 : std::max<uint64_t>(row->inner(size), 1);
  return {std::max<uint64_t>(row->outer(size), 1), inner};
}

bool neverCalled(const std::string& symbol) {
  return std::ranges::find(kNever, symbol) != std::end(kNever);
}

}  // namespace glider::codegen
