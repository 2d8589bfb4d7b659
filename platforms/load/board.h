// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glider::platforms {

enum class FloatAbi : uint8_t { Soft, Hard };
enum class Relocation : uint8_t { Static, PositionIndependent };

/// The kernel that a board runs; an empty release means this machine's.
struct Kernel {
  std::string release;
  std::string system_calls;  ///< file in the board's folder that lists the available system calls
};

/// The inputs of lld before and after the mission's objects: names of files in the board's folder.
struct LinkInputs {
  std::string dynamic_linker;        ///< absolute, of the target; empty for a static executable
  std::vector<std::string> options;  ///< of lld, beyond what every board needs
  std::vector<std::string> before;
  std::vector<std::string> after;
};

/// How a board sleeps.
struct BoardSleep {
  double asleep_W = 0;  ///< while it waits to be woken
  double wake_s = 0;    ///< from the call until its programs run
};

/// What a board draws.
struct BoardPower {
  double running_W = 0;             ///< while a mission runs on it
  double spread = 0;                ///< the share by which each may be wrong to either side
  std::string source;               ///< where the numbers are from
  std::optional<BoardSleep> sleep;  ///< empty: it cannot sleep, or nothing is known of it
};

/// A single-board computer as data: platforms/boards/<name>.toml.
struct Board {
  std::filesystem::path
      folder;  ///< the folder of the file, which also contains the link inputs and the runtime
  std::string name;
  std::string description;
  std::string triple;  ///< as LLVM names the machine
  std::string cpu;
  std::string features;
  FloatAbi float_abi = FloatAbi::Hard;
  Relocation relocation = Relocation::Static;
  std::vector<std::string> clang_flags;  ///< what makes clang compile for this processor
  uint64_t max_executable_bytes = 0;     ///< of the stripped executable; 0: no limit
  uint64_t max_memory_bytes = 0;         ///< of code, data and stack; 0: no limit
  uint64_t max_stack_bytes = 0;          ///< of the stack at its deepest; 0: no limit
  uint64_t max_tick_instructions = 0;  ///< from the readings of a frame to the command; 0: no limit
  std::optional<BoardPower> power;     ///< empty: not known
  Kernel kernel;
  std::vector<std::string>
      emulator;  ///< command that runs its executables here; empty: they run by themselves
  /// The same, waiting for a debugger on the TCP port in the place of "{port}".
  std::vector<std::string> debugger;
  LinkInputs link;
};

/// Reads and checks a board file. GL9001 if it cannot be read, GL5001 (with line) if it is invalid.
support::Result<Board> loadBoard(const std::filesystem::path& path);

}  // namespace glider::platforms
