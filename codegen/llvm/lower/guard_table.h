// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/lower/lowering.h"
#include "runtime/abi/glider_abi.h"

namespace glider::codegen {

/// The runtime's name for a sensor or clock.
GliderSource sourceOf(ir::Op op);

/// Evaluates the guards of a list of cases by its table: a call of gliderFirstTrue. The table
/// stores its state from place `memory` of GliderContext::intervals on.
llvm::Function* lowerGuardTable(Lowering& lowering, const ir::GuardTable& table,
                                const std::vector<ir::Case>& cases, const std::string& name,
                                support::SourceRange range, uint32_t memory);

}  // namespace glider::codegen
