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
  /// Reads objects, archives and LLVM bitcode, which it compiles to objects. GL9001 if a file
  /// cannot be read, GL4008 if it is none of these, GL4009 and GL4010 if it is not for the board,
  /// GL4011 if it was written for a declaration other than the mission's, GL4012 for bitcode that
  /// cannot be compiled.
  static support::Result<UserCode> load(const std::vector<std::filesystem::path>& files,
                                        const ir::Mission& mission, const platforms::Board& board);

  /// Adds what it holds to `options`; it must outlive the link. A whole-program optimiser does not
  /// see its calls of the runtime, so level 3 is not possible with it.
  void addTo(CodegenOptions& options) const;

 private:
  explicit UserCode(ScratchFolder folder) : folder_(std::move(folder)) {}

  ScratchFolder folder_;  ///< where its objects lie
  std::vector<std::filesystem::path> inputs_;
};

}  // namespace glider::codegen
