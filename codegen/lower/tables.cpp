// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/context_size.h"
#include "codegen/lower/lowering.h"
#include "runtime/abi/glider_abi.h"

#include <llvm/Support/Alignment.h>

#include <map>

namespace glider::codegen {
namespace {

static_assert(static_cast<int>(ir::Transition::Goto) == kGliderGoto);
static_assert(static_cast<int>(ir::Transition::Call) == kGliderCall);
static_assert(static_cast<int>(ir::Transition::Return) == kGliderReturn);
static_assert(static_cast<int>(ir::Transition::Exit) == kGliderExit);
static_assert(static_cast<int>(ir::Transition::Stay) == kGliderStay);
static_assert(static_cast<int>(ir::Encoding::Linear) == kGliderLinear);
static_assert(static_cast<int>(ir::Encoding::DegreesMinutes) == kGliderDegreesMinutes);

/// Makes the constants; equal names share one string.
class Tables {
 public:
  explicit Tables(Lowering& lowering) : lowering_(lowering) {}

  llvm::Constant* mission(const MissionFunctions& functions);

 private:
  llvm::Constant* word(size_t value) {
    return llvm::ConstantInt::get(llvm::Type::getInt32Ty(context()), value);
  }
  llvm::Constant* number(double value) {
    return llvm::ConstantFP::get(llvm::Type::getDoubleTy(context()), value);
  }
  llvm::Constant* text(const std::string& text);
  /// A constant array under `name`; null when it has no elements.
  llvm::Constant* array(llvm::StructType* type, const std::vector<llvm::Constant*>& elements,
                        const std::string& name);
  llvm::Constant* sensors();
  llvm::Constant* states();
  llvm::Constant* cases(const ir::State& state);
  llvm::Constant* log(const ir::State& state);
  llvm::LLVMContext& context() { return lowering_.module.getContext(); }

  Lowering& lowering_;
  std::map<std::string, llvm::Constant*> texts_;
};

llvm::Constant* Tables::text(const std::string& text) {
  llvm::Constant*& found = texts_[text];
  if (found == nullptr) {
    llvm::Constant* bytes = llvm::ConstantDataArray::getString(context(), text);
    auto* variable = new llvm::GlobalVariable(lowering_.module, bytes->getType(), true,
                                              llvm::GlobalValue::PrivateLinkage, bytes, "text");
    variable->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
    variable->setAlignment(llvm::Align(1));
    found = variable;
  }
  return found;
}

llvm::Constant* Tables::array(llvm::StructType* type, const std::vector<llvm::Constant*>& elements,
                              const std::string& name) {
  if (elements.empty()) {
    return llvm::ConstantPointerNull::get(llvm::PointerType::getUnqual(context()));
  }
  auto* array_type = llvm::ArrayType::get(type, elements.size());
  auto* variable = new llvm::GlobalVariable(lowering_.module, array_type, true,
                                            llvm::GlobalValue::PrivateLinkage,
                                            llvm::ConstantArray::get(array_type, elements), name);
  variable->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
  return variable;
}

llvm::Constant* Tables::sensors() {
  std::vector<llvm::Constant*> rows;
  for (const ir::Sensor& sensor : lowering_.mission.sensors) {
    rows.push_back(llvm::ConstantStruct::get(
        lowering_.types.GliderSensorInfo,
        {text(sensor.vehicle_name), number(sensor.to_si), number(sensor.lowest),
         number(sensor.highest), number(sensor.stale_after_s), word(sensor.id),
         word(static_cast<size_t>(sensor.encoding))}));
  }
  return array(lowering_.types.GliderSensorInfo, rows, "sensors");
}

llvm::Constant* Tables::cases(const ir::State& state) {
  std::vector<llvm::Constant*> rows;
  for (const ir::Case& item : state.cases) {
    rows.push_back(llvm::ConstantStruct::get(lowering_.types.GliderCaseInfo,
                                             {word(static_cast<size_t>(item.transition)),
                                              word(item.target.valid() ? item.target.index : 0)}));
  }
  return array(lowering_.types.GliderCaseInfo, rows, "cases." + state.name);
}

llvm::Constant* Tables::log(const ir::State& state) {
  std::vector<llvm::Constant*> rows;
  for (const ir::LogItem& item : state.log) {
    rows.push_back(llvm::ConstantStruct::get(lowering_.types.GliderLogInfo,
                                             {text(item.name), number(item.period_s)}));
  }
  return array(lowering_.types.GliderLogInfo, rows, "log_items." + state.name);
}

llvm::Constant* Tables::states() {
  std::vector<llvm::Constant*> rows;
  for (const ir::State& state : lowering_.mission.states) {
    rows.push_back(llvm::ConstantStruct::get(lowering_.types.GliderStateInfo,
                                             {text(state.name), cases(state), log(state),
                                              word(state.cases.size()), word(state.log.size())}));
  }
  return array(lowering_.types.GliderStateInfo, rows, "states");
}

llvm::Constant* Tables::mission(const MissionFunctions& functions) {
  const ir::Mission& mission = lowering_.mission;
  const uint64_t bytes =
      contextBytes(mission, lowering_.facts, lowering_.module.getDataLayout(), lowering_.types);
  return llvm::ConstantStruct::get(
      lowering_.types.GliderMission,
      {word(GLIDER_ABI_VERSION), word(mission.states.size()), word(mission.sensors.size()),
       word(lowering_.facts.stack_depth), word(memoryCount(mission)), word(bytes),
       text(mission.name), states(), sensors(), functions.guards, functions.fly,
       functions.log_value});
}

}  // namespace

void lowerTables(Lowering& lowering, const MissionFunctions& functions) {
  llvm::Module& module = lowering.module;
  new llvm::GlobalVariable(module, lowering.types.GliderMission, true,
                           llvm::GlobalValue::ExternalLinkage, Tables(lowering).mission(functions),
                           "gliderMission");
  auto* memory_type = llvm::ArrayType::get(
      llvm::Type::getInt8Ty(module.getContext()),
      contextBytes(lowering.mission, lowering.facts, module.getDataLayout(), lowering.types));
  auto* memory = new llvm::GlobalVariable(
      module, memory_type, false, llvm::GlobalValue::ExternalLinkage,
      llvm::ConstantAggregateZero::get(memory_type), "gliderContextMemory");
  memory->setAlignment(llvm::Align(8));
}

}  // namespace glider::codegen
