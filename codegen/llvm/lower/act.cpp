// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/body.h"

#include <algorithm>

namespace glider::codegen {
namespace {

bool hasNothingToDo(const ir::Case& item) {
  return !item.action.valid() && item.arguments.empty();
}

/// All arguments are evaluated before the first is stored: a state that goes to itself may swap its
/// parameters.
void passArguments(Body& body, const ir::Case& item) {
  std::vector<llvm::Value*> values;
  for (const ir::ExprId argument : item.arguments) {
    values.push_back(body.expressions.asNumber(argument));
  }
  for (size_t i = 0; i < values.size(); ++i) {
    assign(body, body.lowering.mission[item.target].parameters[i], values[i]);
  }
}

}  // namespace

llvm::Function* lowerAct(Lowering& lowering, const std::vector<ir::Case>& cases,
                         const std::string& name, support::SourceRange range) {
  if (std::ranges::all_of(cases, hasNothingToDo)) {
    return nullptr;
  }
  Body body(lowering, "act." + name, Body::Result::None, 1, name + " acts", range);
  llvm::BasicBlock* nothing = body.block("nothing");
  llvm::SwitchInst* choice = body.builder.CreateSwitch(body.function->getArg(1), nothing);
  body.builder.SetInsertPoint(nothing);
  body.builder.CreateRetVoid();
  for (uint32_t i = 0; i < cases.size(); ++i) {
    if (hasNothingToDo(cases[i])) {
      continue;
    }
    llvm::BasicBlock* fired = body.block("fired");
    choice->addCase(body.builder.getInt32(i), fired);
    body.builder.SetInsertPoint(fired);
    body.expressions.forget();
    lowering.debug.locate(body.builder, cases[i].range);
    lowerBlock(body, cases[i].action);
    lowering.debug.locate(body.builder, cases[i].range);
    passArguments(body, cases[i]);
    body.builder.CreateRetVoid();
  }
  return body.function;
}

}  // namespace glider::codegen
