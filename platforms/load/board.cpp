// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/board.h"

#include "hooks/protocol/nap_times.h"
#include "platforms/load/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::platforms {
namespace {

const toml::table kNoTable;

/// The sub-table `key`, or an empty one; a value that is not a table is refused.
const toml::table& subtable(TomlReader& reader, const toml::table& root, std::string_view key) {
  const toml::table* found = root[key].as_table();
  if (found == nullptr && root.contains(key)) {
    reader.refuse(key, "must be a table");
  }
  return found != nullptr ? *found : kNoTable;
}

/// Link inputs and lists are in the board's own folder; a path would lead out of it.
bool isFileName(const std::string& name) {
  return !name.empty() && name.front() != '-' && name.find('/') == std::string::npos &&
         name != "." && name != "..";
}

std::vector<std::string> fileNames(TomlReader& reader, std::string_view key) {
  std::vector<std::string> names = reader.texts(key);
  for (const std::string& name : names) {
    if (!isFileName(name)) {
      reader.refuse(key, "must hold names of files in the board's folder");
    }
  }
  return names;
}

uint64_t readLimit(TomlReader& reader, const char* key) {
  const int64_t limit = reader.integer(key);
  if (limit < 0) {
    reader.refuse(key, "must not be negative");
  }
  return static_cast<uint64_t>(limit);
}

void readMachine(TomlReader& reader, Board& board) {
  board.triple = reader.text("triple");
  board.cpu = reader.text("cpu");
  board.features = reader.text("features");
  const std::string float_abi = reader.text("float_abi");
  if (float_abi != "soft" && float_abi != "hard") {
    reader.refuse("float_abi", "must be \"soft\" or \"hard\"");
  }
  board.float_abi = float_abi == "soft" ? FloatAbi::Soft : FloatAbi::Hard;
  const std::string relocation = reader.text("relocation");
  if (relocation != "static" && relocation != "pic") {
    reader.refuse("relocation", "must be \"static\" or \"pic\"");
  }
  board.relocation = relocation == "pic" ? Relocation::PositionIndependent : Relocation::Static;
  board.clang_flags = reader.texts("clang_flags");
  (void)reader.texts("system_flags");  // these two for the build of glidercc alone
  (void)reader.texts("system_passes");
  board.max_executable_bytes = readLimit(reader, "max_executable_bytes");
  board.max_memory_bytes = readLimit(reader, "max_memory_bytes");
  board.max_stack_bytes = readLimit(reader, "max_stack_bytes");
  board.max_tick_instructions = readLimit(reader, "max_tick_instructions");
}

/// `asleep_W` and `wake_s`, of which a file has both or none.
std::optional<BoardSleep> readSleep(TomlReader& reader, const toml::table& power,
                                    double running_W) {
  if (!power.contains("asleep_W") && !power.contains("wake_s")) {
    return std::nullopt;
  }
  const BoardSleep sleep{reader.notNegative("asleep_W"), reader.notNegative("wake_s")};
  if (sleep.asleep_W > running_W) {
    reader.refuse("asleep_W", "must not be above running_W");
  }
  if (sleep.wake_s > int{kHookMostWakeSecs}) {
    reader.refuse("wake_s", fmt::format("must be at most {} s: proofs count on it",
                                        static_cast<int>(kHookMostWakeSecs)));
  }
  return sleep;
}

BoardPower readBoardPower(TomlReader& reader, const toml::table& power) {
  reader.only({"running_W", "spread", "source", "asleep_W", "wake_s"});
  const double running_W = reader.notNegative("running_W");
  return {running_W, reader.share("spread"), reader.text("source"),
          readSleep(reader, power, running_W)};
}

void readKernel(TomlReader& reader, Board& board) {
  reader.only({"release", "system_calls"});
  board.kernel.release = reader.text("release");
  board.kernel.system_calls = reader.text("system_calls");
  if (!isFileName(board.kernel.system_calls)) {
    reader.refuse("system_calls", "must be the name of a file in the board's folder");
  }
}

void readLink(TomlReader& reader, Board& board) {
  reader.only({"dynamic_linker", "options", "before", "after"});
  board.link.dynamic_linker = reader.text("dynamic_linker");
  board.link.options = reader.texts("options");
  if (std::ranges::any_of(board.link.options, [](const std::string& option) {
        return !option.starts_with("--") || option.find(',') != std::string::npos;
      })) {
    reader.refuse("options", "must hold long options of lld, without commas");
  }
  board.link.before = fileNames(reader, "before");
  board.link.after = fileNames(reader, "after");
}

}  // namespace

support::Result<Board> loadBoard(const std::filesystem::path& path) {
  auto root = parseToml(path);
  if (!root) {
    return std::unexpected(root.error());
  }
  const std::string file = path.string();
  Board board;
  board.folder = path.parent_path();
  TomlReader top(file, *root, "the board");
  top.only({"name", "description", "triple", "cpu", "features", "float_abi", "relocation",
            "clang_flags", "system_flags", "system_passes", "max_executable_bytes",
            "max_memory_bytes", "max_stack_bytes", "max_tick_instructions", "power", "kernel",
            "emulator", "link"});
  board.name = top.text("name");
  board.description = top.text("description");
  readMachine(top, board);
  TomlReader kernel(file, subtable(top, *root, "kernel"), "[kernel]");
  if (root->contains("kernel")) {
    readKernel(kernel, board);
  }
  const toml::table& power_table = subtable(top, *root, "power");
  TomlReader power(file, power_table, "[power]");
  if (root->contains("power")) {
    board.power = readBoardPower(power, power_table);
  }
  TomlReader emulator(file, subtable(top, *root, "emulator"), "[emulator]");
  emulator.only({"command", "debugger"});
  board.emulator = emulator.texts("command");
  board.debugger = emulator.texts("debugger");
  TomlReader link(file, subtable(top, *root, "link"), "[link]");
  readLink(link, board);
  for (const TomlReader* part : {&top, &kernel, &power, &emulator, &link}) {
    if (part->failure()) {
      return std::unexpected(*part->failure());
    }
  }
  return board;
}

}  // namespace glider::platforms
