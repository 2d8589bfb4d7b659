// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/guard_table.h"

#include "codegen/llvm/lower/body.h"
#include "ir/core/ops.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/abi/order.h"
#include "support/check.h"

#include <algorithm>
#include <limits>

namespace glider::codegen {
namespace {

constexpr uint32_t kWordBits = 32;

/// The least order past a cut.
int64_t keyOf(const ir::Cut& cut) {
  return gliderOrder(cut.at) + (cut.inclusive ? 0 : 1);
}

std::vector<uint32_t> bitsOf(size_t count, llvm::function_ref<bool(size_t)> holds) {
  std::vector<uint32_t> words((count + kWordBits - 1) / kWordBits);
  for (size_t i = 0; i < count; ++i) {
    words[i / kWordBits] |= (holds(i) ? 1U : 0U) << (i % kWordBits);
  }
  return words;
}

class Table {
 public:
  Table(Lowering& lowering, const ir::GuardTable& table, std::string name)
      : lowering_(lowering), table_(table), name_(std::move(name)) {}

  llvm::Constant* lower(llvm::Function* holds, uint32_t memory) {
    std::vector<llvm::Constant*> columns;
    for (uint32_t i = 0; i < table_.columns.size(); ++i) {
      columns.push_back(column(i));
    }
    std::vector<uint16_t> cases;
    for (const ir::GuardRow& row : table_.rows) {
      cases.push_back(static_cast<uint16_t>(row.number));
    }
    const auto exact =
        bitsOf(table_.rows.size(), [&](size_t row) { return table_.rows[row].exact; });
    llvm::StructType* type = lowering_.types.GliderGuardTable;
    llvm::Constant* none = llvm::ConstantPointerNull::get(llvm::PointerType::getUnqual(context()));
    return global(
        llvm::ConstantStruct::get(
            type,
            {global(llvm::ConstantArray::get(
                        llvm::ArrayType::get(lowering_.types.GliderGuardColumn, columns.size()),
                        columns),
                    "columns"),
             list(cases, "cases"), list(exact, "exact"),
             holds != nullptr ? static_cast<llvm::Constant*>(holds) : none, word(columns.size()),
             word(exact.size()), word(memory), word(0)}),
        "table");
  }

 private:
  llvm::Constant* column(uint32_t number) {
    const ir::GuardColumn& column = table_.columns[number];
    std::vector<uint64_t> keys;
    for (const ir::Cut& cut : column.cuts) {
      keys.push_back(static_cast<uint64_t>(keyOf(cut)));
    }
    keys.push_back(static_cast<uint64_t>(gliderOrder(std::numeric_limits<double>::infinity()) +
                                         1));  // unknown
    std::vector<uint16_t> turns;
    std::vector<uint16_t> first_turn;
    for (uint32_t interval = 0; interval < keys.size(); ++interval) {
      first_turn.push_back(static_cast<uint16_t>(turns.size()));
      addTurns(number, interval, turns);
    }
    first_turn.push_back(static_cast<uint16_t>(turns.size()));
    return llvm::ConstantStruct::get(
        lowering_.types.GliderGuardColumn,
        {list(keys, "keys"), list(strides(number), "rows"), list(turns, "turns"),
         list(first_turn, "first_turn"), word(keys.size()), word(sourceOf(column.source)),
         word(column.sensor.valid() ? column.sensor.index : 0), word(0)});
  }

  bool mayHold(size_t row, uint32_t column, uint32_t interval) const {
    const ir::GuardRow::Range& range = table_.rows[row].within[column];
    return range.first <= interval && interval <= range.last;
  }

  /// The rows that change between an interval and the next.
  void addTurns(uint32_t column, uint32_t interval, std::vector<uint16_t>& turns) const {
    for (size_t row = 0; row < table_.rows.size(); ++row) {
      if (mayHold(row, column, interval) != mayHold(row, column, interval + 1)) {
        turns.push_back(static_cast<uint16_t>(row));
      }
    }
  }

  /// The rows that may hold in each interval from which turns are counted, and in the last.
  std::vector<uint32_t> strides(uint32_t column) const {
    std::vector<uint32_t> words;
    const uint32_t last = table_.columns[column].unknown();
    auto add = [&](uint32_t interval) {
      const auto here =
          bitsOf(table_.rows.size(), [&](size_t row) { return mayHold(row, column, interval); });
      words.insert(words.end(), here.begin(), here.end());
    };
    for (uint32_t interval = 0; interval < last; interval += GLIDER_GUARD_STRIDE) {
      add(interval);
    }
    add(last);
    return words;
  }

  template <typename T>
  llvm::Constant* list(const std::vector<T>& values, const char* what) {
    return global(llvm::ConstantDataArray::get(context(), values), what);
  }
  llvm::Constant* word(size_t value) {
    return llvm::ConstantInt::get(llvm::Type::getInt32Ty(context()), value);
  }
  llvm::Constant* global(llvm::Constant* value, const char* what) {
    auto* variable = new llvm::GlobalVariable(lowering_.module, value->getType(), true,
                                              llvm::GlobalValue::PrivateLinkage, value,
                                              std::string(what) + "." + name_);
    variable->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
    return variable;
  }
  llvm::LLVMContext& context() { return lowering_.module.getContext(); }

  Lowering& lowering_;
  const ir::GuardTable& table_;
  std::string name_;
};

/// The guards of cases with rows that are not exact, each evaluated by its number.
llvm::Function* lowerHolds(Lowering& lowering, const ir::GuardTable& table,
                           const std::vector<ir::Case>& cases, const std::string& name,
                           support::SourceRange range) {
  if (std::ranges::all_of(table.rows, &ir::GuardRow::exact)) {
    return nullptr;
  }
  Body body(lowering, "holds." + name, Body::Result::Word, 1, name + " guards", range);
  llvm::BasicBlock* none = body.block("none");
  llvm::SwitchInst* choice = body.builder.CreateSwitch(body.function->getArg(1), none);
  body.builder.SetInsertPoint(none);
  body.builder.CreateRet(body.builder.getInt32(0));
  uint32_t last = UINT32_MAX;
  for (const ir::GuardRow& row : table.rows) {
    if (row.exact || row.number == last) {
      continue;
    }
    last = row.number;
    llvm::BasicBlock* asked = body.block("asked");
    choice->addCase(body.builder.getInt32(row.number), asked);
    body.builder.SetInsertPoint(asked);
    body.expressions.forget();
    lowering.debug.locate(body.builder, cases[row.number].range);
    body.builder.CreateRet(body.builder.CreateZExt(body.expressions.isTrue(cases[row.number].guard),
                                                   body.builder.getInt32Ty()));
  }
  return body.function;
}

}  // namespace

GliderSource sourceOf(ir::Op op) {
  if (op == ir::Op::Sensor) {
    return kGliderSensor;
  }
  switch (ir::opIn<ir::ClockOp>(op)) {
    case ir::ClockOp::MissionTime:
      return kGliderMissionTime;
    case ir::ClockOp::StateTime:
      return kGliderStateTime;
    case ir::ClockOp::ResumeTime:
      return kGliderResumeTime;
  }
  CHECK(false, "a clock that the runtime does not have");
}

llvm::Function* lowerGuardTable(Lowering& lowering, const ir::GuardTable& table,
                                const std::vector<ir::Case>& cases, const std::string& name,
                                support::SourceRange range, uint32_t memory) {
  llvm::Function* holds = lowerHolds(lowering, table, cases, name, range);
  llvm::Constant* constant = Table(lowering, table, name).lower(holds, memory);
  Body body(lowering, "guards." + name, Body::Result::Word, 1, name + " events", range);
  llvm::IRBuilder<>& builder = body.builder;
  auto* type = llvm::FunctionType::get(
      builder.getInt32Ty(), {builder.getPtrTy(), builder.getPtrTy(), builder.getInt32Ty()}, false);
  llvm::CallInst* call =
      builder.CreateCall(lowering.module.getOrInsertFunction("gliderFirstTrue", type),
                         {body.context(), constant, body.function->getArg(1)});
  call->setDoesNotThrow();
  call->setTailCall();
  builder.CreateRet(call);
  return body.function;
}

}  // namespace glider::codegen
