// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/budget/budget.h"

#include "codegen/budget/image.h"
#include "codegen/budget/loops.h"
#include "codegen/budget/worst_path.h"
#include "codegen/link/debug_file.h"
#include "codegen/link/lld.h"
#include "codegen/program/compile.h"
#include "support/check.h"

#include <string_view>
#include <utility>
#include <vector>

namespace glider::codegen {
namespace {

using support::Result;

/// Which of the mission's functions a function of the runtime calls.
struct PointerCall {
  std::string_view file, function;
  const char* prefix;
};
constexpr PointerCall kPointerCalls[] = {
    {"step.cpp", "advance", "advance."},
    {"step.cpp", "firstTrue", "guards."},
    {"step.cpp", "fire", "act."},
    {"step.cpp", "enter", "enter."},
    {"step.cpp", "fly", "profile."},
    {"step.cpp", "fly", "route."},
    {"guard_table.cpp", "firstTrue", "holds."},
};

/// What a call through a pointer from these frames may reach. In a tick only the runtime makes such
/// calls, of functions that the mission's tables name. The innermost frame that makes one decides;
/// where the line tables are silent it may be any.
std::vector<uint64_t> pointerTargets(const Image& image, const std::vector<uint64_t>& polls,
                                     const std::vector<Frame>& frames) {
  const Frame& frame = frames.front();
  if (frame.line != 0 && frame.file == "readings.cpp" && frame.function == "pollSensors") {
    return polls;
  }
  std::vector<uint64_t> some, all = polls;
  bool placed = false;
  for (const PointerCall& call : kPointerCalls) {
    const std::vector<uint64_t> named = image.functionsNamed(call.prefix);
    all.insert(all.end(), named.begin(), named.end());
    if (frame.line != 0 && frame.file == call.file && frame.function == call.function) {
      some.insert(some.end(), named.begin(), named.end());
      placed = true;
    }
  }
  return placed ? some : all;
}

/// The C functions that are asked for readings of the SBC's own sensors.
std::vector<uint64_t> pollsOf(const Image& image, const ir::Mission& mission) {
  std::vector<uint64_t> polls;
  for (const ir::Sensor& sensor : mission.sensors) {
    if (!sensor.symbol.empty()) {
      const auto poll = image.function(sensor.symbol);
      CHECK(poll.has_value(), "an executable was linked without the function of a sensor");
      polls.push_back(*poll);
    }
  }
  return polls;
}

std::expected<uint64_t, std::string> tickInstructions(const Image& image,
                                                      const ir::Mission& mission,
                                                      const MissionSize& size) {
  if (image.code().empty()) {
    return std::unexpected("the machine code of this target is not followed");
  }
  const auto entry = image.function("gliderStep");
  if (!entry) {
    return std::unexpected("the executable has no `gliderStep`");
  }
  const std::vector<uint64_t> polls = pollsOf(image, mission);
  WorstPath path(image, {[&](const Frame& frame) { return turnsIn(frame, size); },
                         [&](const std::vector<Frame>& frames) {
                           return pointerTargets(image, polls, frames);
                         },
                         neverCalled});
  return path.bound(*entry);
}

}  // namespace

Result<Budget> measureBudget(const ir::Mission& mission, const ir::MissionFacts& facts,
                             const platforms::Board& board, const CodegenOptions& options) {
  auto program = compileProgram(mission, facts, board, options, ProgramKind::Executable, {"main"});
  if (!program) {
    return std::unexpected(program.error());
  }
  const auto linked = link(
      {ProgramKind::Executable, program->objects, program->further_inputs, {}, true, false}, board);
  if (!linked) {
    return std::unexpected(linked.error());
  }
  const auto image = Image::read(*linked, board);
  if (!image) {
    return std::unexpected(image.error());
  }
  Budget budget;
  budget.executable_bytes = splitDebug(*linked, board.name + ".debug").stripped.size();
  budget.memory_bytes = image->loadedBytes();
  budget.data_bytes = image->writableBytes();
  MissionSize size = sizeOf(mission, facts);
  size.data_bytes = budget.data_bytes;  // what is moved lies in there
  budget.tick_instructions = tickInstructions(*image, mission, size);
  return budget;
}

}  // namespace glider::codegen
