// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/llvm.h"

#include "codegen/backend.h"
#include "codegen/llvm/budget/measure.h"
#include "codegen/llvm/link/debug_file.h"
#include "codegen/llvm/link/lld.h"
#include "codegen/llvm/program/compile.h"
#include "codegen/llvm/program/emit.h"
#include "codegen/llvm/program/optimise.h"
#include "codegen/llvm/validate/image.h"
#include "codegen/talk_mission.h"
#include "support/diagnostics/ids/target.h"
#include "support/files.h"

namespace glider::codegen {
namespace {

using platforms::Board;
using support::Result;

/// The suffix of the file with an executable's symbols and line tables.
constexpr std::string_view kDebugSuffix = ".debug";

/// The mission alone, optimised.
Result<Unit> compileAlone(const Input& input, const Board& board, const CodegenOptions& options) {
  auto unit = lowerWhole(input, board, options, ProgramKind::Executable);
  if (unit) {
    optimise(*unit->module, *unit->machine, options.optimisation_level);
  }
  return unit;
}

Result<std::string> emitAlone(const Input& input, const Board& board, const CodegenOptions& options,
                              llvm::CodeGenFileType type) {
  auto unit = compileAlone(input, board, options);
  if (!unit) {
    return std::unexpected(unit.error());
  }
  return emitCode(*unit->module, *unit->machine, type);
}

Result<void> checkSize(size_t bytes, const Board& board) {
  if (board.max_executable_bytes != 0 && bytes > board.max_executable_bytes) {
    return support::fail(support::diagnostics::executableTooLarge, bytes,
                         board.max_executable_bytes, board.name);
  }
  return {};
}

/// The linked executable, with its symbols and line tables if `wanted`.
Result<std::string> linkWhole(const Input& input, const Board& board, const CodegenOptions& options,
                              bool wanted) {
  auto program = compileProgram(input, board, options, ProgramKind::Executable, {"main"});
  if (!program) {
    return std::unexpected(program.error());
  }
  const bool compared = static_cast<bool>(options.validated);
  auto linked = link({ProgramKind::Executable,
                      program->objects,
                      program->further_inputs,
                      {},
                      wanted || compared,
                      options.last_link},
                     board);
  if (!linked || !compared) {
    return linked;
  }
  program->validation.push_back(compareImage(program->objects, *linked));
  if (auto accepted = options.validated(program->validation); !accepted) {
    return std::unexpected(accepted.error());
  }
  return wanted ? linked : splitDebug(*linked, "").stripped;
}

/// Whether what was measured is accepted.
Result<void> accepted(const Result<Budget>& measured, const CodegenOptions& options) {
  return measured ? options.accepts(*measured) : std::unexpected(measured.error());
}

/// Writes both files or neither, as far as a file system allows: both are complete before the first
/// is renamed.
Result<void> writeBoth(const SplitExecutable& split, const std::filesystem::path& output,
                       const std::filesystem::path& debug_output) {
  auto executable =
      support::StagedFile::write(output, split.stripped, support::FileKind::ExecutableProduct);
  if (!executable) {
    return std::unexpected(executable.error());
  }
  auto debug = support::StagedFile::write(debug_output, split.debug, support::FileKind::Product);
  if (!debug) {
    return std::unexpected(debug.error());
  }
  auto published = executable->publish();
  return published ? debug->publish() : published;
}

/// The exports of a shared object.
std::vector<std::string> sharedSymbols(const ir::Mission& mission) {
  std::vector<std::string> names{
      "gliderMission",
#define ENTRY_POINT(result, name, parameters) #name,
#include "runtime/abi/entry_points.def"
#undef ENTRY_POINT
  };
  if (talks(mission)) {
    names.emplace_back("gliderTalk");
  }
  return names;
}

}  // namespace

Result<std::string> emitLlvm(const Input& input, const Board& board,
                             const CodegenOptions& options) {
  auto unit = compileAlone(input, board, options);
  if (!unit) {
    return std::unexpected(unit.error());
  }
  return printModule(*unit->module);
}

Result<std::string> emitAssembly(const Input& input, const Board& board,
                                 const CodegenOptions& options) {
  return emitAlone(input, board, options, llvm::CodeGenFileType::AssemblyFile);
}

Result<std::string> emitObject(const Input& input, const Board& board,
                               const CodegenOptions& options) {
  return emitAlone(input, board, options, llvm::CodeGenFileType::ObjectFile);
}

Result<std::string> makeExecutable(const Input& input, const Board& board,
                                   const CodegenOptions& options) {
  if (options.accepts) {
    CodegenOptions measured = options;
    measured.validated = {};
    const auto fits = accepted(measureExecutable(input, board, measured), options);
    if (!fits) {
      return std::unexpected(fits.error());
    }
  }
  auto linked = linkWhole(input, board, options, false);
  if (linked) {
    if (auto fits = checkSize(linked->size(), board); !fits) {
      return std::unexpected(fits.error());
    }
  }
  return linked;
}

Result<void> writeExecutable(const Input& input, const Board& board, const CodegenOptions& options,
                             const std::filesystem::path& output) {
  // A debug file is written only beside a regular file, not beside a device or pipe.
  if (!options.debug || !support::isReplaceable(output)) {
    const auto linked = makeExecutable(input, board, options);
    return linked
               ? support::writeFileAtomically(output, *linked, support::FileKind::ExecutableProduct)
               : std::unexpected(linked.error());
  }
  const auto linked = linkWhole(input, board, options, true);
  if (!linked) {
    return std::unexpected(linked.error());
  }
  if (options.accepts) {
    if (auto fits = accepted(measureLinked(*linked, input, board), options); !fits) {
      return fits;
    }
  }
  std::filesystem::path debug_output = output;
  debug_output += kDebugSuffix;
  const SplitExecutable split = splitDebug(*linked, debug_output.filename().string());
  const auto fits = checkSize(split.stripped.size(), board);
  return fits ? writeBoth(split, output, debug_output) : fits;
}

Result<std::string> makeShared(const Input& input, const Board& host,
                               const CodegenOptions& options) {
  const std::vector<std::string> symbols = sharedSymbols(input.mission);
  auto program = compileProgram(input, host, options, ProgramKind::SharedObject, symbols);
  if (!program) {
    return std::unexpected(program.error());
  }
  return link({ProgramKind::SharedObject, program->objects, program->further_inputs, symbols,
               options.debug, options.last_link},
              host);
}

namespace {

/// Any machine that a board names may be passed: LLVM knows which ones it supports.
bool hasMachine(const Board& board) {
  return !board.triple.empty();
}

constexpr Product kProducts[] = {
    {.name = "llvm", .suffix = ".ll", .for_board = true, .make = emitLlvm},
    {.name = "asm", .suffix = ".s", .for_board = true, .make = emitAssembly},
    {.name = "obj", .suffix = ".o", .for_board = true, .make = emitObject},
    {.name = "exe",
     .suffix = "",
     .for_board = true,
     .make = makeExecutable,
     .write = writeExecutable,
     .beside = kDebugSuffix},
};

}  // namespace

constinit const Backend llvmBackend{.serves = hasMachine,
                                    .products = kProducts,
                                    .link_executable = writeExecutable,
                                    .link_shared = makeShared,
                                    .measure = measureExecutable};

}  // namespace glider::codegen
