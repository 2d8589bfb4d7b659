// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/code.h"

#include "codegen/llvm/validate/run.h"
#include "codegen/llvm/validate/undecided.h"

#include <fmt/format.h>
#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/IR/CFG.h>
#include <llvm/IR/Constants.h>

#include <set>

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
  std::string content = "{";
  if (constant.isNullValue() && constant.getNumOperands() == 0) {
    return "zero";
  }
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
  const llvm::Function* body = short_ones_.getFunction(name);
  if (body != nullptr && !body->isDeclaration()) {
    memory = run(*body, arguments, memory).memory;
  } else {
    effects_.command(memory, name, arguments);
  }
}

/// Blocks in an order in which each comes after all that lead to it.
Outcome Run::from(const std::vector<z3::expr>& arguments, const Memory& before) {
  for (unsigned i = 0; i < function_.arg_size(); ++i) {
    terms_.insert({function_.getArg(i), Term{arguments.at(i)}});
  }
  WaysOut ways(effects());
  std::set<const llvm::BasicBlock*> done;
  const llvm::ReversePostOrderTraversal<const llvm::Function*> order(&function_);
  here_ = effects().truth(true);
  memory_ = before;
  for (const llvm::BasicBlock* block : order) {
    done.insert(block);
    if (block != &function_.getEntryBlock()) {
      enter(*block);
    }
    for (const llvm::Instruction& instruction : *block) {
      if (!instruction.isTerminator()) {
        execute(instruction);
      }
    }
    for (const llvm::BasicBlock* next : llvm::successors(block)) {
      if (done.contains(next)) {
        throw Undecided("a loop");
      }
    }
    const auto* end = llvm::dyn_cast<llvm::ReturnInst>(block->getTerminator());
    if (end == nullptr) {
      leave(*block);
      continue;
    }
    const llvm::Value* result = end->getReturnValue();
    ways.add(here_, result != nullptr ? value(result) : effects().word(0), memory_);
  }
  return ways.together();
}

void Run::enter(const llvm::BasicBlock& block) {
  const auto& edges = edges_[&block];
  here_ = effects().truth(false);
  if (edges.empty()) {
    return;  // only an unreachable block leads here
  }
  memory_ = edges.back().second.memory;
  locals_ = edges.back().second.locals;
  for (const auto& [from, edge] : edges) {
    here_ = (here_ || edge.when).simplify();
  }
  for (auto edge = edges.rbegin() + 1; edge != edges.rend(); ++edge) {
    const Edge& other = edge->second;
    memory_ = effects().either(other.when, other.memory, memory_);
    for (auto& [address, value] : locals_) {
      if (const auto found = other.locals.find(address); found != other.locals.end()) {
        value = z3::ite(other.when, found->second, value).simplify();
      }
    }
    locals_.insert(other.locals.begin(), other.locals.end());
  }
}

void Run::go(const llvm::BasicBlock& from, const llvm::BasicBlock& to, const z3::expr& when) {
  auto& edges = edges_[&to];
  for (auto& [other, edge] : edges) {
    if (other == &from) {  // several values of a switch
      edge.when = (edge.when || when).simplify();
      return;
    }
  }
  edges.emplace_back(&from, Edge{when, memory_, locals_});
}

void Run::leave(const llvm::BasicBlock& block) {
  const llvm::Instruction* end = block.getTerminator();
  if (const auto* branch = llvm::dyn_cast<llvm::BranchInst>(end)) {
    if (branch->isUnconditional()) {
      return go(block, *branch->getSuccessor(0), here_);
    }
    const z3::expr condition = value(branch->getCondition());
    go(block, *branch->getSuccessor(0), (here_ && condition).simplify());
    return go(block, *branch->getSuccessor(1), (here_ && !condition).simplify());
  }
  if (const auto* choice = llvm::dyn_cast<llvm::SwitchInst>(end)) {
    const z3::expr chosen = value(choice->getCondition());
    z3::expr none = here_;
    for (const auto& one : choice->cases()) {
      const z3::expr is_this = chosen == value(one.getCaseValue());
      go(block, *one.getCaseSuccessor(), (here_ && is_this).simplify());
      none = none && !is_this;
    }
    return go(block, *choice->getDefaultDest(), none.simplify());
  }
  if (llvm::isa<llvm::UnreachableInst>(end)) {
    if (!here_.is_false()) {
      throw Undecided("a way that ends nowhere");
    }
  } else {
    throw Undecided(fmt::format("the instruction {}", end->getOpcodeName()));
  }
}

Run::Term Run::phi(const llvm::PHINode& phi) {
  const auto& edges = edges_[phi.getParent()];
  if (edges.empty()) {
    return {anything(*phi.getType())};
  }
  Term result = term(phi.getIncomingValueForBlock(edges.back().first));
  for (auto edge = edges.rbegin() + 1; edge != edges.rend(); ++edge) {
    const Term other = term(phi.getIncomingValueForBlock(edge->first));
    if (other.table != result.table) {
      throw Undecided("a choice among tables");
    }
    result.value = z3::ite(edge->second.when, other.value, result.value).simplify();
  }
  return result;
}

}  // namespace glider::codegen::validate
