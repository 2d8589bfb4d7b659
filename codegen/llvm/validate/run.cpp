// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The ways through a function.

#include "codegen/llvm/validate/run.h"

#include "codegen/llvm/validate/undecided.h"

#include <fmt/format.h>
#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/IR/CFG.h>
#include <llvm/IR/Dominators.h>

#include <ranges>

namespace glider::codegen::validate {

/// Blocks in an order in which each comes after all that lead to it.
Outcome Run::from(const std::vector<z3::expr>& arguments, const Memory& before) {
  for (unsigned i = 0; i < function_.arg_size(); ++i) {
    terms_.insert({function_.getArg(i), Term{arguments.at(i)}});
  }
  // Nothing is changed by these.
  const llvm::DominatorTree dominators(const_cast<llvm::Function&>(function_));
  memory_ = before;
  for (const llvm::BasicBlock* block :
       llvm::ReversePostOrderTraversal<const llvm::Function*>(&function_)) {
    if (block != &function_.getEntryBlock()) {
      enter(*block, *dominators.getNode(block)->getIDom()->getBlock());
    }
    places_.insert({block, order_.size()});
    order_.push_back(block);
    for (const llvm::Instruction& instruction : *block) {
      if (!instruction.isTerminator()) {
        execute(instruction);
      }
    }
    ends_.push_back({memory_, locals_, waysFrom(*block)});
  }
  return together();
}

/// What holds where ways meet that part at the block of number `split`: by their ways it is what
/// `last` says of the block that is the last before, or of one that has no next. Ways that do not
/// come there are not taken then. `either` chooses by a condition. Empty: none comes there.
template <typename Value, typename Last, typename Either>
std::optional<Value> Run::meeting(size_t split, const llvm::BasicBlock* place, Last last,
                                  Either either) {
  std::map<const llvm::BasicBlock*, Value> found;
  for (size_t i = ends_.size(); i-- > split;) {
    std::optional<Value> here;
    if (place == nullptr && ends_[i].ways.empty()) {
      here = last(i);
    }
    for (const Way& way : ends_[i].ways | std::views::reverse) {
      const auto next = found.find(way.to);
      const std::optional<Value> there = way.to == place       ? std::optional<Value>(last(i))
                                         : next != found.end() ? std::optional(next->second)
                                                               : std::nullopt;
      if (there) {
        here = here ? either(way.when, *there, *here) : *there;
      }
    }
    if (here) {
      found.emplace(order_[i], *here);
    }
  }
  const auto result = found.find(order_[split]);
  return result == found.end() ? std::nullopt : std::optional(result->second);
}

void Run::enter(const llvm::BasicBlock& block, const llvm::BasicBlock& split) {
  split_ = places_.lookup(&split);
  memory_ = *meeting<Memory>(
      split_, &block, [&](size_t i) { return ends_[i].memory; },
      [&](const z3::expr& when, const Memory& a, const Memory& b) {
        return effects().either(when, a, b);
      });
  locals_ = *meeting<Locals>(
      split_, &block, [&](size_t i) { return ends_[i].locals; },
      [&](const z3::expr& when, const Locals& a, const Locals& b) {
        // What only one way has stored may be anything on the other.
        const auto of = [&](const Locals& way, Address address, const z3::expr& other) {
          const auto found = way.find(address);
          return found == way.end() ? anything(other.get_sort()) : found->second;
        };
        Locals both = a;
        both.insert(b.begin(), b.end());
        for (auto& [address, value] : both) {
          const z3::expr first = of(a, address, value), second = of(b, address, value);
          value = z3::eq(first, second) ? first : z3::ite(when, first, second).simplify();
        }
        return both;
      });
}

Run::Term Run::phi(const llvm::PHINode& phi) {
  return *meeting<Term>(
      split_, phi.getParent(),
      [&](size_t i) { return term(phi.getIncomingValueForBlock(order_[i])); },
      [](const z3::expr& when, const Term& a, const Term& b) {
        if (a.table != b.table) {
          throw Undecided("a choice among tables");
        }
        return Term{z3::eq(a.value, b.value) ? a.value : z3::ite(when, a.value, b.value).simplify(),
                    a.table};
      });
}

/// What the function does by whichever way it ends.
Outcome Run::together() {
  const auto returns = [&](size_t i) {
    return llvm::isa<llvm::ReturnInst>(order_[i]->getTerminator());
  };
  const auto ends = meeting<z3::expr>(
      0, nullptr, [&](size_t i) { return effects().truth(returns(i)); },
      [](const z3::expr& when, const z3::expr& a, const z3::expr& b) {
        return z3::ite(when, a, b).simplify();
      });
  if (!ends || !ends->is_true()) {
    throw Undecided("a way that ends nowhere");
  }
  return *meeting<Outcome>(
      0, nullptr,
      [&](size_t i) {
        const llvm::Value* result =
            returns(i) ? llvm::cast<llvm::ReturnInst>(order_[i]->getTerminator())->getReturnValue()
                       : nullptr;
        return Outcome{result != nullptr ? value(result) : effects().word(0), ends_[i].memory};
      },
      [&](const z3::expr& when, const Outcome& a, const Outcome& b) {
        return effects().either(when, a, b);
      });
}

/// In the order of the conditions, each of which leaves out those before; the last is always true.
std::vector<Run::Way> Run::waysFrom(const llvm::BasicBlock& block) {
  const llvm::Instruction* end = block.getTerminator();
  std::vector<Way> ways;
  if (const auto* branch = llvm::dyn_cast<llvm::BranchInst>(end)) {
    if (branch->isConditional()) {
      ways.push_back({value(branch->getCondition()), branch->getSuccessor(0)});
    }
    ways.push_back({effects().truth(true), branch->getSuccessor(branch->getNumSuccessors() - 1)});
  } else if (const auto* choice = llvm::dyn_cast<llvm::SwitchInst>(end)) {
    const z3::expr chosen = value(choice->getCondition());
    for (const auto& one : choice->cases()) {
      ways.push_back({(chosen == value(one.getCaseValue())).simplify(), one.getCaseSuccessor()});
    }
    ways.push_back({effects().truth(true), choice->getDefaultDest()});
  } else if (!llvm::isa<llvm::ReturnInst>(end) && !llvm::isa<llvm::UnreachableInst>(end)) {
    throw Undecided(fmt::format("the instruction {}", end->getOpcodeName()));
  }
  for (const Way& way : ways) {
    if (places_.contains(way.to)) {
      throw Undecided("a loop");
    }
  }
  return ways;
}

}  // namespace glider::codegen::validate
