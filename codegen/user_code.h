// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/options.h"
#include "codegen/scratch_folder.h"
#include "ir/core/mission.h"
#include "platforms/load/board.h"
#include "support/result.h"

#include <filesystem>
#include <vector>

namespace glider::codegen {

/// The C and C++ code of a mission, checked and ready to link.
class UserCode {
 public:
  /// Reads objects, archives and LLVM bitcode, of which it makes objects. GL9001 if one cannot be
  /// read, GL4008 if it is none of them, GL4009 and GL4010 if it is not for the board, GL4011 if it
  /// was written for another declaration than the mission's, GL4012 for bitcode that cannot be
  /// compiled.
  static support::Result<UserCode> load(const std::vector<std::filesystem::path>& files,
                                        const ir::Mission& mission, const platforms::Board& board);
  /// Stands in for what a mission has in C where the mission is not flown: every function gives
  /// nothing known.
  static support::Result<UserCode> standIn(const ir::Mission& mission,
                                           const platforms::Board& board);

  /// Gives `options` what it holds; it must outlive the link. Calls of the runtime from it are not
  /// seen by an optimiser of whole programs, so there is no level 3 with it.
  void addTo(CodegenOptions& options) const;

 private:
  explicit UserCode(ScratchFolder folder) : folder_(std::move(folder)) {}

  ScratchFolder folder_;  ///< where its objects lie
  std::vector<std::filesystem::path> inputs_;
};

}  // namespace glider::codegen
