// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <llvm/IR/Module.h>

#include <string>

namespace glider::validate_test {

/// How many faults `plantFault` can plant in `module`.
size_t faultsIn(llvm::Module& module);

/// Plants fault `number`, below that, as a wrong lowering or a wrong pass would make it: another
/// comparison, another number, a store or call that is missing, sides of a choice or branch the
/// wrong way round, another operation. Returns it in words.
std::string plantFault(llvm::Module& module, size_t number);

}  // namespace glider::validate_test
