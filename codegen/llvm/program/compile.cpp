// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/program/compile.h"

#include "codegen/llvm/lower/context_places.h"
#include "codegen/llvm/program/emit.h"
#include "codegen/llvm/program/imc_mission.h"
#include "codegen/llvm/program/optimise.h"
#include "codegen/llvm/program/parts.h"
#include "codegen/llvm/program/port_mission.h"
#include "codegen/llvm/program/program.h"
#include "codegen/llvm/program/recon_mission.h"
#include "codegen/llvm/program/talk_constant.h"
#include "codegen/llvm/validate/validate.h"
#include "codegen/seat_mission.h"
#include "codegen/talk_mission.h"
#include "ir/core/parameter_info.h"
#include "platforms/load/dictionary.h"
#include "runtime/abi/glider_abi.h"
#include "support/diagnostics/ids/target.h"

#include <algorithm>
#include <future>
#include <iterator>
#include <utility>

namespace glider::codegen {
namespace {

using platforms::Board;
using support::Result;

/// Half of the memory of the smallest board, the TS-5500.
constexpr uint64_t kMostContextBytes = uint64_t{32} << 20U;

/// From this level on the whole program, mission and runtime, is optimised and compiled as one.
/// From kImportLevel on the mission is optimised with the bodies of the runtime's shortest
/// functions; their code is in the object that the build has made from the same bitcode. This takes
/// a twentieth of the time.
constexpr int kWholeProgramLevel = 3;
constexpr int kImportLevel = 2;

/// The common settings for all parts of a program.
struct Recipe {
  const Input& input;
  const Board& board;
  const CodegenOptions& options;
  ProgramKind kind;
};

Result<void> checkLimits(const Recipe& recipe, const llvm::TargetMachine& machine) {
  if (auto roles = platforms::checkRoles(recipe.input.platform); !roles) {
    return roles;
  }
  const MissionIndex index = indexMission(recipe.input.mission);
  if (index.parameter_count > GLIDER_MOST_PARAMETERS) {
    return support::fail(support::diagnostics::tooManyParameters, index.parameter_count,
                         GLIDER_MOST_PARAMETERS);
  }
  llvm::LLVMContext scratch;  // the module's own must contain each type only once
  const uint64_t bytes =
      contextPlaces(recipe.input, index, machine.createDataLayout(), makeAbiTypes(scratch)).bytes;
  if (bytes > kMostContextBytes) {
    return support::fail(support::diagnostics::missionTooLarge, bytes, kMostContextBytes);
  }
  return {};
}

Result<Unit> lower(const Recipe& recipe, const MissionPart& part) {
  Unit unit{std::make_unique<llvm::LLVMContext>(), nullptr, nullptr};
  auto machine = makeMachine(recipe.board, recipe.options.optimisation_level, recipe.kind);
  if (!machine) {
    return std::unexpected(machine.error());
  }
  unit.machine = std::move(*machine);
  if (part.head) {
    if (auto fits = checkLimits(recipe, *unit.machine); !fits) {
      return std::unexpected(fits.error());
    }
  }
  unit.module =
      lowerMission(recipe.input, part, *unit.machine,
                   recipe.options.debug ? recipe.options.sources : nullptr, *unit.context);
  return unit;
}

/// The name of the part of the runtime that only missions with parameters need, the one for times
/// of the calendar too, or of what takes its place.
std::string parameterPart(const Recipe& recipe) {
  const auto infos = ir::parameterInfos(recipe.input.mission);
  const bool dated = std::ranges::any_of(infos, &ir::ParameterInfo::date);
  return infos.empty() ? "no_parameters" : dated ? "dated_parameters" : "parameters";
}

/// Whether a note has values, which are then written as text: of the mission, or perhaps of a
/// profile or route in C.
bool logsValues(const ir::Mission& mission) {
  const auto logs = [](const ir::Statement& statement) {
    return statement.kind == ir::StatementKind::Log && !statement.values.empty();
  };
  const auto hasLog = [&](const ir::Block& block) {
    return std::ranges::any_of(block.statements, logs);
  };
  const auto isInC = [](const ir::Behaviour& behaviour) { return !behaviour.symbol.empty(); };
  return std::ranges::any_of(mission.blocks, hasLog) ||
         std::ranges::any_of(mission.behaviours, isInC);
}

/// The parts of the runtime beside the main program that depend on what the mission uses.
std::vector<std::string> optionalParts(const Recipe& recipe) {
  const ir::Mission& mission = recipe.input.mission;
  return {parameterPart(recipe), mission.nap_s ? "naps" : "no_naps",
          logsValues(mission) ? "note_values" : "no_note_values"};
}

/// The part of the runtime that speaks to the vehicle.
std::string dialectPart(const Recipe& recipe) {
  return recipe.options.port                  ? "extctl"
         : speaksImc(recipe.input.platform)   ? "imc"
         : speaksRecon(recipe.input.platform) ? "recon"
                                              : "hooks";
}

/// The same with the main program, which serves a modem if the mission shares something.
std::string mainPart(const Recipe& recipe) {
  return dialectPart(recipe) + (talks(recipe.input.mission) ? "_talk" : "");
}

/// What that part must know.
Result<void> addDialect(llvm::Module& module, const Recipe& recipe) {
  if (talks(recipe.input.mission)) {
    addTalkConstant(module, talkMissionOf(recipe.input.mission, recipe.input.platform));
  }
  const std::string part = dialectPart(recipe);
  if (part == "extctl") {
    addPortMission(module, *recipe.options.port);
  } else if (part == "imc") {
    const auto imc = imcMissionOf(recipe.input.platform);
    if (!imc) {
      return std::unexpected(imc.error());
    }
    addImcMission(module, *imc);
  } else if (part == "recon") {
    const auto recon = reconMissionOf(recipe.input.platform);
    if (!recon) {
      return std::unexpected(recon.error());
    }
    addReconMission(module, *recon);
  }
  return {};
}

/// The optional parts as files that end so.
std::vector<std::filesystem::path> filesOf(const Recipe& recipe, const std::string& extension) {
  std::vector<std::filesystem::path> files;
  for (const std::string& part : optionalParts(recipe)) {
    files.push_back(recipe.board.folder / (part + extension));
  }
  return files;
}

Result<void> bringTogether(llvm::Module& module, const Recipe& recipe,
                           const std::vector<std::string>& visible) {
  const std::filesystem::path& folder = recipe.board.folder;
  if (recipe.options.optimisation_level >= kWholeProgramLevel) {
    return joinRuntime(
        module, {folder / (mainPart(recipe) + ".bc"), folder / "system.bc", folder / "tick.bc"},
        visible, filesOf(recipe, ".bc"));
  }
  return recipe.options.optimisation_level >= kImportLevel
             ? importRuntime(module, folder / "inline.bc")
             : Result<void>{};
}

/// A part as it is linked, and how it compares with the mission.
struct Compiled {
  std::string object;
  Validation validation;
};

Result<Compiled> compilePart(const Recipe& recipe, const MissionPart& part,
                             const std::vector<std::string>& visible) {
  auto unit = lower(recipe, part);
  if (!unit) {
    return std::unexpected(unit.error());
  }
  if (part.head) {
    if (auto added = addDialect(*unit->module, recipe); !added) {
      return std::unexpected(added.error());
    }
  }
  if (auto together = bringTogether(*unit->module, recipe, visible); !together) {
    return std::unexpected(together.error());
  }
  optimise(*unit->module, *unit->machine, recipe.options.optimisation_level);
  Result<Validation> validation =
      recipe.options.validated
          ? validatePart(recipe.input, part, *unit->module, recipe.board.folder / "inline.bc")
          : Validation();
  if (!validation) {
    return std::unexpected(validation.error());
  }
  return Compiled{emitCode(*unit->module, *unit->machine, llvm::CodeGenFileType::ObjectFile),
                  std::move(*validation)};
}

}  // namespace

Result<Unit> lowerWhole(const Input& input, const Board& board, const CodegenOptions& options,
                        ProgramKind kind) {
  return lower({input, board, options, kind}, wholeOf(input.mission));
}

Result<Program> compileProgram(const Input& input, const Board& board,
                               const CodegenOptions& options, ProgramKind kind,
                               const std::vector<std::string>& visible) {
  const Recipe recipe{input, board, options, kind};
  const bool whole = options.optimisation_level >= kWholeProgramLevel;
  const auto parts = whole ? std::vector{wholeOf(input.mission)} : partsOf(input.mission);
  std::vector<std::future<Result<Compiled>>> others;
  for (size_t i = 1; i < parts.size(); ++i) {
    others.push_back(
        std::async(std::launch::async, [&, i] { return compilePart(recipe, parts[i], visible); }));
  }
  std::vector<Result<Compiled>> compiled;
  compiled.push_back(compilePart(recipe, parts.front(), visible));
  for (auto& other : others) {
    compiled.push_back(other.get());
  }
  Program program{{}, options.further_inputs, {}};
  for (Result<Compiled>& one : compiled) {
    if (!one) {
      return std::unexpected(one.error());
    }
    program.objects.push_back(std::move(one->object));
    std::ranges::move(one->validation, std::back_inserter(program.validation));
  }
  if (!whole) {
    program.further_inputs.push_back(board.folder / "runtime.o");
    std::ranges::copy(filesOf(recipe, ".o"), std::back_inserter(program.further_inputs));
    program.further_inputs.push_back(board.folder / (mainPart(recipe) + ".o"));
  }
  return program;
}

}  // namespace glider::codegen
