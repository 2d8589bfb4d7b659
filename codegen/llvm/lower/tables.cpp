// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/context_places.h"
#include "codegen/llvm/lower/debug_names.h"
#include "codegen/llvm/lower/guard_table.h"
#include "codegen/llvm/lower/lowering.h"
#include "hooks/protocol/features.h"
#include "hooks/protocol/nap_times.h"
#include "ir/core/parameter_info.h"
#include "ir/core/sampling.h"
#include "ir/core/walk.h"
#include "ir/worlds/depth_sensor.h"
#include "ir/worlds/naps.h"
#include "ir/worlds/start_depth.h"
#include "platforms/load/dictionary.h"
#include "runtime/abi/glider_abi.h"

#include <llvm/Support/Alignment.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

namespace glider::codegen {
namespace {

static_assert(static_cast<int>(ir::Encoding::Linear) == kGliderLinear);
static_assert(static_cast<int>(ir::Encoding::DegreesMinutes) == kGliderDegreesMinutes);
static_assert(static_cast<int>(ir::Encoding::Magnetic) == kGliderMagnetic);

/// The constant of a state, defined here or in another part.
llvm::GlobalVariable* placeOfState(Lowering& lowering, uint32_t state) {
  const std::string name = "state." + std::to_string(state);
  if (llvm::GlobalVariable* found = lowering.module.getNamedGlobal(name)) {
    return found;
  }
  auto* place = new llvm::GlobalVariable(lowering.module, lowering.types.GliderStateInfo, true,
                                         llvm::GlobalValue::ExternalLinkage, nullptr, name);
  place->setVisibility(llvm::GlobalValue::HiddenVisibility);
  place->setDSOLocal(true);
  return place;
}

/// Whole centimetres, rounded down.
size_t startDepthCm(const Lowering& lowering) {
  constexpr double kCmPerM = 100;
  return static_cast<size_t>(ir::startReading(lowering.mission, lowering.platform) * kCmPerM);
}

/// The feature of a command that not every vehicle obeys.
size_t neededFor(ir::Command command) {
  switch (command) {
    case ir::Command::Fin:
      return hooks::kFeatureFixedFin;
    case ir::Command::Pump:
    case ir::Command::Battery:
      return hooks::kFeatureActuators;
    case ir::Command::Descend:
    case ir::Command::Ascend:
    case ir::Command::DescendAt:
    case ir::Command::AscendAt:
    case ir::Command::Hover:
    case ir::Command::Surface:
    case ir::Command::Steer:
    case ir::Command::SteerTo:
    case ir::Command::Drift:
      break;
  }
  return 0;
}

/// How many variables, from the first on, are not set by the block that runs in every tick alone:
/// nothing else reads those, and opt/prepare_for_flight puts them last.
size_t decidingVariables(const ir::Mission& mission) {
  size_t first = mission.variables.size();
  ir::forEachStatement(mission, mission.every_tick, [&](const ir::Statement& statement) {
    if (statement.kind == ir::StatementKind::Set) {
      first = std::min<size_t>(first, statement.variable.index);
    }
  });
  return first;
}

/// What the vehicle must offer. What a profile or route in C commands is not known.
size_t neededFeatures(const ir::Mission& mission) {
  size_t needs = ir::samples(mission) ? hooks::kFeatureSampling : 0;
  needs |= mission.nap_s ? hooks::kFeatureNaps : 0U;
  for (const ir::Block& block : mission.blocks) {
    for (const ir::Statement& statement : block.statements) {
      needs |= statement.kind == ir::StatementKind::Command ? neededFor(statement.command) : 0U;
    }
  }
  return needs;
}

/// Makes the constants.
class Tables {
 public:
  explicit Tables(Lowering& lowering) : lowering_(lowering) {}

  llvm::Constant* mission(const MissionFunctions& functions);
  llvm::Constant* state(const ir::State& state, const StateFunctions& functions);

 private:
  llvm::Constant* word(size_t value) {
    return llvm::ConstantInt::get(llvm::Type::getInt32Ty(context()), value);
  }
  llvm::Constant* number(double value) {
    return llvm::ConstantFP::get(llvm::Type::getDoubleTy(context()), value);
  }
  /// A pointer to `function`; null for none.
  llvm::Constant* code(llvm::Function* function) {
    return function != nullptr ? static_cast<llvm::Constant*>(function) : nothing();
  }
  llvm::Constant* nothing() {
    return llvm::ConstantPointerNull::get(llvm::PointerType::getUnqual(context()));
  }
  llvm::Constant* text(const std::string& text) { return codegen::text(lowering_, text); }
  /// A constant array under `name`; null when it has no elements.
  llvm::Constant* array(llvm::Type* type, const std::vector<llvm::Constant*>& elements,
                        const std::string& name);
  llvm::Constant* sensors();
  llvm::Constant* dictionary();
  llvm::Constant* poll(const ir::Sensor& sensor);
  llvm::Constant* compass();
  llvm::Constant* naps();
  [[nodiscard]] size_t depthSensor() const;
  llvm::Constant* function(const char* name);
  llvm::Constant* states();
  llvm::Constant* parameters();
  llvm::Constant* cases(const std::vector<ir::Case>& cases, const std::string& name);
  llvm::Constant* log(const ir::State& state);
  llvm::LLVMContext& context() { return lowering_.module.getContext(); }

  Lowering& lowering_;
};

llvm::Constant* Tables::array(llvm::Type* type, const std::vector<llvm::Constant*>& elements,
                              const std::string& name) {
  if (elements.empty()) {
    return nothing();
  }
  auto* array_type = llvm::ArrayType::get(type, elements.size());
  auto* variable = new llvm::GlobalVariable(lowering_.module, array_type, true,
                                            llvm::GlobalValue::PrivateLinkage,
                                            llvm::ConstantArray::get(array_type, elements), name);
  variable->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
  return variable;
}

/// The function that is called for a reading; null if the vehicle reports it.
llvm::Constant* Tables::poll(const ir::Sensor& sensor) {
  if (sensor.isHeard()) {
    return function("gliderNothingHeard");
  }
  if (sensor.symbol.empty()) {
    return nothing();
  }
  llvm::Type* type = llvm::Type::getDoubleTy(context());
  auto found = lowering_.module.getOrInsertFunction(sensor.symbol,
                                                    llvm::FunctionType::get(type, {type}, false));
  return llvm::cast<llvm::Constant>(found.getCallee());
}

/// A function of the runtime, named only where it is needed. Only its address is taken, so its type
/// does not matter.
llvm::Constant* Tables::function(const char* name) {
  auto* type = llvm::FunctionType::get(llvm::Type::getVoidTy(context()), false);
  return llvm::cast<llvm::Constant>(lowering_.module.getOrInsertFunction(name, type).getCallee());
}

/// A mission that shares something has one too, by whose function it takes in what is received.
llvm::Constant* Tables::compass() {
  const bool talks = !lowering_.mission.shares.empty();
  const bool headings = lowering_.mission.compass.has_value();
  if (!talks && !headings) {
    return nothing();
  }
  const ir::Compass compass = lowering_.mission.compass.value_or(ir::Compass{});
  llvm::Constant* value = llvm::ConstantStruct::get(
      lowering_.types.GliderCompass,
      {number(compass.declination.value_or(std::numeric_limits<double>::quiet_NaN())),
       word(compass.variation.valid() ? lowering_.mission[compass.variation].id : GLIDER_NO_SENSOR),
       word(0),
       function(!talks     ? "gliderConvertHeadings"
                : headings ? "gliderHearAndConvertHeadings"
                           : "gliderHear")});
  auto* variable = new llvm::GlobalVariable(lowering_.module, lowering_.types.GliderCompass, true,
                                            llvm::GlobalValue::PrivateLinkage, value, "compass");
  variable->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
  return variable;
}

size_t Tables::depthSensor() const {
  const auto depth = ir::depthSensor(lowering_.mission, lowering_.platform);
  return depth ? depth->index : GLIDER_NO_SENSOR;
}

llvm::Constant* Tables::naps() {
  const std::optional<double> longest = lowering_.mission.nap_s;
  if (!longest) {
    return nothing();
  }
  llvm::Constant* value = llvm::ConstantStruct::get(
      lowering_.types.GliderNaps,
      {number(*longest), number(ir::napAhead_m(lowering_.platform)), word(depthSensor()),
       word(kHookMostWakeSecs), word(decidingVariables(lowering_.mission)), word(0),
       function("gliderNapAfterTick")});
  auto* variable = new llvm::GlobalVariable(lowering_.module, lowering_.types.GliderNaps, true,
                                            llvm::GlobalValue::PrivateLinkage, value, "naps");
  variable->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
  return variable;
}

llvm::Constant* Tables::sensors() {
  std::vector<llvm::Constant*> rows;
  for (const ir::Sensor& sensor : lowering_.mission.sensors) {
    rows.push_back(
        llvm::ConstantStruct::get(lowering_.types.GliderSensorInfo,
                                  {text(sensor.isOfVehicle() ? sensor.vehicle_name : sensor.name),
                                   poll(sensor), number(sensor.to_si), number(sensor.lowest),
                                   number(sensor.highest), number(sensor.stale_after_s),
                                   word(sensor.id), word(static_cast<size_t>(sensor.encoding))}));
  }
  return array(lowering_.types.GliderSensorInfo, rows, "sensors");
}

/// All sensors of the vehicle, whether the mission uses them or not: the protocol refers to all of
/// them.
llvm::Constant* Tables::dictionary() {
  const platforms::Dictionary of(lowering_.platform);
  const GliderDictionary& whole = of.get();
  std::vector<llvm::Constant*> rows;
  for (const GliderSensorFormat& format : std::span(whole.sensors, whole.count)) {
    rows.push_back(llvm::ConstantStruct::get(lowering_.types.GliderSensorFormat,
                                             {number(format.dead_band), word(format.bytes),
                                              word(format.every), word(format.science), word(0)}));
  }
  std::vector<llvm::Constant*> roles;
  for (const uint32_t id : std::span(whole.roles, kGliderRoleCount)) {
    roles.push_back(word(id));
  }
  llvm::Constant* value =
      llvm::ConstantStruct::get(lowering_.types.GliderDictionary,
                                {array(lowering_.types.GliderSensorFormat, rows, "sensor_formats"),
                                 array(llvm::Type::getInt32Ty(context()), roles, "sensor_roles"),
                                 word(whole.count), word(whole.hash)});
  auto* variable =
      new llvm::GlobalVariable(lowering_.module, lowering_.types.GliderDictionary, true,
                               llvm::GlobalValue::PrivateLinkage, value, "dictionary");
  variable->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
  return variable;
}

llvm::Constant* Tables::parameters() {
  std::vector<llvm::Constant*> rows;
  for (const ir::ParameterInfo& parameter : ir::parameterInfos(lowering_.mission)) {
    rows.push_back(llvm::ConstantStruct::get(
        lowering_.types.GliderParameterInfo,
        {text(parameter.name), number(parameter.initial), number(parameter.lowest),
         number(parameter.highest), text(parameter.units)}));
  }
  return array(lowering_.types.GliderParameterInfo, rows, "parameters");
}

llvm::Constant* Tables::cases(const std::vector<ir::Case>& cases, const std::string& name) {
  std::vector<llvm::Constant*> rows;
  for (const ir::Case& item : cases) {
    rows.push_back(llvm::ConstantStruct::get(lowering_.types.GliderCaseInfo,
                                             {word(static_cast<size_t>(item.transition)),
                                              word(item.target.valid() ? item.target.index : 0)}));
  }
  return array(lowering_.types.GliderCaseInfo, rows, "cases." + name);
}

llvm::Constant* Tables::log(const ir::State& state) {
  std::vector<llvm::Constant*> rows;
  for (const ir::LogItem& item : state.log) {
    const ir::Expr& value = lowering_.mission[item.value];
    rows.push_back(
        llvm::ConstantStruct::get(lowering_.types.GliderLogInfo,
                                  {text(item.name), number(item.period_s), word(sourceOf(value.op)),
                                   word(value.op == ir::Op::Sensor ? value.sensor.index : 0)}));
  }
  return array(lowering_.types.GliderLogInfo, rows, "log_items." + state.name);
}

llvm::Constant* Tables::state(const ir::State& state, const StateFunctions& functions) {
  return llvm::ConstantStruct::get(
      lowering_.types.GliderStateInfo,
      {text(state.name), cases(state.cases, state.name), log(state), code(functions.guards),
       code(functions.act), code(functions.enter), code(functions.advance), code(functions.profile),
       code(functions.route), code(functions.foresee), word(state.cases.size()),
       word(state.log.size())});
}

/// An array of pointers, because a state may be in another part of the mission.
llvm::Constant* Tables::states() {
  std::vector<llvm::Constant*> places;
  for (uint32_t i = 0; i < lowering_.mission.states.size(); ++i) {
    places.push_back(placeOfState(lowering_, i));
  }
  auto* type = llvm::ArrayType::get(llvm::PointerType::getUnqual(context()), places.size());
  return new llvm::GlobalVariable(lowering_.module, type, true, llvm::GlobalValue::PrivateLinkage,
                                  llvm::ConstantArray::get(type, places), "states");
}

llvm::Constant* Tables::mission(const MissionFunctions& functions) {
  const ir::Mission& mission = lowering_.mission;
  const MissionIndex& index = lowering_.index;
  return llvm::ConstantStruct::get(lowering_.types.GliderMission,
                                   {word(GLIDER_ABI_VERSION),
                                    word(mission.states.size()),
                                    word(mission.sensors.size()),
                                    word(lowering_.stack_depth),
                                    word(index.memory_count),
                                    word(mission.variables.size()),
                                    word(index.slot_count),
                                    word(index.interval_count),
                                    word(index.parameter_count),
                                    word(mission.always.size()),
                                    word(contextPlaces(lowering_).bytes),
                                    word(mission.uses.size()),
                                    number(mission.resume_within_s),
                                    word(mission.new_after_restart ? 1 : 0),
                                    word(neededFeatures(mission)),
                                    word(startDepthCm(lowering_)),
                                    text(mission.name),
                                    states(),
                                    sensors(),
                                    cases(mission.always, "always"),
                                    parameters(),
                                    code(functions.begin),
                                    code(functions.advance),
                                    code(functions.guards),
                                    code(functions.act),
                                    code(functions.condition),
                                    compass(),
                                    dictionary(),
                                    naps()});
}

}  // namespace

void lowerStateInfo(Lowering& lowering, uint32_t state, const StateFunctions& functions) {
  placeOfState(lowering, state)
      ->setInitializer(Tables(lowering).state(lowering.mission.states[state], functions));
}

void lowerTables(Lowering& lowering, const MissionFunctions& functions) {
  llvm::Module& module = lowering.module;
  new llvm::GlobalVariable(module, lowering.types.GliderMission, true,
                           llvm::GlobalValue::ExternalLinkage, Tables(lowering).mission(functions),
                           "gliderMission");
  auto* memory_type = llvm::ArrayType::get(llvm::Type::getInt8Ty(module.getContext()),
                                           contextPlaces(lowering).bytes);
  auto* memory = new llvm::GlobalVariable(
      module, memory_type, false, llvm::GlobalValue::ExternalLinkage,
      llvm::ConstantAggregateZero::get(memory_type), "gliderContextMemory");
  memory->setAlignment(llvm::Align(8));
  describeMemory(lowering, *memory);
}

}  // namespace glider::codegen
