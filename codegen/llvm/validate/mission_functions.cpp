// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/mission_functions.h"

#include "ir/core/sampling.h"
#include "runtime/abi/glider_abi.h"

namespace glider::codegen::validate {
namespace {

bool isInC(const ir::Mission& mission, const ir::Activity& activity) {
  return !mission[activity.behaviour].symbol.empty();
}

}  // namespace

z3::expr MissionFunctions::time(const Memory& memory) {
  return effects_.load(memory, effects_.places().context(field::GliderContext::mission_time));
}

/// Step 4 and C5. Guards of `always` are not evaluated from the limit on where that can be seen, by
/// a function that is called; otherwise the runtime looks at the limit.
Outcome MissionFunctions::guards(const std::vector<ir::Case>& cases, bool always,
                                 const z3::expr& word) {
  const bool limited = always && !mission_.uses.empty();
  Memory memory = effects_.first();
  WaysOut ways(effects_);
  z3::expr open = effects_.truth(true);
  for (uint32_t i = 0; i < cases.size(); ++i) {
    if (limited) {
      const z3::expr limit =
          effects_.load(memory, effects_.places().context(field::GliderContext::limit));
      const z3::expr over = z3::ule(limit, effects_.word(i));
      ways.add((open && over).simplify(), effects_.word(GLIDER_NO_CASE), memory);
      open = (open && !over).simplify();
    }
    const z3::expr fires =
        z3::ule(word, effects_.word(i)) && expressions_.isTrue(memory, cases[i].guard);
    ways.add((open && fires).simplify(), effects_.word(i), memory);
    open = (open && !fires).simplify();
  }
  ways.add(open, effects_.word(GLIDER_NO_CASE), memory);
  return ways.together();
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
  for (uint32_t i = 0; i < cases.size(); ++i) {
    Memory fired = before;
    run(fired, cases[i].action);
    pass(fired, cases[i]);
    after = effects_.either(word == effects_.word(i), fired, after);
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
  for (uint32_t i = 0; i < mission_.temporals.size(); ++i) {
    const ir::Temporal& temporal = mission_.temporals[i];
    if (temporal.list == ir::ListKind::Always || temporal.state != id) {
      continue;
    }
    if (ir::isWindow(temporal.kind)) {
      onlyIfEntered(memory, [&](Memory& now) { startWindow(now, {i}); });
    }
    watch(memory, {i}, When::Start);
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
  for (uint32_t i = 0; i < mission_.temporals.size(); ++i) {
    const ir::Temporal& temporal = mission_.temporals[i];
    if (temporal.list != ir::ListKind::Always && temporal.state == id) {
      watch(memory, {i}, When::Advance);
    }
  }
  if (ir::samplingChanges(mission_, mission_[id])) {
    sample(memory, mission_[id]);
  }
  return only(memory);
}

/// Step 3, the part of `always`.
Outcome MissionFunctions::advanceAlways() {
  Memory memory = effects_.first();
  for (uint32_t i = 0; i < mission_.temporals.size(); ++i) {
    if (mission_.temporals[i].list == ir::ListKind::Always) {
      watch(memory, {i}, When::Advance);
    }
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
  for (uint32_t i = 0; i < mission_.temporals.size(); ++i) {
    const ir::Temporal& temporal = mission_.temporals[i];
    if (temporal.list != ir::ListKind::Always) {
      continue;
    }
    if (ir::isWindow(temporal.kind)) {
      startWindow(memory, {i});
    }
    watch(memory, {i}, When::Start);
  }
  run(memory, mission_.every_tick);
  return only(memory);
}

Outcome MissionFunctions::condition() {
  Memory memory = effects_.first();
  WaysOut ways(effects_);
  z3::expr open = effects_.truth(true);
  for (uint32_t i = 0; i < mission_.conditions.size(); ++i) {
    const z3::expr holds = expressions_.isTrue(memory, mission_.conditions[i]);
    ways.add((open && !holds).simplify(), effects_.word(i), memory);
    open = (open && holds).simplify();
  }
  ways.add(open, effects_.word(GLIDER_NO_CASE), memory);
  return ways.together();
}

/// Steps 4 and 5, of a profile or route.
Outcome MissionFunctions::fly(const ir::Activity& activity, uint32_t memory_block) {
  Memory memory = effects_.first();
  if (isInC(mission_, activity)) {
    behaviour(memory, activity, memory_block, effects_.word(kGliderTick));
    return {effects_.word(GLIDER_NO_CASE), memory};
  }
  WaysOut ways(effects_);
  z3::expr open = effects_.truth(true);
  for (uint32_t i = 0; i < activity.cases.size(); ++i) {
    const ir::Case& one = activity.cases[i];
    const z3::expr fires = expressions_.isTrue(memory, one.guard);
    Memory fired = memory;
    run(fired, one.action);
    if (one.transition == ir::Transition::Done) {
      assign(fired, activity.done, numbers().constant(1));
    }
    ways.add((open && fires).simplify(), effects_.word(i), fired);
    open = (open && !fires).simplify();
  }
  ways.add(open, effects_.word(GLIDER_NO_CASE), memory);
  return ways.together();
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
