// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the instructions of a block do, except calls.

#include "codegen/llvm/validate/run.h"
#include "codegen/llvm/validate/undecided.h"

#include <fmt/format.h>
#include <llvm/IR/Constants.h>

namespace glider::codegen::validate {
namespace {

[[noreturn]] void notKnown(const llvm::Instruction& instruction) {
  throw Undecided(fmt::format("the instruction {}", instruction.getOpcodeName()));
}

/// Whether it holds the numbers of a table of the mission.
bool isTable(const llvm::GlobalVariable& variable) {
  const auto* type = llvm::dyn_cast<llvm::ArrayType>(variable.getValueType());
  return variable.isConstant() && variable.hasDefinitiveInitializer() && type != nullptr &&
         type->getElementType()->isDoubleTy();
}

z3::expr asBit(const z3::expr& truth, unsigned bits) {
  z3::context& z3 = truth.ctx();
  return z3::ite(truth, z3.bv_val(1, bits), z3.bv_val(0, bits));
}

}  // namespace

z3::sort Run::sortOf(const llvm::Type& type) {
  if (type.isIntegerTy(1)) {
    return z3().bool_sort();
  }
  if (type.isIntegerTy()) {
    return z3().bv_sort(type.getIntegerBitWidth());
  }
  if (type.isDoubleTy() || type.isPointerTy()) {
    return z3().bv_sort(kNumberBits);
  }
  throw Undecided("a value that is neither a number nor a pointer");
}

z3::expr Run::anything(const z3::sort& sort) {
  return z3().constant(fmt::format("anything {}", code_.unknowns_++).c_str(), sort);
}

z3::expr Run::constant(const llvm::Constant& constant) {
  if (const auto* number = llvm::dyn_cast<llvm::ConstantFP>(&constant)) {
    return numbers().constant(number->getValueAPF().convertToDouble());
  }
  if (const auto* whole = llvm::dyn_cast<llvm::ConstantInt>(&constant)) {
    return whole->getType()->isIntegerTy(1)
               ? effects().truth(whole->isOne())
               : z3().bv_val(whole->getZExtValue(), whole->getBitWidth());
  }
  if (llvm::isa<llvm::ConstantPointerNull>(constant)) {
    return effects().address(0);
  }
  if (llvm::isa<llvm::UndefValue>(constant)) {
    return anything(sortOf(*constant.getType()));
  }
  const auto* global = llvm::dyn_cast<llvm::GlobalVariable>(&constant);
  if (global != nullptr && global->isConstant() && global->hasDefinitiveInitializer()) {
    return effects().address(constantPlace(effects().places(), *global->getInitializer()));
  }
  throw Undecided("a constant that is not understood");
}

Run::Term Run::term(const llvm::Value* value) {
  if (const auto found = terms_.find(value); found != terms_.end()) {
    return found->second;
  }
  if (const auto* gep = llvm::dyn_cast<llvm::GEPOperator>(value)) {
    return place(*gep);
  }
  const auto* table = llvm::dyn_cast<llvm::GlobalVariable>(value);
  if (table != nullptr && isTable(*table)) {
    return {z3().bv_val(0, kNumberBits), table};
  }
  const auto* fixed = llvm::dyn_cast<llvm::Constant>(value);
  if (fixed == nullptr) {
    throw Undecided("a value that is used before it is made");
  }
  return {constant(*fixed)};
}

z3::expr Run::value(const llvm::Value* value) {
  const Term found = term(value);
  if (found.table != nullptr) {
    throw Undecided("a place in a table that is used as a number");
  }
  return found.value;
}

uint64_t Run::numeral(const llvm::Value* value, const char* what) {
  const z3::expr found = this->value(value);
  if (!found.is_numeral()) {
    throw Undecided(what);
  }
  return found.get_numeral_uint64();
}

Address Run::address(const llvm::Value* pointer) {
  return numeral(pointer, "an access by a pointer that is computed");
}

void Run::execute(const llvm::Instruction& instruction) {
  if (const auto* store = llvm::dyn_cast<llvm::StoreInst>(&instruction)) {
    return this->store(*store);
  }
  if (instruction.getType()->isVoidTy()) {
    const auto* call = llvm::dyn_cast<llvm::CallInst>(&instruction);
    if (call == nullptr) {
      notKnown(instruction);
    }
    this->call(*call);
    return;
  }
  if (llvm::isa<llvm::FPMathOperator>(instruction) && instruction.getFastMathFlags().any()) {
    throw Undecided("an operation that may round as it likes");
  }
  terms_.insert({&instruction, meaning(instruction)});
}

Run::Term Run::meaning(const llvm::Instruction& instruction) {
  if (const auto* phi = llvm::dyn_cast<llvm::PHINode>(&instruction)) {
    return this->phi(*phi);
  }
  if (const auto* call = llvm::dyn_cast<llvm::CallInst>(&instruction)) {
    return this->call(*call);
  }
  if (const auto* gep = llvm::dyn_cast<llvm::GEPOperator>(&instruction)) {
    return place(*gep);
  }
  if (const auto* load = llvm::dyn_cast<llvm::LoadInst>(&instruction)) {
    return {this->load(*load)};
  }
  if (const auto* binary = llvm::dyn_cast<llvm::BinaryOperator>(&instruction)) {
    return {this->binary(*binary)};
  }
  if (const auto* comparison = llvm::dyn_cast<llvm::ICmpInst>(&instruction)) {
    return {integerComparison(*comparison)};
  }
  if (const auto* comparison = llvm::dyn_cast<llvm::FCmpInst>(&instruction)) {
    return {numbers().compare(comparison->getPredicate(), value(comparison->getOperand(0)),
                              value(comparison->getOperand(1)))};
  }
  if (const auto* select = llvm::dyn_cast<llvm::SelectInst>(&instruction)) {
    return {choice(*select)};
  }
  if (const auto* cast = llvm::dyn_cast<llvm::CastInst>(&instruction)) {
    return {this->cast(*cast)};
  }
  switch (instruction.getOpcode()) {
    case llvm::Instruction::FNeg:
      return {numbers().negate(value(instruction.getOperand(0)))};
    case llvm::Instruction::Freeze:
      return {value(instruction.getOperand(0))};
    case llvm::Instruction::Alloca: {
      const Address object = effects().places().object(fmt::format("frame {}", code_.frames_++));
      frames_.insert(object);
      return {effects().address(object)};
    }
    default:
      notKnown(instruction);
  }
}

z3::expr Run::binary(const llvm::BinaryOperator& binary) {
  const auto a = [&] { return value(binary.getOperand(0)); };
  const auto b = [&] { return value(binary.getOperand(1)); };
  switch (binary.getOpcode()) {
    case llvm::Instruction::FAdd:
      return numbers().add(a(), b());
    case llvm::Instruction::FSub:
      return numbers().subtract(a(), b());
    case llvm::Instruction::FMul:
      return numbers().multiply(a(), b());
    case llvm::Instruction::FDiv:
      return numbers().divide(a(), b());
    default:
      return integer(binary).simplify();
  }
}

z3::expr Run::integer(const llvm::BinaryOperator& binary) {
  const z3::expr a = value(binary.getOperand(0));
  const z3::expr b = value(binary.getOperand(1));
  const bool truth = a.is_bool();
  switch (binary.getOpcode()) {
    case llvm::Instruction::And:
      return truth ? a && b : a & b;
    case llvm::Instruction::Or:
      return truth ? a || b : a | b;
    case llvm::Instruction::Xor:
      return truth ? a != b : a ^ b;
    default:
      break;
  }
  if (truth) {
    notKnown(binary);
  }
  switch (binary.getOpcode()) {
    case llvm::Instruction::Add:
      return a + b;
    case llvm::Instruction::Sub:
      return a - b;
    case llvm::Instruction::Mul:
      return a * b;
    case llvm::Instruction::Shl:
      return z3::shl(a, b);
    case llvm::Instruction::LShr:
      return z3::lshr(a, b);
    case llvm::Instruction::AShr:
      return z3::ashr(a, b);
    default:
      notKnown(binary);
  }
}

z3::expr Run::integerComparison(const llvm::ICmpInst& comparison) {
  z3::expr a = value(comparison.getOperand(0));
  z3::expr b = value(comparison.getOperand(1));
  if (a.is_bool()) {
    a = asBit(a, 1);
    b = asBit(b, 1);
  }
  switch (comparison.getPredicate()) {
    case llvm::CmpInst::ICMP_EQ:
      return (a == b).simplify();
    case llvm::CmpInst::ICMP_NE:
      return (a != b).simplify();
    case llvm::CmpInst::ICMP_UGT:
      return z3::ugt(a, b).simplify();
    case llvm::CmpInst::ICMP_UGE:
      return z3::uge(a, b).simplify();
    case llvm::CmpInst::ICMP_ULT:
      return z3::ult(a, b).simplify();
    case llvm::CmpInst::ICMP_ULE:
      return z3::ule(a, b).simplify();
    case llvm::CmpInst::ICMP_SGT:
      return (a > b).simplify();
    case llvm::CmpInst::ICMP_SGE:
      return (a >= b).simplify();
    case llvm::CmpInst::ICMP_SLT:
      return (a < b).simplify();
    case llvm::CmpInst::ICMP_SLE:
      return (a <= b).simplify();
    default:
      notKnown(comparison);
  }
}

z3::expr Run::cast(const llvm::CastInst& cast) {
  const z3::expr from = value(cast.getOperand(0));
  const llvm::Type& type = *cast.getDestTy();
  const unsigned bits = type.isIntegerTy() ? type.getIntegerBitWidth() : kNumberBits;
  const unsigned had = from.is_bool() ? 1 : from.get_sort().bv_size();
  switch (cast.getOpcode()) {
    case llvm::Instruction::ZExt:
      return (from.is_bool() ? asBit(from, bits) : z3::zext(from, bits - had)).simplify();
    case llvm::Instruction::SExt:
      return (from.is_bool() ? z3::ite(from, z3().bv_val(-1, bits), z3().bv_val(0, bits))
                             : z3::sext(from, bits - had))
          .simplify();
    case llvm::Instruction::Trunc:
      return (bits == 1 ? from.extract(0, 0) == z3().bv_val(1, 1) : from.extract(bits - 1, 0))
          .simplify();
    case llvm::Instruction::BitCast:
      return from;
    case llvm::Instruction::UIToFP:
      if (from.is_bool()) {
        return z3::ite(from, numbers().constant(1), numbers().constant(0)).simplify();
      }
      if (!llvm::cast<llvm::PossiblyNonNegInst>(cast).hasNonNeg()) {
        notKnown(cast);
      }
      [[fallthrough]];
    case llvm::Instruction::SIToFP:
      if (had == 32) {
        return numbers().fromWhole(from);
      }
      break;
    case llvm::Instruction::FPToSI:
      if (bits == 32) {
        return numbers().toWhole(from);
      }
      break;
    default:
      break;
  }
  notKnown(cast);
}

z3::expr Run::choice(const llvm::SelectInst& select) {
  const z3::expr condition = value(select.getCondition());
  return z3::ite(condition, value(select.getTrueValue()), value(select.getFalseValue())).simplify();
}

Run::Term Run::place(const llvm::GEPOperator& gep) {
  const llvm::DataLayout& layout = function_.getParent()->getDataLayout();
  llvm::MapVector<llvm::Value*, llvm::APInt> steps;
  llvm::APInt offset(layout.getIndexTypeSizeInBits(gep.getType()), 0);
  if (!gep.collectOffset(layout, offset.getBitWidth(), steps, offset)) {
    throw Undecided("a pointer that is computed in an unusual way");
  }
  z3::expr total = z3().bv_val(static_cast<int64_t>(offset.getSExtValue()), kNumberBits);
  for (const auto& [index, size] : steps) {
    const z3::expr at = value(index);
    total = total + z3::sext(at, kNumberBits - at.get_sort().bv_size()) *
                        z3().bv_val(static_cast<uint64_t>(size.getZExtValue()), kNumberBits);
  }
  const Term base = term(gep.getPointerOperand());
  return {(base.value + total).simplify(), base.table};
}

/// The table's number at that offset in bytes. Code chooses one that exists.
z3::expr Run::element(const llvm::GlobalVariable& table, const z3::expr& offset) {
  const llvm::Constant& content = *table.getInitializer();
  const auto number = [&](uint64_t i) {
    const llvm::Constant* element = content.getAggregateElement(static_cast<unsigned>(i));
    return numbers().constant(
        llvm::cast<llvm::ConstantFP>(element)->getValueAPF().convertToDouble());
  };
  z3::expr found = number(0);
  const uint64_t count = llvm::cast<llvm::ArrayType>(content.getType())->getNumElements();
  for (uint64_t i = 1; i < count; ++i) {
    found = z3::ite(offset == z3().bv_val(i * sizeof(double), kNumberBits), number(i), found);
  }
  return found.simplify();
}

z3::expr Run::load(const llvm::LoadInst& load) {
  if (load.isVolatile()) {
    notKnown(load);
  }
  const Term from = term(load.getPointerOperand());
  if (from.table != nullptr) {
    return element(*from.table, from.value);
  }
  const Address at = address(load.getPointerOperand());
  if (const auto local = locals_.find(at); local != locals_.end()) {
    return local->second;
  }
  if (load.getType()->isPointerTy()) {
    const auto behind = effects().places().behind(at);
    if (!behind) {
      throw Undecided("a pointer that is read from memory");
    }
    return effects().address(*behind);
  }
  const z3::expr held = effects().load(memory_, at);
  if (held.get_sort().bv_size() != load.getType()->getPrimitiveSizeInBits()) {
    throw Undecided("an access to a part of a number");
  }
  return held;
}

void Run::store(const llvm::StoreInst& store) {
  const Address at = address(store.getPointerOperand());
  const z3::expr stored = value(store.getValueOperand());
  if (store.isVolatile() || store.getValueOperand()->getType()->isPointerTy() || stored.is_bool()) {
    notKnown(store);
  }
  if (frames_.contains(objectOf(at))) {
    locals_.insert_or_assign(at, stored);
  } else {
    effects().store(memory_, at, stored);
  }
}

}  // namespace glider::codegen::validate
