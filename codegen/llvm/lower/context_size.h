// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/input.h"
#include "codegen/llvm/lower/abi_types.h"
#include "codegen/llvm/lower/mission_index.h"

#include <llvm/IR/DataLayout.h>

#include <cstdint>

namespace glider::codegen {

/// Bytes of a running mission's context with its arrays: the rule of runtime/abi/context_layout.h
/// for the machine that `layout` describes.
uint64_t contextBytes(const Input& input, const MissionIndex& index, const llvm::DataLayout& layout,
                      const AbiTypes& types);

}  // namespace glider::codegen
