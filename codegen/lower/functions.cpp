// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/lowering.h"

namespace glider::codegen {

llvm::Function* makeFunction(Lowering& lowering, llvm::FunctionType* type,
                             const std::string& name) {
  auto* function =
      llvm::Function::Create(type, llvm::GlobalValue::InternalLinkage, name, lowering.module);
  function->setDoesNotThrow();
  function->setDSOLocal(true);
  llvm::BasicBlock::Create(lowering.module.getContext(), "entry", function);
  return function;
}

llvm::Value* loadField(llvm::IRBuilder<>& builder, llvm::StructType* type, llvm::Value* base,
                       unsigned index) {
  return builder.CreateLoad(type->getElementType(index),
                            builder.CreateStructGEP(type, base, index));
}

llvm::Function* makeDispatcher(Lowering& lowering, const std::string& name,
                               const std::vector<llvm::Function*>& by_state) {
  llvm::FunctionType* type = by_state.front()->getFunctionType();
  llvm::Function* function = makeFunction(lowering, type, name);
  llvm::IRBuilder<> builder(&function->getEntryBlock());
  auto* table_type = llvm::ArrayType::get(builder.getPtrTy(), by_state.size());
  auto* table = new llvm::GlobalVariable(
      lowering.module, table_type, true, llvm::GlobalValue::PrivateLinkage,
      llvm::ConstantArray::get(table_type,
                               std::vector<llvm::Constant*>(by_state.begin(), by_state.end())),
      name + ".table");
  llvm::Value* state = loadField(builder, lowering.types.GliderContext, function->getArg(0),
                                 field::GliderContext::state);
  llvm::Value* slot = builder.CreateInBoundsGEP(table_type, table, {builder.getInt32(0), state});
  std::vector<llvm::Value*> arguments;
  for (llvm::Argument& argument : function->args()) {
    arguments.push_back(&argument);
  }
  llvm::CallInst* call =
      builder.CreateCall(type, builder.CreateLoad(builder.getPtrTy(), slot), arguments);
  call->setTailCall();
  call->setDoesNotThrow();
  if (type->getReturnType()->isVoidTy()) {
    builder.CreateRetVoid();
  } else {
    builder.CreateRet(call);
  }
  return function;
}

}  // namespace glider::codegen
