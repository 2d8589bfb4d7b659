// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/validate/code.h"

#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Operator.h>

#include <map>
#include <optional>
#include <set>
#include <vector>

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
  using Locals = std::map<Address, z3::expr>;
  struct Way {
    z3::expr when;  ///< if none before it is taken
    const llvm::BasicBlock* to = nullptr;
  };
  /// The end of a block.
  struct End {
    Memory memory;
    Locals locals;
    std::vector<Way> ways;
  };

  // Flow.
  void enter(const llvm::BasicBlock& block, const llvm::BasicBlock& split);
  std::vector<Way> waysFrom(const llvm::BasicBlock& block);
  template <typename Value, typename Last, typename Either>
  std::optional<Value> meeting(size_t split, const llvm::BasicBlock* place, Last last,
                               Either either);
  Outcome together();
  Term phi(const llvm::PHINode& phi);

  // Instructions.
  void execute(const llvm::Instruction& instruction);
  Term meaning(const llvm::Instruction& instruction);
  z3::expr binary(const llvm::BinaryOperator& binary);
  z3::expr integer(const llvm::BinaryOperator& binary);
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

  Term term(const llvm::Value* value);
  z3::expr value(const llvm::Value* value);
  z3::expr constant(const llvm::Constant& constant);
  /// A pointer that is one address.
  Address address(const llvm::Value* pointer);
  /// A number that is one in every run; `what` is met otherwise.
  uint64_t numeral(const llvm::Value* value, const char* what);
  z3::expr anything(const z3::sort& sort);
  z3::sort sortOf(const llvm::Type& type);
  std::vector<z3::expr> arguments(const llvm::CallInst& call, unsigned first);

  Effects& effects() { return code_.effects_; }
  Numbers& numbers() { return code_.effects_.numbers(); }
  z3::context& z3() { return code_.effects_.z3(); }

  Code& code_;
  const llvm::Function& function_;
  llvm::DenseMap<const llvm::Value*, Term> terms_;
  std::vector<const llvm::BasicBlock*> order_;  ///< the blocks so far, by their numbers
  std::vector<End> ends_;                       ///< by the same numbers
  llvm::DenseMap<const llvm::BasicBlock*, size_t> places_;
  size_t split_ = 0;  ///< where the ways part that meet in the present block
  Memory memory_{{}, z3::expr(code_.effects_.z3())};
  std::set<Address> frames_;  ///< the function's own objects
  Locals locals_;             ///< the function's own memory
};

}  // namespace glider::codegen::validate
