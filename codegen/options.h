// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/budget.h"
#include "codegen/validation.h"
#include "runtime/abi/port_mission.h"
#include "support/result.h"
#include "support/source_manager.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace glider::codegen {

/// How code is generated. A back end ignores options that do not apply to it.
struct CodegenOptions {
  /// 0 to 3. At 3 mission and runtime are optimised as one program; below, the mission is compiled
  /// alone and linked with the runtime's object, made from the same bitcode, in a twentieth of the
  /// time.
  int optimisation_level = 2;
  /// Line tables for `sources`, which holds the files of the mission's ranges; null: none.
  bool debug = true;
  const support::SourceManager* sources = nullptr;
  /// Objects and archives for the board that define the mission's extern behaviours.
  std::vector<std::filesystem::path> further_inputs;
  /// For a vehicle without the hooks: the program speaks the port for a backseat driver. None: it
  /// speaks to hookprog.
  std::optional<GliderPortMission> port;
  /// Whether a program that needs so much is written; empty: each is. Its failure is that of the
  /// build.
  std::function<support::Result<void>(const Budget&)> accepts = {};
  /// Gets how the code compares with the mission; its failure is that of the build. Empty: they
  /// are not compared. Not at level 3, where mission and runtime are one program.
  std::function<support::Result<void>(const Validation&)> validated = {};
  /// Nothing is linked in this process after this, which makes linking a little faster.
  bool last_link = false;
};

}  // namespace glider::codegen
