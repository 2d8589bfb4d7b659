// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/talk_mission.h"

#include <llvm/IR/Module.h>

namespace glider::codegen {

/// Adds `talk` to a module as the constant `gliderTalk`, which the runtime's part for a modem
/// reads.
void addTalkConstant(llvm::Module& module, const GliderTalk& talk);

}  // namespace glider::codegen
