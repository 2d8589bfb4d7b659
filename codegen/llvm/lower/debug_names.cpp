// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/debug_names.h"

#include "codegen/llvm/lower/context_places.h"
#include "support/units/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glider::codegen {
namespace {

/// Numbers in memory are in SI units.
std::string siUnitOf(const ir::Type& type) {
  if (type.kind == ir::TypeKind::Bool) {
    return "condition";
  }
  if (type.kind != ir::TypeKind::Quantity) {
    return "deg";
  }
  if (type.dimension == support::dimension::number) {
    return "number";
  }
  for (const support::Unit& unit : support::unitsOf(type.dimension)) {
    if (unit.to_si == 1) {
      return std::string(unit.spelling);
    }
  }
  const std::string name = support::unitName(type.dimension);
  return name.empty() ? "number" : name;
}

std::string_view kindName(ir::TemporalKind kind) {
  switch (kind) {
    case ir::TemporalKind::Became:
      return "became";
    case ir::TemporalKind::Held:
      return "held";
    case ir::TemporalKind::Mean:
      return "mean";
    case ir::TemporalKind::Lowest:
      return "lowest";
    case ir::TemporalKind::Highest:
      return "highest";
    case ir::TemporalKind::Spread:
      return "spread";
    case ir::TemporalKind::Slope:
      return "slope";
    case ir::TemporalKind::AtLowest:
      return "depth_of_lowest";
    case ir::TemporalKind::AtHighest:
      return "depth_of_highest";
    case ir::TemporalKind::Steepest:
      return "steepest";
    case ir::TemporalKind::AtSteepest:
      return "depth_of_steepest";
    case ir::TemporalKind::Number:
      return "yo_number";
  }
  std::unreachable();
}

/// Variables by the parts of their names: those of "search.profile.done" are in a struct `search`
/// with a struct `profile` in it.
struct NamedVariables {
  std::map<std::string, NamedVariables> parts;
  std::vector<uint32_t> variables;  ///< one, or the elements of an array
  int64_t first = 0;                ///< the number of its first element
  bool array = false;
};

class MemoryNames {
 public:
  MemoryNames(Lowering& lowering, llvm::GlobalVariable& memory)
      : lowering_(lowering),
        m_(lowering.mission),
        debug_(lowering.debug),
        memory_(memory),
        layout_(lowering.module.getDataLayout()),
        places_(contextPlaces(lowering)) {}

  void run() {
    clocks();
    sensors();
    variables();
    windows();
  }

 private:
  [[nodiscard]] uint64_t offsetIn(llvm::StructType* type, unsigned index) const {
    return layout_.getStructLayout(type)->getElementOffset(index).getFixedValue();
  }

  /// Unless something has that name already.
  void name(uint64_t offset, const std::string& name, llvm::DIType* type,
            support::SourceRange range = {}) {
    if (taken_.insert(name).second) {
      debug_.name(memory_, offset, name, type, range);
    }
  }

  /// A value of an enumeration hides a variable with its name.
  [[nodiscard]] std::vector<std::string> stateNames() const {
    std::set<std::string_view> others;
    for (const ir::Sensor& sensor : m_.sensors) {
      others.insert(sensor.name);
    }
    for (const ir::Variable& variable : m_.variables) {
      others.insert(variable.name);
    }
    std::vector<std::string> names;
    for (const ir::State& state : m_.states) {
      names.push_back((others.contains(state.name) ? "state_" : "") + state.name);
    }
    return names;
  }

  void clocks() {
    llvm::StructType* context = lowering_.types.GliderContext;
    llvm::DIType* state = debug_.oneOf("state", stateNames());
    name(offsetIn(context, field::GliderContext::state), "state", state);
    llvm::DIType* time = debug_.number("s");
    name(offsetIn(context, field::GliderContext::mission_time), "missiontime", time);
    name(offsetIn(context, field::GliderContext::entered), "state_entered", time);
    name(offsetIn(context, field::GliderContext::resumed), "state_resumed", time);
    name(offsetIn(context, field::GliderContext::moved_list), "moved_list", debug_.word());
    name(offsetIn(context, field::GliderContext::moved_case), "moved_case", debug_.word());
    name(offsetIn(context, field::GliderContext::stack_depth), "stack_depth", debug_.word());
    llvm::StructType* frame = lowering_.types.GliderFrame;
    if (lowering_.stack_depth > 0) {
      llvm::DIType* caller =
          debug_.record("caller", layout_.getTypeAllocSize(frame).getFixedValue(),
                        {{"state", offsetIn(frame, field::GliderFrame::state), state},
                         {"entered", offsetIn(frame, field::GliderFrame::entered), time}});
      name(places_.frames, "callers", debug_.list(caller, 0, lowering_.stack_depth));
    }
  }

  void sensors() {
    llvm::StructType* reading = lowering_.types.GliderReading;
    const uint64_t bytes = layout_.getTypeAllocSize(reading).getFixedValue();
    const uint64_t value = offsetIn(reading, field::GliderReading::value);
    for (uint64_t i = 0; i < m_.sensors.size(); ++i) {
      name(places_.readings + i * bytes + value, m_.sensors[i].name,
           debug_.number(siUnitOf(m_.sensors[i].type)));
    }
  }

  void variables() {
    NamedVariables plain, of_states;
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const ir::Variable& variable = m_.variables[i];
      if (!ir::isOfMonitor(variable.kind)) {
        add(variable.owner.valid() ? of_states : plain, i);
      }
    }
    if (!of_states.parts.empty()) {
      name(places_.variables, "states", typeOf("states", of_states));
    }
    alone("", plain);
  }

  void add(NamedVariables& all, uint32_t variable) {
    std::string_view rest = m_.variables[variable].name;
    NamedVariables* at = &all;
    for (size_t dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
      at = &at->parts[std::string(rest.substr(0, dot))];
      rest.remove_prefix(dot + 1);
    }
    const size_t bracket = rest.find('[');
    at = &at->parts[std::string(rest.substr(0, bracket))];
    if (bracket != std::string_view::npos && at->variables.empty()) {
      at->array = true;
      at->first = std::stoll(std::string(rest.substr(bracket + 1)));
    }
    at->variables.push_back(variable);
  }

  /// Of a struct all offsets are from the first variable of the mission.
  llvm::DIType* typeOf(const std::string& title, const NamedVariables& named) {
    if (!named.variables.empty()) {
      llvm::DIType* number = debug_.number(siUnitOf(m_.variables[named.variables.front()].type));
      return named.array ? debug_.list(number, named.first, named.variables.size()) : number;
    }
    std::vector<DebugMember> members;
    for (const auto& [name, part] : named.parts) {
      const uint64_t at = part.variables.empty() ? 0 : part.variables.front() * sizeof(double);
      members.push_back({name, at, typeOf(name, part)});
    }
    return debug_.record(title, m_.variables.size() * sizeof(double), members);
  }

  /// Under their whole names.
  void alone(const std::string& before, const NamedVariables& named) {
    for (const auto& [part, inner] : named.parts) {
      const std::string whole = before + part;
      if (inner.variables.empty()) {
        alone(whole + ".", inner);
      } else {
        const uint32_t first = inner.variables.front();
        name(places_.variables + first * sizeof(double), whole, typeOf(whole, inner),
             m_.variables[first].range);
      }
    }
  }

  void windows() {
    std::vector<DebugMember> members;
    std::set<std::string> taken;
    for (uint32_t i = 0; i < m_.temporals.size(); ++i) {
      const ir::Temporal& temporal = m_.temporals[i];
      const bool condition =
          temporal.kind == ir::TemporalKind::Became || temporal.kind == ir::TemporalKind::Held;
      const std::string base =
          fmt::format("{}_line_{}", kindName(temporal.kind), debug_.lineOf(temporal.range));
      std::string title = base;
      for (unsigned k = 2; !taken.insert(title).second; ++k) {
        title = fmt::format("{}_{}", base, k);
      }
      members.push_back({title, lowering_.index.temporal_slots[i] * sizeof(double),
                         debug_.number(condition ? "condition" : "number")});
    }
    if (!members.empty()) {
      const uint64_t bytes = lowering_.index.slot_count * sizeof(double);
      name(places_.temporals, "windows", debug_.record("windows", bytes, members));
    }
  }

  Lowering& lowering_;
  const ir::Mission& m_;
  DebugInfo& debug_;
  llvm::GlobalVariable& memory_;
  const llvm::DataLayout& layout_;
  ContextPlaces places_;
  std::set<std::string> taken_;
};

}  // namespace

void describeMemory(Lowering& lowering, llvm::GlobalVariable& memory) {
  if (lowering.debug.active()) {
    MemoryNames(lowering, memory).run();
  }
}

}  // namespace glider::codegen
