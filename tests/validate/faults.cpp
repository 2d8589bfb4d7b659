// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/validate/faults.h"

#include <llvm/IR/Constants.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/Support/raw_ostream.h>

#include <functional>
#include <vector>

namespace glider::validate_test {
namespace {

using llvm::Instruction;

/// A fault that can be planted, and in which instruction.
struct Site {
  Instruction* where = nullptr;
  const char* what = "";
  std::function<void()> plant;
};

void addComparison(llvm::CmpInst& comparison, std::vector<Site>& sites) {
  const auto predicate = comparison.getPredicate();
  sites.push_back({&comparison, "the opposite comparison", [&comparison, predicate] {
                     comparison.setPredicate(llvm::CmpInst::getInversePredicate(predicate));
                   }});
  if (llvm::CmpInst::isStrictPredicate(predicate) ||
      llvm::CmpInst::isNonStrictPredicate(predicate)) {
    sites.push_back(
        {&comparison, "a comparison that differs where both are equal", [&comparison, predicate] {
           comparison.setPredicate(llvm::CmpInst::getFlippedStrictnessPredicate(predicate));
         }});
  }
}

/// Another number where there is a constant.
void addConstants(Instruction& instruction, std::vector<Site>& sites) {
  const auto* comparison = llvm::dyn_cast<llvm::FCmpInst>(&instruction);
  const bool of_known =
      comparison != nullptr && (comparison->getPredicate() == llvm::CmpInst::FCMP_ORD ||
                                comparison->getPredicate() == llvm::CmpInst::FCMP_UNO);
  if (llvm::isa<llvm::GetElementPtrInst>(instruction) ||
      llvm::isa<llvm::IntrinsicInst>(instruction) || llvm::isa<llvm::AllocaInst>(instruction) ||
      of_known) {
    return;
  }
  for (llvm::Use& operand : instruction.operands()) {
    if (const auto* number = llvm::dyn_cast<llvm::ConstantFP>(operand.get())) {
      const double value = number->getValueAPF().convertToDouble();
      llvm::Type* type = number->getType();
      sites.push_back({&instruction, "another number", [&operand, type, value] {
                         operand.set(llvm::ConstantFP::get(
                             type, value == value ? value + 1 + value / 64 : 0.0));
                       }});
    } else if (auto* whole = llvm::dyn_cast<llvm::ConstantInt>(operand.get())) {
      if (!llvm::isa<llvm::SwitchInst>(instruction)) {
        sites.push_back({&instruction, "another whole number", [&operand, whole] {
                           operand.set(
                               llvm::ConstantInt::get(whole->getType(), whole->getValue() + 1));
                         }});
      }
    }
  }
}

/// An access that is one place further on.
void addPlace(llvm::GetElementPtrInst& gep, std::vector<Site>& sites) {
  llvm::Use& last = gep.getOperandUse(gep.getNumOperands() - 1);
  auto* index = llvm::dyn_cast<llvm::ConstantInt>(last.get());
  if (index != nullptr && gep.getSourceElementType()->isDoubleTy()) {
    sites.push_back({&gep, "the place after it", [&last, index] {
                       last.set(llvm::ConstantInt::get(index->getType(), index->getValue() + 1));
                     }});
  }
}

/// A multiplication for a division by a constant: wrong in the last bit, unless that is a power
/// of 2.
void addReciprocal(llvm::BinaryOperator& division, std::vector<Site>& sites) {
  const auto* by = llvm::dyn_cast<llvm::ConstantFP>(division.getOperand(1));
  if (by == nullptr) {
    return;
  }
  const double reciprocal = 1 / by->getValueAPF().convertToDouble();
  sites.push_back({&division, "a product with the reciprocal", [&division, reciprocal] {
                     auto* made = llvm::BinaryOperator::Create(
                         Instruction::FMul, division.getOperand(0),
                         llvm::ConstantFP::get(division.getType(), reciprocal));
                     made->insertBefore(&division);
                     division.replaceAllUsesWith(made);
                     division.eraseFromParent();
                   }});
}

void addOperation(llvm::BinaryOperator& operation, std::vector<Site>& sites) {
  const auto become = [&](Instruction::BinaryOps other) {
    sites.push_back({&operation, "another operation", [&operation, other] {
                       auto* made = llvm::BinaryOperator::Create(other, operation.getOperand(0),
                                                                 operation.getOperand(1));
                       made->insertBefore(&operation);
                       operation.replaceAllUsesWith(made);
                       operation.eraseFromParent();
                     }});
  };
  switch (operation.getOpcode()) {
    case Instruction::And:
      return become(Instruction::Or);
    case Instruction::Or:
      return become(Instruction::And);
    case Instruction::FAdd:
      return become(Instruction::FSub);
    case Instruction::FSub:
      return become(Instruction::FAdd);
    case Instruction::FMul:
      return become(Instruction::FDiv);
    case Instruction::FDiv:
      addReciprocal(operation, sites);
      return become(Instruction::FMul);
    default:
      return;
  }
}

void addMissing(Instruction& instruction, std::vector<Site>& sites) {
  sites.push_back({&instruction, "nothing", [&instruction] { instruction.eraseFromParent(); }});
}

void addSites(Instruction& instruction, std::vector<Site>& sites) {
  if (auto* comparison = llvm::dyn_cast<llvm::CmpInst>(&instruction)) {
    addComparison(*comparison, sites);
  } else if (auto* select = llvm::dyn_cast<llvm::SelectInst>(&instruction)) {
    sites.push_back({select, "the other side", [select] { select->swapValues(); }});
  } else if (auto* branch = llvm::dyn_cast<llvm::BranchInst>(&instruction)) {
    if (branch->isConditional()) {
      sites.push_back({branch, "the other way", [branch] { branch->swapSuccessors(); }});
    }
  } else if (auto* operation = llvm::dyn_cast<llvm::BinaryOperator>(&instruction)) {
    addOperation(*operation, sites);
  } else if (auto* gep = llvm::dyn_cast<llvm::GetElementPtrInst>(&instruction)) {
    addPlace(*gep, sites);
  } else if (llvm::isa<llvm::StoreInst>(instruction) ||
             (llvm::isa<llvm::CallInst>(instruction) && instruction.getType()->isVoidTy() &&
              !llvm::isa<llvm::IntrinsicInst>(instruction))) {
    addMissing(instruction, sites);
  }
  addConstants(instruction, sites);
}

std::vector<Site> sitesIn(llvm::Module& module) {
  std::vector<Site> sites;
  for (llvm::Function& function : module) {
    if (!function.isDeclaration() && !function.hasAvailableExternallyLinkage()) {
      for (llvm::BasicBlock& block : function) {
        for (Instruction& instruction : block) {
          addSites(instruction, sites);
        }
      }
    }
  }
  return sites;
}

}  // namespace

size_t faultsIn(llvm::Module& module) {
  return sitesIn(module).size();
}

std::string plantFault(llvm::Module& module, size_t number) {
  const Site site = sitesIn(module).at(number);
  std::string words;
  llvm::raw_string_ostream stream(words);
  stream << site.where->getFunction()->getName() << ": " << site.what << " instead of";
  site.where->print(stream);
  site.plant();
  return words;
}

}  // namespace glider::validate_test
