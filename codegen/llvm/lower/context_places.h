// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/input.h"
#include "codegen/llvm/lower/lowering.h"

#include <llvm/IR/DataLayout.h>

#include <cstdint>

namespace glider::codegen {

/// Where the arrays of a running mission are, in bytes from the start of its context, and the bytes
/// of it all: the rule of runtime/abi/context_layout.h.
struct ContextPlaces {
  uint64_t readings = 0;
  uint64_t frames = 0;
  uint64_t variables = 0;
  uint64_t temporals = 0;
  uint64_t bytes = 0;
};

/// On the machine that `layout` describes.
ContextPlaces contextPlaces(const Input& input, const MissionIndex& index,
                            const llvm::DataLayout& layout, const AbiTypes& types);
/// On the machine for which `lowering` generates code.
ContextPlaces contextPlaces(const Lowering& lowering);

}  // namespace glider::codegen
