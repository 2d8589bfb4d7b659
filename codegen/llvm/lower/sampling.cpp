// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/sampling.h"

#include "codegen/llvm/lower/body.h"

namespace glider::codegen {

void lowerSampling(Body& body, const ir::State& state) {
  llvm::IRBuilder<>& builder = body.builder;
  const auto number = [&](double value) {
    return llvm::ConstantFP::get(builder.getDoubleTy(), value);
  };
  llvm::Value* word = number(0);
  for (const ir::Sampling& one : state.sampling) {
    llvm::Value* code = body.expressions.number(one.code);
    word =
        builder.CreateFAdd(word, builder.CreateFMul(code, number(ir::samplingWeight(one.place))));
  }
  body.call("gliderSample", {body.context(), word});
}

}  // namespace glider::codegen
