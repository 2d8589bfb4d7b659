// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/code.h"

#include "codegen/llvm/validate/run.h"
#include "codegen/llvm/validate/undecided.h"

#include <fmt/format.h>
#include <llvm/IR/Constants.h>

namespace glider::codegen::validate {
namespace {

constexpr uint32_t kDeepestCall = 8;

// NOLINTNEXTLINE(misc-no-recursion): as deep as constants nest
std::string contentOf(const llvm::Constant& constant) {
  if (const auto* number = llvm::dyn_cast<llvm::ConstantFP>(&constant)) {
    return fmt::format("{:x}", number->getValueAPF().bitcastToAPInt().getZExtValue());
  }
  if (const auto* whole = llvm::dyn_cast<llvm::ConstantInt>(&constant)) {
    return fmt::format("{}", whole->getZExtValue());
  }
  if (const auto* list = llvm::dyn_cast<llvm::ConstantDataSequential>(&constant)) {
    return "[" + list->getRawDataValues().str() + "]";
  }
  if (constant.getNumOperands() == 0) {
    throw Undecided("a constant that is not understood");
  }
  std::string content = "{";
  for (const llvm::Use& part : constant.operands()) {
    content += contentOf(*llvm::cast<llvm::Constant>(part.get())) + ",";
  }
  return content + "}";
}

}  // namespace

Address constantPlace(Places& places, const llvm::Constant& content) {
  const auto* bytes = llvm::dyn_cast<llvm::ConstantDataSequential>(&content);
  if (bytes != nullptr && bytes->isCString()) {
    return places.text(bytes->getAsCString().str());
  }
  return places.object("constant " + contentOf(content));
}

Outcome Code::run(const llvm::Function& function, const std::vector<z3::expr>& arguments,
                  const Memory& before) {
  if (depth_ == kDeepestCall) {
    throw Undecided("calls that are too deep");
  }
  ++depth_;
  Outcome outcome = Run(*this, function).from(arguments, before);
  --depth_;
  return outcome;
}

void Code::command(Memory& memory, const std::string& name,
                   const std::vector<z3::expr>& arguments) {
  const llvm::Function* body = inlinable_.getFunction(name);
  if (body != nullptr && !body->isDeclaration()) {
    memory = run(*body, arguments, memory).memory;
  } else {
    effects_.command(memory, name, arguments);
  }
}

}  // namespace glider::codegen::validate
