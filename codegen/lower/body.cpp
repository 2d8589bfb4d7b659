// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/body.h"

#include "runtime/abi/glider_abi.h"

namespace glider::codegen {
namespace {

llvm::Function* makeFunction(Lowering& lowering, const std::string& name, Body::Result result,
                             unsigned more) {
  llvm::LLVMContext& context = lowering.module.getContext();
  llvm::Type* word = llvm::Type::getInt32Ty(context);
  llvm::Type* results[] = {llvm::Type::getVoidTy(context), word, llvm::Type::getDoubleTy(context)};
  std::vector<llvm::Type*> parameters(1 + more, word);
  parameters[0] = llvm::PointerType::getUnqual(context);
  auto* type = llvm::FunctionType::get(results[static_cast<size_t>(result)], parameters, false);
  auto* function =
      llvm::Function::Create(type, llvm::GlobalValue::InternalLinkage, name, lowering.module);
  function->setDoesNotThrow();
  function->setDSOLocal(true);
  function->addFnAttr(llvm::Attribute::MinSize);
  llvm::BasicBlock::Create(context, "entry", function);
  return function;
}

}  // namespace

Body::Body(Lowering& shared, const std::string& name, Result result, unsigned more,
           const std::string& title, support::SourceRange range)
    : lowering(shared),
      function(makeFunction(shared, name, result, more)),
      builder(&function->getEntryBlock()),
      expressions(shared, builder, function->getArg(0)) {
  if (!title.empty()) {
    lowering.debug.describe(*function, title, range);
    lowering.debug.locate(builder, range);
  }
}

llvm::BasicBlock* Body::block(const char* name) {
  return llvm::BasicBlock::Create(builder.getContext(), name, function);
}

llvm::Value* Body::contextField(unsigned index) {
  return loadField(builder, lowering.types.GliderContext, context(), index);
}

llvm::Value* loadField(llvm::IRBuilder<>& builder, llvm::StructType* type, llvm::Value* base,
                       unsigned index) {
  return builder.CreateLoad(type->getElementType(index),
                            builder.CreateStructGEP(type, base, index));
}

llvm::Constant* text(Lowering& lowering, const std::string& text) {
  llvm::Constant*& found = lowering.texts[text];
  if (found == nullptr) {
    llvm::Constant* bytes = llvm::ConstantDataArray::getString(lowering.module.getContext(), text);
    auto* variable = new llvm::GlobalVariable(lowering.module, bytes->getType(), true,
                                              llvm::GlobalValue::PrivateLinkage, bytes, "text");
    variable->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
    variable->setAlignment(llvm::Align(1));
    found = variable;
  }
  return found;
}

std::vector<llvm::Function*> forEachState(
    Lowering& lowering, llvm::function_ref<bool(const ir::State&)> nothing,
    llvm::function_ref<llvm::Function*(uint32_t state)> lower) {
  std::vector<llvm::Function*> functions;
  llvm::Function* shared = nullptr;
  for (uint32_t i = 0; i < lowering.mission.states.size(); ++i) {
    if (!nothing(lowering.mission.states[i])) {
      functions.push_back(lower(i));
      continue;
    }
    shared = shared != nullptr ? shared : lower(i);
    functions.push_back(shared);
  }
  return functions;
}

void returnResult(Body& body, llvm::CallInst* call) {
  call->setTailCall();
  call->setDoesNotThrow();
  if (call->getType()->isVoidTy()) {
    body.builder.CreateRetVoid();
  } else {
    body.builder.CreateRet(call);
  }
}

llvm::CallInst* callFromTable(Body& body, const std::vector<llvm::Function*>& functions,
                              llvm::Value* number, const std::vector<llvm::Value*>& arguments) {
  auto* table_type = llvm::ArrayType::get(body.builder.getPtrTy(), functions.size());
  auto* table = new llvm::GlobalVariable(
      body.lowering.module, table_type, true, llvm::GlobalValue::PrivateLinkage,
      llvm::ConstantArray::get(table_type,
                               std::vector<llvm::Constant*>(functions.begin(), functions.end())),
      body.function->getName() + ".table");
  llvm::Value* slot =
      body.builder.CreateInBoundsGEP(table_type, table, {body.builder.getInt32(0), number});
  llvm::CallInst* call =
      body.builder.CreateCall(functions.front()->getFunctionType(),
                              body.builder.CreateLoad(body.builder.getPtrTy(), slot), arguments);
  call->setDoesNotThrow();
  return call;
}

llvm::CallInst* callOfState(Body& body, const std::vector<llvm::Function*>& functions,
                            const std::vector<llvm::Value*>& arguments) {
  return callFromTable(body, functions, body.contextField(field::GliderContext::state), arguments);
}

void callListOrState(Body& body, llvm::Function* always,
                     const std::vector<llvm::Function*>& functions) {
  llvm::BasicBlock* of_always = body.block("always");
  llvm::BasicBlock* of_state = body.block("state");
  const std::vector<llvm::Value*> arguments{body.context(), body.function->getArg(2)};
  llvm::Value* is_always =
      body.builder.CreateICmpEQ(body.function->getArg(1), body.builder.getInt32(kGliderListAlways));
  body.builder.CreateCondBr(is_always, of_always, of_state);
  body.builder.SetInsertPoint(of_always);
  returnResult(body, body.builder.CreateCall(always, arguments));
  body.builder.SetInsertPoint(of_state);
  returnResult(body, callOfState(body, functions, arguments));
}

}  // namespace glider::codegen
