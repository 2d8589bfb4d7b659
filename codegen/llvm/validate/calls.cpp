// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What calls do: those of functions with a body what that does, all others what their contract
// says.

#include "codegen/llvm/validate/contracts.h"
#include "codegen/llvm/validate/run.h"
#include "codegen/llvm/validate/undecided.h"

#include <fmt/format.h>
#include <llvm/IR/Intrinsics.h>

namespace glider::codegen::validate {
std::vector<z3::expr> Run::arguments(const llvm::CallInst& call, unsigned first) {
  std::vector<z3::expr> all;
  for (unsigned i = first; i < call.arg_size(); ++i) {
    all.push_back(value(call.getArgOperand(i)));
  }
  return all;
}

Run::Term Run::call(const llvm::CallInst& call) {
  if (const auto* intrinsic = llvm::dyn_cast<llvm::IntrinsicInst>(&call)) {
    return this->intrinsic(*intrinsic);
  }
  const llvm::Function* callee = call.getCalledFunction();
  if (callee == nullptr) {
    throw Undecided("a call by a pointer");
  }
  if (std::string_view(callee->getName()) == kSettle) {
    return {numbers().settle(value(call.getArgOperand(0)))};
  }
  if (!callee->isDeclaration()) {
    return callBody(call, *callee);
  }
  const llvm::Function* body = code_.inlinable_.getFunction(callee->getName());
  return body != nullptr && !body->isDeclaration() ? callBody(call, *body) : callContract(call);
}

Run::Term Run::callBody(const llvm::CallInst& call, const llvm::Function& body) {
  Outcome outcome = code_.run(body, arguments(call, 0), memory_);
  memory_ = std::move(outcome.memory);
  return {outcome.result};
}

Run::Term Run::callContract(const llvm::CallInst& call) {
  const std::string name = call.getCalledFunction()->getName().str();
  const z3::expr nothing = effects().word(0);
  switch (contractOf(effects().places().mission(), name)) {
    case Contract::Note:
      callNote(call);
      return {nothing};
    case Contract::Window:
      effects().window(memory_, name, address(call.getArgOperand(0)), arguments(call, 1));
      return {nothing};
    case Contract::Pure:
      return {effects().pure(name, arguments(call, 0))};
    case Contract::Command:
      effects().command(memory_, name, arguments(call, 0));
      return {nothing};
    case Contract::Foreign:
      return {effects().foreign(memory_, name, arguments(call, 0))};
    case Contract::Table:
      return {callTable(call)};
    case Contract::None:
      break;
  }
  throw Undecided(fmt::format("a call of `{}`", name));
}

/// gliderNote takes its values from memory.
void Run::callNote(const llvm::CallInst& call) {
  enum : unsigned { Kind = 1, Text, Values, Count };
  std::vector<z3::expr> all{value(call.getArgOperand(Kind)), value(call.getArgOperand(Text))};
  const uint64_t count =
      numeral(call.getArgOperand(Count), "a note of a number of values that varies");
  if (count > 0) {
    const Address values = address(call.getArgOperand(Values));
    for (uint64_t i = 0; i < count; ++i) {
      const auto found = locals_.find(values + i * sizeof(double));
      if (found == locals_.end()) {
        throw Undecided("a note of values that were not stored");
      }
      all.push_back(found->second);
    }
  }
  effects().command(memory_, "gliderNote", all);
}

void Run::fill(const llvm::MemSetInst& fill) {
  const uint64_t bytes =
      numeral(fill.getLength(), "memory that is filled for a length that varies");
  if (numeral(fill.getValue(), "memory that is filled") != 0) {
    throw Undecided("memory that is filled with something else than 0");
  }
  for (const Address at : effects().places().fieldsIn(address(fill.getDest()), bytes)) {
    effects().store(memory_, at, z3().bv_val(0, effects().places().at(at).bytes * 8));
  }
}

Run::Term Run::intrinsic(const llvm::IntrinsicInst& call) {
  const auto argument = [&](unsigned i) { return value(call.getArgOperand(i)); };
  switch (call.getIntrinsicID()) {
    case llvm::Intrinsic::fabs:
      return {numbers().magnitude(argument(0))};
    case llvm::Intrinsic::sqrt:
      return {numbers().sqrt(argument(0))};
    case llvm::Intrinsic::is_fpclass:
      return {
          numbers().isOfClass(argument(0), numeral(call.getArgOperand(1), "a class of numbers"))};
    case llvm::Intrinsic::umin:
      return {z3::ite(z3::ult(argument(0), argument(1)), argument(0), argument(1)).simplify()};
    case llvm::Intrinsic::umax:
      return {z3::ite(z3::ugt(argument(0), argument(1)), argument(0), argument(1)).simplify()};
    case llvm::Intrinsic::memset:
      fill(llvm::cast<llvm::MemSetInst>(call));
      return {effects().word(0)};
    case llvm::Intrinsic::lifetime_start:
    case llvm::Intrinsic::lifetime_end:
    case llvm::Intrinsic::assume:
    case llvm::Intrinsic::dbg_value:
      return {effects().word(0)};
    default:
      throw Undecided(fmt::format("a call of `{}`", call.getCalledFunction()->getName().str()));
  }
}

}  // namespace glider::codegen::validate
