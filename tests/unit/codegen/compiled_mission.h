// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/codegen.h"
#include "ir/core/mission.h"
#include "platforms/load/board.h"
#include "support/source_manager.h"

#include <filesystem>
#include <string>

namespace glider::codegen_tests {

/// A mission read from the IR's text form, checked, with the verifier's facts.
struct Checked {
  support::SourceManager sources;
  ir::Mission mission;
  ir::MissionFacts facts;
  platforms::Platform platform;  ///< the Slocum

  [[nodiscard]] codegen::Input input() const { return {mission, platform, facts.stack_depth}; }
};

/// The mission of `text`, which must be right; `name` is its file's.
Checked checkedMission(const std::string& text, const std::string& name = "mission.ir");
/// The paper's Figure 2, from the goldens.
Checked figure2();

/// A board as built into the shared data; it must be there.
platforms::Board board(const std::string& name);
/// The names of all boards.
inline constexpr const char* kBoards[] = {"host", "ts7800", "ts5500", "pizero2", "cm4"};

/// A folder for the running test's files, empty at its start.
std::filesystem::path testFolder();

}  // namespace glider::codegen_tests
