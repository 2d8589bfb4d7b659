// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/mission_functions.h"

#include "ir/core/sampling.h"
#include "runtime/abi/glider_abi.h"

#include <optional>
#include <ranges>
#include <utility>
#include <vector>

namespace glider::codegen::validate {
namespace {

bool isInC(const ir::Mission& mission, const ir::Activity& activity) {
  return !mission[activity.behaviour].symbol.empty();
}

/// The watches and windows of `always`, or of a state, in the order of the vector.
std::vector<ir::TemporalId> temporalsOf(const ir::Mission& mission,
                                        std::optional<ir::StateId> state) {
  std::vector<ir::TemporalId> all;
  for (uint32_t i = 0; i < mission.temporals.size(); ++i) {
    const ir::Temporal& temporal = mission.temporals[i];
    const bool of_always = temporal.list == ir::ListKind::Always;
    if (state ? !of_always && temporal.state == *state : of_always) {
      all.push_back({i});
    }
  }
  return all;
}

/// What is tried in order: the first that holds is what happens.
class InOrder {
 public:
  explicit InOrder(Effects& effects) : effects_(effects) {}

  /// If `holds`, the function returns `result` and leaves `memory`.
  void tryNext(const z3::expr& holds, uint32_t result, const Memory& memory) {
    tried_.emplace_back(holds.simplify(), Outcome{effects_.word(result), memory});
  }
  Outcome otherwise(uint32_t result, const Memory& memory) {
    Outcome outcome{effects_.word(result), memory};
    for (const auto& [holds, one] : tried_ | std::views::reverse) {
      outcome = effects_.either(holds, one, outcome);
    }
    return outcome;
  }

 private:
  Effects& effects_;
  std::vector<std::pair<z3::expr, Outcome>> tried_;
};

}  // namespace

z3::expr MissionFunctions::time(const Memory& memory) {
  return effects_.load(memory, effects_.places().context(field::GliderContext::mission_time));
}

/// Step 4 and C5. Where a C function is called, the guards of `always` from the limit on are not
/// evaluated; otherwise that makes no difference, and the runtime looks at the limit.
Outcome MissionFunctions::guards(const std::vector<ir::Case>& cases, ir::ListKind list,
                                 const z3::expr& word) {
  const bool limited = list == ir::ListKind::Always && !mission_.uses.empty();
  Memory memory = effects_.first();
  InOrder cases_in_order(effects_);
  for (uint32_t i = 0; i < cases.size(); ++i) {
    if (limited) {
      const z3::expr limit =
          effects_.load(memory, effects_.places().context(field::GliderContext::limit));
      cases_in_order.tryNext(z3::ule(limit, effects_.word(i)), GLIDER_NO_CASE, memory);
    }
    const z3::expr is_true = expressions_.isTrue(memory, cases[i].guard);
    cases_in_order.tryNext(z3::ule(word, effects_.word(i)) && is_true, i, memory);
  }
  return cases_in_order.otherwise(GLIDER_NO_CASE, memory);
}

/// All arguments are evaluated before any parameter gets one.
void MissionFunctions::pass(Memory& memory, const ir::Case& fired) {
  std::vector<z3::expr> values;
  for (const ir::ExprId argument : fired.arguments) {
    values.push_back(expressions_.asNumber(memory, argument));
  }
  for (size_t i = 0; i < values.size(); ++i) {
    assign(memory, mission_[fired.target].parameters.at(i), values[i]);
  }
}

Outcome MissionFunctions::act(const std::vector<ir::Case>& cases, const z3::expr& word) {
  const Memory before = effects_.first();
  Memory after = before;
  for (auto i = static_cast<uint32_t>(cases.size()); i-- > 0;) {
    const ir::Case& one = cases[i];
    if (one.action.valid() || !one.arguments.empty()) {
      Memory fired = before;
      run(fired, one.action);
      pass(fired, one);
      after = effects_.either(word == effects_.word(i), fired, after);
    }
  }
  return only(after);
}

/// E2 to E5. The context's fields are set already.
Outcome MissionFunctions::enter(ir::StateId id, const z3::expr& word) {
  const ir::State& state = mission_[id];
  const z3::expr entered = word == effects_.word(kGliderEnter);
  const auto onlyIfEntered = [&](Memory& memory, auto then) {
    Memory changed = memory;
    then(changed);
    memory = effects_.either(entered, changed, memory);
  };
  Memory memory = effects_.first();
  onlyIfEntered(memory, [&](Memory& now) {
    for (uint32_t i = 0; i < mission_.variables.size(); ++i) {
      const ir::Variable& variable = mission_.variables[i];
      const bool starts = variable.kind == ir::VariableKind::State ||
                          variable.kind == ir::VariableKind::Profile ||
                          variable.kind == ir::VariableKind::Route;
      if (starts && variable.owner == id) {
        assign(now, {i}, expressions_.asNumber(now, variable.initial));
      }
    }
  });
  for (const ir::TemporalId temporal : temporalsOf(mission_, id)) {
    if (ir::isWindow(mission_[temporal].kind)) {
      onlyIfEntered(memory, [&](Memory& now) { startWindow(now, temporal); });
    }
    watch(memory, temporal, When::Start);
  }
  if (ir::samples(mission_)) {
    sample(memory, state);
  }
  onlyIfEntered(memory, [&](Memory& now) { run(now, state.entry); });
  begin(memory, state.profile, index_.memory_blocks[id.index].profile, word);
  begin(memory, state.route, index_.memory_blocks[id.index].route, word);
  return only(memory);
}

void MissionFunctions::begin(Memory& memory, const ir::Activity& activity, uint32_t block,
                             const z3::expr& phase) {
  if (isInC(mission_, activity)) {
    behaviour(memory, activity, block, phase);
  } else {
    run(memory, activity.entry);
  }
}

void MissionFunctions::behaviour(Memory& memory, const ir::Activity& activity, uint32_t block,
                                 const z3::expr& phase) {
  std::vector<z3::expr> arguments{
      context(), effects_.address(effects_.places().behaviourMemory(block)), phase};
  for (const ir::ExprId argument : activity.arguments) {
    arguments.push_back(expressions_.asNumber(memory, argument));
  }
  code_.command(memory, mission_[activity.behaviour].symbol, arguments);
}

/// Step 3, the part of the state, and S8.
Outcome MissionFunctions::advance(ir::StateId id) {
  Memory memory = effects_.first();
  for (const ir::TemporalId temporal : temporalsOf(mission_, id)) {
    watch(memory, temporal, When::Advance);
  }
  if (ir::samplingChanges(mission_, mission_[id])) {
    sample(memory, mission_[id]);
  }
  return only(memory);
}

/// Step 3, the part of `always`.
Outcome MissionFunctions::advanceAlways() {
  Memory memory = effects_.first();
  for (const ir::TemporalId temporal : temporalsOf(mission_, std::nullopt)) {
    watch(memory, temporal, When::Advance);
  }
  run(memory, mission_.every_tick);
  return only(memory);
}

/// E8.
Outcome MissionFunctions::begin() {
  Memory memory = effects_.first();
  for (uint32_t i = 0; i < mission_.variables.size(); ++i) {
    if (mission_.variables[i].kind == ir::VariableKind::Mission) {
      assign(memory, {i}, expressions_.asNumber(memory, mission_.variables[i].initial));
    }
  }
  for (const ir::TemporalId temporal : temporalsOf(mission_, std::nullopt)) {
    if (ir::isWindow(mission_[temporal].kind)) {
      startWindow(memory, temporal);
    }
    watch(memory, temporal, When::Start);
  }
  run(memory, mission_.every_tick);
  return only(memory);
}

Outcome MissionFunctions::condition() {
  Memory memory = effects_.first();
  InOrder conditions(effects_);
  for (uint32_t i = 0; i < mission_.conditions.size(); ++i) {
    conditions.tryNext(!expressions_.isTrue(memory, mission_.conditions[i]), i, memory);
  }
  return conditions.otherwise(GLIDER_NO_CASE, memory);
}

/// Steps 4 and 5, of a profile or route.
Outcome MissionFunctions::fly(const ir::Activity& activity, uint32_t memory_block) {
  Memory memory = effects_.first();
  if (isInC(mission_, activity)) {
    behaviour(memory, activity, memory_block, effects_.word(kGliderTick));
    return {effects_.word(GLIDER_NO_CASE), memory};
  }
  InOrder cases(effects_);
  for (uint32_t i = 0; i < activity.cases.size(); ++i) {
    const ir::Case& one = activity.cases[i];
    const z3::expr fires = expressions_.isTrue(memory, one.guard);
    Memory fired = memory;
    run(fired, one.action);
    if (one.transition == ir::Transition::Done) {
      assign(fired, activity.done, numbers().constant(1));
    }
    cases.tryNext(fires, i, fired);
  }
  return cases.otherwise(GLIDER_NO_CASE, memory);
}

/// S8.
void MissionFunctions::sample(Memory& memory, const ir::State& state) {
  z3::expr word = numbers().constant(0);
  for (const ir::Sampling& one : state.sampling) {
    const z3::expr weight = numbers().constant(ir::samplingWeight(one.place));
    word = numbers().add(word, numbers().multiply(expressions_.number(memory, one.code), weight));
  }
  code_.command(memory, "gliderSample", {context(), word});
}

}  // namespace glider::codegen::validate
