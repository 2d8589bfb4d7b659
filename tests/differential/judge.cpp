// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/differential/judge.h"

#include "codegen/llvm/link/lld.h"
#include "codegen/llvm/lower/lower_mission.h"
#include "codegen/llvm/program/emit.h"
#include "codegen/llvm/program/optimise.h"
#include "codegen/llvm/program/program.h"
#include "codegen/llvm/target/machine.h"
#include "codegen/scratch_folder.h"
#include "ir/opt/passes.h"
#include "platforms/load/board.h"
#include "platforms/load/load_platform.h"
#include "support/check.h"
#include "support/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <llvm/IR/Constants.h>
#include <llvm/Linker/Linker.h>
#include <llvm/Transforms/IPO/Internalize.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace glider::differential {
namespace {

namespace fs = std::filesystem;
using platforms::Board;

/// From this level on missions fly with tables of guards, which ir/eval does not know.
constexpr int kTableLevel = 2;

template <typename T>
T sure(support::Result<T> result) {
  CHECK(result.has_value(), result.error().message.c_str());
  if constexpr (!std::is_void_v<T>) {
    return std::move(*result);
  }
}

const platforms::Platform& slocum() {
  static const platforms::Platform platform =
      sure(platforms::loadPlatform(GLIDER_BINARY_DIR "/share/glidercc/platforms/slocum.toml"));
  return platform;
}

/// All missions in one module, with the table of them that judged_main.cpp expects.
std::unique_ptr<llvm::Module> joinMissions(std::span<const Trial> trials,
                                           const llvm::TargetMachine& machine, int level,
                                           llvm::LLVMContext& context) {
  auto all = std::make_unique<llvm::Module>("compared", context);
  all->setTargetTriple(machine.getTargetTriple().str());
  all->setDataLayout(machine.createDataLayout());
  std::vector<llvm::Constant*> table;
  for (const Trial& trial : trials) {
    ir::Mission mission = trial.mission;
    if (level >= kTableLevel) {
      ir::opt::tabulateGuards(mission);
    }
    auto module = codegen::lowerMission({mission, slocum(), trial.stack_depth},
                                        codegen::wholeOf(mission), machine, nullptr, context);
    const std::string name = fmt::format("mission{}", table.size());
    module->getNamedGlobal("gliderMission")->setName(name);
    module->getNamedGlobal("gliderContextMemory")->eraseFromParent();
    llvm::internalizeModule(*module, [&](const llvm::GlobalValue& value) {
      return value.getName() == name;  // the states of each mission are its own
    });
    CHECK(!llvm::Linker::linkModules(*all, std::move(module)), "missions that do not link");
    table.push_back(all->getNamedGlobal(name));
  }
  auto* type = llvm::ArrayType::get(llvm::PointerType::getUnqual(context), table.size());
  all->getOrInsertGlobal("judgedMissions", type);
  auto* missions = all->getNamedGlobal("judgedMissions");
  missions->setInitializer(llvm::ConstantArray::get(type, table));
  missions->setConstant(true);
  auto* word = llvm::Type::getInt32Ty(context);
  all->getOrInsertGlobal("judgedMissionCount", word);
  all->getNamedGlobal("judgedMissionCount")
      ->setInitializer(llvm::ConstantInt::get(word, table.size()));
  return all;
}

std::string buildProgram(std::span<const Trial> trials, const Board& board, int level) {
  llvm::LLVMContext context;
  auto machine = sure(codegen::makeMachine(board, level, codegen::ProgramKind::Executable));
  auto module = joinMissions(trials, *machine, level, context);
  const fs::path runtime =
      fs::path(GLIDER_BINARY_DIR) / "tests" / "differential_runtime" / (board.name + ".bc");
  sure(codegen::joinRuntime(*module, {runtime}, {"main"}));
  codegen::optimise(*module, *machine, level);
  const std::string object =
      codegen::emitCode(*module, *machine, llvm::CodeGenFileType::ObjectFile);
  return sure(codegen::link({codegen::ProgramKind::Executable, {object}, {}, {}, false}, board));
}

Words fly(std::span<const Trial> trials, const Board& board, const std::string& program) {
  Words streams;
  for (const Trial& trial : trials) {
    appendStream(trial, streams);
  }
  const auto scratch = sure(codegen::ScratchFolder::make());
  auto file = [&](const char* name) { return (scratch.path() / name).string(); };
  sure(
      support::writeFileAtomically(file("program"), program, support::FileKind::ExecutableProduct));
  sure(support::writeFileAtomically(file("streams"), {reinterpret_cast<const char*>(streams.data()),
                                                      streams.size() * sizeof(uint64_t)}));
  const std::string command = fmt::format("{} {} {} {}", fmt::join(board.emulator, " "),
                                          file("program"), file("streams"), file("records"));
  CHECK(std::system(command.c_str()) == 0, "the program under test failed");
  const std::string bytes = sure(support::readFile(file("records")));
  Words words(bytes.size() / sizeof(uint64_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(uint64_t));
  return words;
}

/// Compares what a mission did with what it should; takes its records off the front of `words`.
std::string compare(const Trial& trial, std::span<const uint64_t>& words) {
  const std::vector<Words> expected = expectedRecords(trial);
  for (size_t tick = 0; tick < expected.size(); ++tick) {
    const size_t count = words.empty() ? 0 : std::min<size_t>(words[0], words.size() - 1);
    const std::span<const uint64_t> record = words.subspan(words.empty() ? 0 : 1, count);
    words = words.subspan(words.empty() ? 0 : 1 + count);
    if (!std::ranges::equal(record, expected[tick])) {
      return fmt::format("{}, tick {}:\n  compiled  {:x}\n  ir/eval   {:x}", trial.name, tick,
                         fmt::join(record, " "), fmt::join(expected[tick], " "));
    }
  }
  return "";
}

}  // namespace

std::string judge(std::span<const Trial> trials, const std::string& board_name, int level) {
  const Board board = sure(platforms::loadBoard(
      fs::path(GLIDER_BINARY_DIR) / "share/glidercc/boards" / board_name / "board.toml"));
  const Words words = fly(trials, board, buildProgram(trials, board, level));
  std::span<const uint64_t> rest = words;
  for (const Trial& trial : trials) {
    if (std::string difference = compare(trial, rest); !difference.empty()) {
      return fmt::format("{} at -O{}: {}", board_name, level, difference);
    }
  }
  return "";
}

}  // namespace glider::differential
