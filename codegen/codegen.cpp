// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/codegen.h"

#include "codegen/link/debug_file.h"
#include "codegen/link/lld.h"
#include "codegen/lower/context_size.h"
#include "codegen/lower/lower_mission.h"
#include "codegen/program/emit.h"
#include "codegen/program/optimise.h"
#include "codegen/program/program.h"
#include "codegen/target/machine.h"
#include "runtime/abi/glider_abi.h"
#include "support/files.h"

#include <llvm/IR/LLVMContext.h>

#include <memory>
#include <utility>

namespace glider::codegen {
namespace {

using platforms::Board;
using support::DiagnosticId;
using support::Result;

/// Half of what the smallest board, the TS-5500, has.
constexpr uint64_t kMostContextBytes = uint64_t{32} << 20U;

/// A module, and before it what it cannot live without.
struct Unit {
  std::unique_ptr<llvm::LLVMContext> context;
  std::unique_ptr<llvm::TargetMachine> machine;
  std::unique_ptr<llvm::Module> module;
};

Result<Unit> lower(const ir::Mission& mission, const ir::MissionFacts& facts, const Board& board,
                   const CodegenOptions& options, ProgramKind kind) {
  Unit unit{std::make_unique<llvm::LLVMContext>(), nullptr, nullptr};
  auto machine = makeMachine(board, options.optimisation_level, kind);
  if (!machine) {
    return std::unexpected(machine.error());
  }
  unit.machine = std::move(*machine);
  const MissionIndex index = indexMission(mission);
  if (index.parameter_count > GLIDER_MOST_PARAMETERS) {
    return support::fail(DiagnosticId::tooManyParameters, index.parameter_count,
                         GLIDER_MOST_PARAMETERS);
  }
  llvm::LLVMContext scratch;  // the module's own is to hold each type once
  const uint64_t bytes =
      contextBytes(mission, facts, index, unit.machine->createDataLayout(), makeAbiTypes(scratch));
  if (bytes > kMostContextBytes) {
    return support::fail(DiagnosticId::missionTooLarge, bytes, kMostContextBytes);
  }
  unit.module = lowerMission(mission, facts, *unit.machine,
                             options.debug ? options.sources : nullptr, *unit.context);
  return unit;
}

/// The mission alone, optimised.
Result<Unit> compile(const ir::Mission& mission, const ir::MissionFacts& facts, const Board& board,
                     const CodegenOptions& options) {
  auto unit = lower(mission, facts, board, options, ProgramKind::Executable);
  if (unit) {
    optimise(*unit->module, *unit->machine, options.optimisation_level);
  }
  return unit;
}

Result<std::string> compileAlone(const ir::Mission& mission, const ir::MissionFacts& facts,
                                 const Board& board, const CodegenOptions& options,
                                 llvm::CodeGenFileType type) {
  auto unit = compile(mission, facts, board, options);
  if (!unit) {
    return std::unexpected(unit.error());
  }
  return emitCode(*unit->module, *unit->machine, type);
}

/// From this level on the whole program, mission and runtime, is optimised and compiled as one.
/// From kImportLevel on the mission is optimised with the bodies of the runtime's tick, whose code
/// comes from the object that the build has made of the same bitcode: a tenth of the time.
constexpr int kWholeProgramLevel = 3;
constexpr int kImportLevel = 2;

/// What a program is linked from, besides the board's own inputs.
struct ProgramParts {
  std::string object;
  std::vector<std::filesystem::path> further_inputs;
};

/// Brings mission and runtime together as `level` says; `visible` is what the program exports.
Result<void> bringTogether(llvm::Module& module, const Board& board, int level,
                           const std::vector<std::string>& visible) {
  if (level >= kWholeProgramLevel) {
    return joinRuntime(module, {board.folder / "system.bc", board.folder / "tick.bc"}, visible);
  }
  return level >= kImportLevel ? importRuntime(module, board.folder / "inline.bc") : Result<void>{};
}

Result<ProgramParts> compileProgram(const ir::Mission& mission, const ir::MissionFacts& facts,
                                    const Board& board, const CodegenOptions& options,
                                    ProgramKind kind, const std::vector<std::string>& visible) {
  auto unit = lower(mission, facts, board, options, kind);
  if (!unit) {
    return std::unexpected(unit.error());
  }
  ProgramParts parts{"", options.further_inputs};
  const int level = options.optimisation_level;
  if (auto together = bringTogether(*unit->module, board, level, visible); !together) {
    return std::unexpected(together.error());
  }
  if (level < kWholeProgramLevel) {
    parts.further_inputs.push_back(board.folder / "runtime.o");
  }
  optimise(*unit->module, *unit->machine, options.optimisation_level);
  parts.object = emitCode(*unit->module, *unit->machine, llvm::CodeGenFileType::ObjectFile);
  return parts;
}

Result<void> checkSize(size_t bytes, const Board& board) {
  if (board.max_executable_bytes != 0 && bytes > board.max_executable_bytes) {
    return support::fail(DiagnosticId::executableTooLarge, bytes, board.max_executable_bytes,
                         board.name);
  }
  return {};
}

/// The linked executable, with its symbols and line tables if they are `wanted`.
Result<std::string> linkWhole(const ir::Mission& mission, const ir::MissionFacts& facts,
                              const Board& board, const CodegenOptions& options, bool wanted) {
  auto parts = compileProgram(mission, facts, board, options, ProgramKind::Executable, {"main"});
  if (!parts) {
    return std::unexpected(parts.error());
  }
  return link({ProgramKind::Executable,
               parts->object,
               parts->further_inputs,
               {},
               wanted,
               options.last_link},
              board);
}

/// Both files or neither, as far as a file system can promise that: both lie there whole before the
/// first is renamed.
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

/// What a shared object exports.
const std::vector<std::string>& sharedSymbols() {
  static const std::vector<std::string> names{
      "gliderMission",
#define ENTRY_POINT(result, name, parameters) #name,
#include "runtime/abi/entry_points.def"
#undef ENTRY_POINT
  };
  return names;
}

}  // namespace

Result<std::string> emitLlvm(const ir::Mission& mission, const ir::MissionFacts& facts,
                             const Board& board, const CodegenOptions& options) {
  auto unit = compile(mission, facts, board, options);
  if (!unit) {
    return std::unexpected(unit.error());
  }
  return printModule(*unit->module);
}

Result<std::string> emitAssembly(const ir::Mission& mission, const ir::MissionFacts& facts,
                                 const Board& board, const CodegenOptions& options) {
  return compileAlone(mission, facts, board, options, llvm::CodeGenFileType::AssemblyFile);
}

Result<std::string> emitObject(const ir::Mission& mission, const ir::MissionFacts& facts,
                               const Board& board, const CodegenOptions& options) {
  return compileAlone(mission, facts, board, options, llvm::CodeGenFileType::ObjectFile);
}

Result<std::string> linkForStream(const ir::Mission& mission, const ir::MissionFacts& facts,
                                  const Board& board, const CodegenOptions& options) {
  auto linked = linkWhole(mission, facts, board, options, false);
  if (linked) {
    if (auto fits = checkSize(linked->size(), board); !fits) {
      return std::unexpected(fits.error());
    }
  }
  return linked;
}

Result<void> linkExecutable(const ir::Mission& mission, const ir::MissionFacts& facts,
                            const Board& board, const CodegenOptions& options,
                            const std::filesystem::path& output) {
  // A debug file stands beside a file, not beside a device or pipe.
  if (!options.debug || !support::isReplaceable(output)) {
    const auto linked = linkForStream(mission, facts, board, options);
    return linked
               ? support::writeFileAtomically(output, *linked, support::FileKind::ExecutableProduct)
               : std::unexpected(linked.error());
  }
  const auto linked = linkWhole(mission, facts, board, options, true);
  if (!linked) {
    return std::unexpected(linked.error());
  }
  std::filesystem::path debug_output = output;
  debug_output += ".debug";
  const SplitExecutable split = splitDebug(*linked, debug_output.filename().string());
  const auto fits = checkSize(split.stripped.size(), board);
  return fits ? writeBoth(split, output, debug_output) : fits;
}

Result<std::string> linkShared(const ir::Mission& mission, const ir::MissionFacts& facts,
                               const Board& host, const CodegenOptions& options) {
  auto parts =
      compileProgram(mission, facts, host, options, ProgramKind::SharedObject, sharedSymbols());
  if (!parts) {
    return std::unexpected(parts.error());
  }
  return link({ProgramKind::SharedObject, parts->object, parts->further_inputs, sharedSymbols(),
               options.debug, options.last_link},
              host);
}

}  // namespace glider::codegen
