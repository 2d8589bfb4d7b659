// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <llvm/IR/DerivedTypes.h>
#include <llvm/IR/LLVMContext.h>

namespace glider::codegen {

/// The structs of runtime/abi/abi_structs.def as LLVM types, one member for each struct.
struct AbiTypes {
#define STRUCT(name) llvm::StructType* name = nullptr;
#define FIELD(type, name)
#define STRUCT_END(name)
#include "hooks/protocol/dictionary.def"
#include "runtime/abi/abi_structs.def"
#undef STRUCT
#undef FIELD
#undef STRUCT_END
};

/// The number of each field within its struct: field::GliderContext::state.
namespace field {
#define STRUCT(name) \
  namespace name {   \
  enum : unsigned {
#define FIELD(type, name) name,
#define STRUCT_END(name) \
  }                      \
  ;                      \
  }
#include "hooks/protocol/dictionary.def"
#include "runtime/abi/abi_structs.def"
#undef STRUCT
#undef FIELD
#undef STRUCT_END
}  // namespace field

AbiTypes makeAbiTypes(llvm::LLVMContext& context);

}  // namespace glider::codegen
