// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/program/talk_constant.h"

#include <llvm/ADT/STLExtras.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/DerivedTypes.h>

#include <vector>

namespace glider::codegen {
namespace {

using Words = std::vector<uint32_t>;

/// Structs of numbers, then words, without padding.
class TalkConstant {
 public:
  explicit TalkConstant(llvm::LLVMContext& context) : context_(context) {}

  llvm::Constant* of(const GliderTalk& talk) {
    std::vector<llvm::Constant*> fields =
        fieldsOf({talk.slot_s}, {talk.utc, talk.share_count, talk.message_count,
                                 talk.begin_within_ms, talk.named_count, talk.vehicle_count});
    fields.push_back(arrayOf(talk.shares, [this](const GliderShare& share) {
      return llvm::ConstantStruct::getAnon(
          context_, fieldsOf({share.lowest, share.step},
                             {share.values, share.reading, share.variable, share.peer}));
    }));
    fields.push_back(arrayOf(talk.messages, [this](const GliderMessage& message) {
      return llvm::ConstantStruct::getAnon(
          context_, fieldsOf({message.period},
                             {message.first, message.count, message.signature, message.bytes}));
    }));
    fields.push_back(arrayOf(talk.named, [this](const GliderNamed& named) {
      std::vector<llvm::Constant*> row = fieldsOf({}, {named.reading});
      for (const uint16_t half : {named.share, named.source}) {
        row.push_back(llvm::ConstantInt::get(llvm::Type::getInt16Ty(context_), half));
      }
      return llvm::ConstantStruct::getAnon(context_, row);
    }));
    return llvm::ConstantStruct::getAnon(context_, fields);
  }

 private:
  std::vector<llvm::Constant*> fieldsOf(const std::vector<double>& numbers, const Words& words) {
    std::vector<llvm::Constant*> fields;
    for (const double number : numbers) {
      fields.push_back(llvm::ConstantFP::get(llvm::Type::getDoubleTy(context_), number));
    }
    for (const uint32_t word : words) {
      fields.push_back(llvm::ConstantInt::get(llvm::Type::getInt32Ty(context_), word));
    }
    return fields;
  }

  template <typename Element, size_t kCount, typename Constant>
  llvm::Constant* arrayOf(const Element (&elements)[kCount], Constant constant) {
    std::vector<llvm::Constant*> rows;
    for (const Element& element : elements) {
      rows.push_back(constant(element));
    }
    return llvm::ConstantArray::get(llvm::ArrayType::get(rows.front()->getType(), kCount), rows);
  }

  llvm::LLVMContext& context_;
};

}  // namespace

void addTalkConstant(llvm::Module& module, const GliderTalk& talk) {
  static_assert(sizeof(GliderShare) == 2 * sizeof(double) + 4 * sizeof(uint32_t));
  static_assert(sizeof(GliderNamed) == 2 * sizeof(uint32_t));
  static_assert(sizeof(GliderMessage) == sizeof(double) + 4 * sizeof(uint32_t));
  static_assert(sizeof(GliderTalk) ==
                sizeof(double) + 6 * sizeof(uint32_t) +
                    GLIDER_MOST_SHARES * (sizeof(GliderShare) + sizeof(GliderMessage)) +
                    GLIDER_MOST_NAMED * sizeof(GliderNamed));
  llvm::Constant* value = TalkConstant(module.getContext()).of(talk);
  new llvm::GlobalVariable(module, value->getType(), true, llvm::GlobalValue::ExternalLinkage,
                           value, "gliderTalk");
}

}  // namespace glider::codegen
