// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/places.h"

#include "codegen/llvm/validate/undecided.h"
#include "ir/core/ops.h"
#include "runtime/abi/glider_abi.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::codegen::validate {
namespace {

namespace context_field = field::GliderContext;

constexpr const char* kContext = "context";

/// Which field of the context points at which object.
struct Behind {
  unsigned field;
  const char* object;
};
constexpr Behind kBehind[] = {
    {context_field::readings, "readings"},   {context_field::memory, "memory"},
    {context_field::variables, "variables"}, {context_field::temporals, "temporals"},
    {context_field::calls, "calls"},
};

/// What only the vehicle's frames and the runtime's step change: not the functions that a mission
/// calls.
bool isOfTick(unsigned field) {
  switch (field) {
    case context_field::mission_time:
    case context_field::entered:
    case context_field::resumed:
    case context_field::limit:
    case context_field::fired_always:
    case context_field::fired_state:
    case context_field::fired_profile:
    case context_field::fired_route:
      return true;
    default:
      return false;
  }
}

[[noreturn]] void partOfACell() {
  throw Undecided("an access to a part of a number");
}

}  // namespace

Address Places::object(const std::string& name) {
  return objects_.try_emplace(name, (objects_.size() + 1) << 32U).first->second;
}

std::optional<Address> Places::behind(Address pointer) {
  if (objectOf(pointer) == object(kContext)) {
    for (const Behind& one : kBehind) {
      if (offsetIn(pointer) == offsetOf(types_.GliderContext, one.field)) {
        return object(one.object);
      }
    }
  }
  return {};
}

uint64_t Places::offsetOf(llvm::StructType* type, unsigned field) const {
  return layout_.getStructLayout(type)->getElementOffset(field);
}

std::optional<unsigned> Places::fieldAt(llvm::StructType* type, uint64_t offset) const {
  const llvm::StructLayout* layout = layout_.getStructLayout(type);
  if (offset >= layout->getSizeInBytes()) {
    return {};
  }
  const unsigned field = layout->getElementContainingOffset(offset);
  return layout->getElementOffset(field) == offset ? std::optional(field) : std::nullopt;
}

Address Places::context(unsigned field) {
  return object(kContext) + offsetOf(types_.GliderContext, field);
}

Address Places::variable(ir::VariableId id) {
  return object("variables") + uint64_t{sizeof(double)} * id.index;
}

Address Places::temporal(ir::TemporalId id, uint32_t slot) {
  return object("temporals") +
         sizeof(double) * (uint64_t{index_.temporal_slots.at(id.index)} + slot);
}

Address Places::reading(ir::SensorId id, unsigned field) {
  return object("readings") + layout_.getTypeAllocSize(types_.GliderReading) * id.index +
         offsetOf(types_.GliderReading, field);
}

Address Places::call(ir::UseId id, unsigned field) {
  return object("calls") + layout_.getTypeAllocSize(types_.GliderCall) * id.index +
         offsetOf(types_.GliderCall, field);
}

Address Places::behaviourMemory(uint32_t block) {
  return object("memory") + uint64_t{GLIDER_BEHAVIOUR_MEMORY_BYTES} * block;
}

Address Places::text(const std::string& text) {
  return object("text " + text);
}

Cell Places::at(Address address) {
  const uint64_t offset = offsetIn(address);
  const Address object_at = objectOf(address);
  const std::pair<const char*, Cell (Places::*)(uint64_t)> kinds[] = {
      {kContext, &Places::inContext},      {"readings", &Places::inReadings},
      {"calls", &Places::inCalls},         {"variables", &Places::inVariables},
      {"temporals", &Places::inTemporals},
  };
  for (const auto& [name, cell] : kinds) {
    if (object_at == object(name)) {
      return (this->*cell)(offset);
    }
  }
  throw Undecided("an access to memory that is not the mission's");
}

Cell Places::inContext(uint64_t offset) {
  const auto field = fieldAt(types_.GliderContext, offset);
  if (!field) {
    partOfACell();
  }
  llvm::Type* type = types_.GliderContext->getElementType(*field);
  if (type->isPointerTy()) {
    throw Undecided("a pointer of the context is used as a number");
  }
  const bool of_tick = isOfTick(*field);
  const CellKind kind = !type->isDoubleTy() ? CellKind::Word
                        : of_tick           ? CellKind::Settled
                                            : CellKind::Number;
  const std::string name = *field == context_field::mission_time ? "mission time"
                           : *field == context_field::entered    ? "the time of entering the state"
                           : *field == context_field::resumed    ? "the time of resuming the state"
                           : *field == context_field::limit
                               ? "the limit of `always`"
                               : fmt::format("field {} of the context", *field);
  return {kind, type->isDoubleTy() ? 8U : 4U, name, of_tick};
}

Cell Places::inReadings(uint64_t offset) {
  const uint64_t stride = layout_.getTypeAllocSize(types_.GliderReading);
  const auto field = fieldAt(types_.GliderReading, offset % stride);
  const auto sensor = static_cast<size_t>(offset / stride);
  if (!field || sensor >= mission_.sensors.size()) {
    partOfACell();
  }
  const std::string& name = mission_.sensors[sensor].name;
  switch (*field) {
    case field::GliderReading::value:
      return {CellKind::Settled, 8, name, true};
    case field::GliderReading::updated:
      return {CellKind::Settled, 8, "the time of the newest " + name, true};
    default:
      throw Undecided("an access to a part of a reading that missions do not read");
  }
}

Cell Places::inCalls(uint64_t offset) {
  const uint64_t stride = layout_.getTypeAllocSize(types_.GliderCall);
  const auto field = fieldAt(types_.GliderCall, offset % stride);
  const auto use = static_cast<size_t>(offset / stride);
  if (!field || use >= mission_.uses.size()) {
    partOfACell();
  }
  const std::string name = mission_[ir::UseId{static_cast<uint32_t>(use)}].name;
  if (*field == field::GliderCall::made) {
    return {CellKind::Word, 4, "whether `" + name + "` was called", true};
  }
  return {CellKind::Settled, 8, "the result of `" + name + "`", true};
}

Cell Places::inVariables(uint64_t offset) {
  const auto number = static_cast<size_t>(offset / sizeof(double));
  if (offset % sizeof(double) != 0 || number >= mission_.variables.size()) {
    partOfACell();
  }
  const ir::Variable& variable = mission_.variables[number];
  const bool truth = variable.type.kind == ir::TypeKind::Bool;
  return {truth ? CellKind::Truth : CellKind::Number, 8, "`" + variable.name + "`", true};
}

Cell Places::inTemporals(uint64_t offset) {
  const auto slot = static_cast<uint32_t>(offset / sizeof(double));
  const auto after = std::ranges::upper_bound(index_.temporal_slots, slot);
  if (offset % sizeof(double) != 0 || after == index_.temporal_slots.begin()) {
    partOfACell();
  }
  const auto number = static_cast<size_t>(after - index_.temporal_slots.begin() - 1);
  const ir::Temporal& temporal = mission_.temporals.at(number);
  const uint32_t within = slot - index_.temporal_slots[number];
  const bool window = ir::isWindow(temporal.kind);
  const std::string what = fmt::format("{} number {}", window ? "window" : "watch", number + 1);
  constexpr uint32_t kSince = 2;
  if (within == 0) {
    return {window ? CellKind::Number : CellKind::Truth, 8, "the value of " + what, true};
  }
  if (window) {
    return {CellKind::Hidden, 8, "the content of " + what, true};
  }
  return within == kSince ? Cell{CellKind::Settled, 8, "since when " + what + " holds", true}
                          : Cell{CellKind::Truth, 8, "whether " + what + " held before", true};
}

std::vector<Address> Places::fieldsIn(Address from, uint64_t bytes) {
  if (objectOf(from) != object(kContext)) {
    throw Undecided("memory that is filled, and is not the context's");
  }
  std::vector<Address> found;
  uint64_t end = offsetIn(from);
  const llvm::StructLayout* layout = layout_.getStructLayout(types_.GliderContext);
  for (unsigned i = 0; i < types_.GliderContext->getNumElements(); ++i) {
    const uint64_t offset = layout->getElementOffset(i);
    const uint64_t size = layout_.getTypeAllocSize(types_.GliderContext->getElementType(i));
    if (offset >= offsetIn(from) && offset + size <= offsetIn(from) + bytes) {
      found.push_back(object(kContext) + offset);
      end = offset + size;
    }
  }
  if (end != offsetIn(from) + bytes) {
    throw Undecided("a part of a field of the context is filled");
  }
  return found;
}

}  // namespace glider::codegen::validate
