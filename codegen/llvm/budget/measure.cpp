// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/measure.h"

#include "codegen/llvm/budget/callees.h"
#include "codegen/llvm/budget/disassembler.h"
#include "codegen/llvm/budget/image.h"
#include "codegen/llvm/budget/loops.h"
#include "codegen/llvm/budget/stack_bound.h"
#include "codegen/llvm/budget/worst_path.h"
#include "codegen/llvm/link/debug_file.h"
#include "codegen/llvm/link/lld.h"
#include "codegen/llvm/program/compile.h"
#include "support/check.h"

#include <utility>
#include <vector>

namespace glider::codegen {
namespace {

using support::Result;

std::expected<uint64_t, std::string> tickInstructions(const Image& image,
                                                      const ir::Mission& mission,
                                                      const MissionSize& size) {
  if (image.code().empty()) {
    return std::unexpected("the machine code of this target cannot be analysed");
  }
  const auto entry = image.function("gliderStep");
  if (!entry) {
    return std::unexpected("the executable has no `gliderStep`");
  }
  const Callees callees(image, mission);
  WorstPath path(image, {[&](const Frame& frame) { return turnsIn(frame, size); },
                         [&](const std::vector<Frame>& frames) { return callees.inTick(frames); },
                         neverCalled});
  return path.bound(*entry);
}

std::expected<uint64_t, std::string> stackBytes(const Image& image, const ir::Mission& mission,
                                                const platforms::Board& board) {
  if (image.code().empty()) {
    return std::unexpected("the machine code of this target cannot be analysed");
  }
  const Callees callees(image, mission);
  StackBound bound(
      image, stackMachine(board),
      {[&](uint64_t call, uint32_t excluded) { return callees.inProgram(call, excluded); },
       [&](uint64_t entry) { return callees.excludedBy(entry); }, callsAtOnce});
  const auto call = bound.bound(image.entry());
  return call ? std::expected<uint64_t, std::string>(call->bytes) : std::unexpected(call.error());
}

}  // namespace

Result<Budget> measureExecutable(const Input& input, const platforms::Board& board,
                                 const CodegenOptions& options) {
  auto program = compileProgram(input, board, options, ProgramKind::Executable, {"main"});
  if (!program) {
    return std::unexpected(program.error());
  }
  const auto linked = link(
      {ProgramKind::Executable, program->objects, program->further_inputs, {}, true, false}, board);
  if (!linked) {
    return std::unexpected(linked.error());
  }
  return measureLinked(*linked, input, board);
}

Result<Budget> measureLinked(const std::string& linked, const Input& input,
                             const platforms::Board& board) {
  const auto image = Image::read(linked, board);
  if (!image) {
    return std::unexpected(image.error());
  }
  Budget budget;
  budget.executable_bytes = splitDebug(linked, board.name + ".debug").stripped.size();
  budget.memory_bytes = image->loadedBytes();
  budget.data_bytes = image->writableBytes();
  budget.context_bytes = image->contextBytes();
  MissionSize size = sizeOf(input);
  size.data_bytes = budget.data_bytes;  // everything that is moved is in it
  budget.tick_instructions = tickInstructions(*image, input.mission, size);
  budget.stack_bytes = stackBytes(*image, input.mission, board);
  return budget;
}

}  // namespace glider::codegen
