// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/validate/code.h"

#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Operator.h>

#include <set>

namespace glider::codegen::validate {

/// One call of a function. Truth values (i1) are of the sort Bool, pointers addresses of 64 bits.
class Run {
 public:
  Run(Code& code, const llvm::Function& function) : code_(code), function_(function) {}
  Outcome from(const std::vector<z3::expr>& arguments, const Memory& before);

 private:
  struct Term {
    z3::expr value;                               ///< of a place in a table: the offset
    const llvm::GlobalVariable* table = nullptr;  ///< numbers that are chosen from by their place
  };
  /// How a block is reached, and the memory then.
  struct Edge {
    z3::expr when;
    Memory memory;
    std::map<Address, z3::expr> locals;
  };

  // Flow.
  void enter(const llvm::BasicBlock& block);
  void leave(const llvm::BasicBlock& block);
  void go(const llvm::BasicBlock& from, const llvm::BasicBlock& to, const z3::expr& when);
  Term phi(const llvm::PHINode& phi);

  // Instructions.
  void execute(const llvm::Instruction& instruction);
  Term meaning(const llvm::Instruction& instruction);
  z3::expr binary(const llvm::BinaryOperator& binary);
  z3::expr whole(const llvm::BinaryOperator& binary);
  z3::expr integerComparison(const llvm::ICmpInst& comparison);
  z3::expr cast(const llvm::CastInst& cast);
  z3::expr choice(const llvm::SelectInst& select);
  Term place(const llvm::GEPOperator& gep);
  z3::expr load(const llvm::LoadInst& load);
  void store(const llvm::StoreInst& store);
  z3::expr element(const llvm::GlobalVariable& table, const z3::expr& offset);

  // Calls.
  Term call(const llvm::CallInst& call);
  Term intrinsic(const llvm::IntrinsicInst& call);
  Term callBody(const llvm::CallInst& call, const llvm::Function& body);
  Term callContract(const llvm::CallInst& call);
  z3::expr callTable(const llvm::CallInst& call);
  void callNote(const llvm::CallInst& call);
  void fill(const llvm::MemSetInst& fill);
  z3::expr isOfClass(const z3::expr& x, uint64_t classes);

  Term term(const llvm::Value* value);
  z3::expr value(const llvm::Value* value);
  z3::expr constant(const llvm::Constant& constant);
  /// A pointer that is one address.
  Address address(const llvm::Value* pointer);
  uint64_t whole(const llvm::Value* value, const char* what);
  z3::expr anything(const llvm::Type& type);
  z3::sort sortOf(const llvm::Type& type);
  std::vector<z3::expr> arguments(const llvm::CallInst& call, unsigned first);

  Effects& effects() { return code_.effects_; }
  Numbers& numbers() { return code_.effects_.numbers(); }
  z3::context& z3() { return code_.effects_.z3(); }

  Code& code_;
  const llvm::Function& function_;
  llvm::DenseMap<const llvm::Value*, Term> terms_;
  std::map<const llvm::BasicBlock*, std::vector<std::pair<const llvm::BasicBlock*, Edge>>> edges_;
  z3::expr here_{code_.effects_.z3()};  ///< whether the block is reached
  Memory memory_{{}, z3::expr(code_.effects_.z3())};
  std::set<Address> frames_;            ///< the function's own objects
  std::map<Address, z3::expr> locals_;  ///< the function's own memory
};

}  // namespace glider::codegen::validate
