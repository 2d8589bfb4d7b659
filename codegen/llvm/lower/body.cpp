// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/body.h"

namespace glider::codegen {

llvm::Function* declareFunction(Lowering& lowering, const std::string& name, Body::Result result,
                                unsigned more, bool place) {
  llvm::LLVMContext& context = lowering.module.getContext();
  llvm::Type* word = llvm::Type::getInt32Ty(context);
  llvm::Type* results[] = {llvm::Type::getVoidTy(context), word};
  std::vector<llvm::Type*> parameters(1 + more, word);
  parameters[0] = llvm::PointerType::getUnqual(context);
  if (place) {
    parameters.push_back(parameters[0]);
  }
  auto* type = llvm::FunctionType::get(results[static_cast<size_t>(result)], parameters, false);
  auto* function =
      llvm::Function::Create(type, llvm::GlobalValue::ExternalLinkage, name, lowering.module);
  showToParts(*function);
  function->setDoesNotThrow();
  return function;
}

void showToParts(llvm::Function& function) {
  function.setLinkage(llvm::GlobalValue::ExternalLinkage);
  function.setVisibility(llvm::GlobalValue::HiddenVisibility);
  function.setDSOLocal(true);
}

namespace {

llvm::Function* makeFunction(Lowering& lowering, const std::string& name, Body::Result result,
                             unsigned more, bool place) {
  llvm::Function* function = declareFunction(lowering, name, result, more, place);
  function->setVisibility(llvm::GlobalValue::DefaultVisibility);
  function->setLinkage(llvm::GlobalValue::InternalLinkage);
  function->addFnAttr(llvm::Attribute::MinSize);
  llvm::BasicBlock::Create(lowering.module.getContext(), "entry", function);
  return function;
}

}  // namespace

Body::Body(Lowering& shared, const std::string& name, Result result, unsigned more,
           const std::string& title, support::SourceRange range, bool place)
    : lowering(shared),
      function(makeFunction(shared, name, result, more, place)),
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

void Body::call(llvm::StringRef symbol, llvm::ArrayRef<llvm::Value*> arguments) {
  std::vector<llvm::Type*> types;
  for (const llvm::Value* argument : arguments) {
    types.push_back(argument->getType());
  }
  auto* type = llvm::FunctionType::get(builder.getVoidTy(), types, false);
  builder.CreateCall(lowering.module.getOrInsertFunction(symbol, type), arguments)
      ->setDoesNotThrow();
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

}  // namespace glider::codegen
