// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Calls of C functions: each use of one is a generated function that keeps its result for the rest
// of the tick, so that code generation may evaluate expressions any number of times.

#include "codegen/llvm/lower/body.h"

namespace glider::codegen {
namespace {

using llvm::Value;

/// (context, arguments as numbers) -> number, internal and small.
llvm::Function* makeFunction(Lowering& lowering, const ir::Function& function) {
  llvm::LLVMContext& context = lowering.module.getContext();
  llvm::Type* number = llvm::Type::getDoubleTy(context);
  std::vector<llvm::Type*> types{llvm::PointerType::getUnqual(context)};
  types.resize(1 + function.parameters.size(), number);
  auto* made = llvm::Function::Create(llvm::FunctionType::get(number, types, false),
                                      llvm::GlobalValue::InternalLinkage, "use." + function.name,
                                      lowering.module);
  made->setDoesNotThrow();
  made->setDSOLocal(true);
  made->addFnAttr(llvm::Attribute::MinSize);
  made->addFnAttr(llvm::Attribute::NoInline);
  return made;
}

/// The result of the C function for `arguments`: settled, and unknown outside its range.
Value* callIt(Lowering& lowering, llvm::IRBuilder<>& builder, const ir::Function& function,
              llvm::ArrayRef<Value*> arguments) {
  llvm::Type* number = builder.getDoubleTy();
  const std::vector<llvm::Type*> types(arguments.size(), number);
  llvm::CallInst* given =
      builder.CreateCall(lowering.module.getOrInsertFunction(
                             function.symbol, llvm::FunctionType::get(number, types, false)),
                         arguments);
  given->setDoesNotThrow();
  llvm::CallInst* settled =
      builder.CreateCall(lowering.module.getOrInsertFunction(
                             "gliderSettle", llvm::FunctionType::get(number, {number}, false)),
                         {given});
  settled->setDoesNotThrow();
  Value* inside = builder.CreateAnd(
      builder.CreateFCmpOGE(settled, llvm::ConstantFP::get(number, function.lowest)),
      builder.CreateFCmpOLE(settled, llvm::ConstantFP::get(number, function.highest)));
  return builder.CreateSelect(inside, settled, llvm::ConstantFP::getNaN(number));
}

void fill(Lowering& lowering, llvm::Function& made, ir::UseId use) {
  const ir::Function& function = lowering.mission[use];
  llvm::LLVMContext& context = made.getContext();
  llvm::IRBuilder<> builder(llvm::BasicBlock::Create(context, "entry", &made));
  llvm::BasicBlock* first = llvm::BasicBlock::Create(context, "first", &made);
  llvm::BasicBlock* again = llvm::BasicBlock::Create(context, "again", &made);
  llvm::StructType* type = lowering.types.GliderCall;
  Value* calls =
      loadField(builder, lowering.types.GliderContext, made.getArg(0), field::GliderContext::calls);
  Value* slot = builder.CreateConstInBoundsGEP1_32(type, calls, use.index);
  Value* is_made = loadField(builder, type, slot, field::GliderCall::made);
  builder.CreateCondBr(builder.CreateICmpEQ(is_made, builder.getInt32(0)), first, again);
  builder.SetInsertPoint(first);
  std::vector<Value*> arguments;
  for (size_t i = 0; i < function.parameters.size(); ++i) {
    arguments.push_back(made.getArg(static_cast<unsigned>(1 + i)));
  }
  Value* given = callIt(lowering, builder, function, arguments);
  builder.CreateStore(given, builder.CreateStructGEP(type, slot, field::GliderCall::value));
  builder.CreateStore(builder.getInt32(1),
                      builder.CreateStructGEP(type, slot, field::GliderCall::made));
  builder.CreateBr(again);
  builder.SetInsertPoint(again);
  builder.CreateRet(loadField(builder, type, slot, field::GliderCall::value));
}

}  // namespace

llvm::Function* lowerUse(Lowering& lowering, ir::UseId use) {
  llvm::Function*& made = lowering.uses.at(use.index);
  if (made == nullptr) {
    made = makeFunction(lowering, lowering.mission[use]);
    fill(lowering, *made, use);
  }
  return made;
}

}  // namespace glider::codegen
