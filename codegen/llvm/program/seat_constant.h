// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <llvm/ADT/ArrayRef.h>
#include <llvm/IR/Module.h>

#include <cstdint>

namespace glider::codegen {

/// Adds a constant that the runtime's part for a vehicle without the hooks reads: numbers, words,
/// and the sensors with their sources, in this order and without padding.
void addSeatConstant(llvm::Module& module, const char* name, llvm::ArrayRef<double> numbers,
                     llvm::ArrayRef<uint32_t> words, llvm::ArrayRef<uint16_t> sensors,
                     llvm::ArrayRef<uint16_t> sources);

}  // namespace glider::codegen
