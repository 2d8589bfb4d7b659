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

z3::expr MissionFunctions::time(const Moment& moment) {
  return moments_.load(moment, moments_.places().context(field::GliderContext::mission_time));
}

/// Step 4 and C5. Guards of `always` are not evaluated from the limit on where that can be seen, by
/// a function that is called; otherwise the runtime looks at the limit.
Outcome MissionFunctions::guards(const std::vector<ir::Case>& cases, bool always,
                                 const z3::expr& word) {
  const bool limited = always && !mission_.uses.empty();
  Moment moment = moments_.first();
  WaysOut ways(moments_);
  z3::expr open = moments_.truth(true);
  for (uint32_t i = 0; i < cases.size(); ++i) {
    if (limited) {
      const z3::expr limit =
          moments_.load(moment, moments_.places().context(field::GliderContext::limit));
      const z3::expr over = z3::ule(limit, moments_.word(i));
      ways.add((open && over).simplify(), moments_.word(GLIDER_NO_CASE), moment);
      open = (open && !over).simplify();
    }
    const z3::expr fires =
        z3::ule(word, moments_.word(i)) && expressions_.isTrue(moment, cases[i].guard);
    ways.add((open && fires).simplify(), moments_.word(i), moment);
    open = (open && !fires).simplify();
  }
  ways.add(open, moments_.word(GLIDER_NO_CASE), moment);
  return ways.together();
}

/// All arguments are evaluated before any parameter gets one.
void MissionFunctions::pass(Moment& moment, const ir::Case& fired) {
  std::vector<z3::expr> values;
  for (const ir::ExprId argument : fired.arguments) {
    values.push_back(expressions_.asNumber(moment, argument));
  }
  for (size_t i = 0; i < values.size(); ++i) {
    assign(moment, mission_[fired.target].parameters.at(i), values[i]);
  }
}

Outcome MissionFunctions::act(const std::vector<ir::Case>& cases, const z3::expr& word) {
  const Moment before = moments_.first();
  Moment after = before;
  for (uint32_t i = 0; i < cases.size(); ++i) {
    Moment fired = before;
    run(fired, cases[i].action);
    pass(fired, cases[i]);
    after = moments_.either(word == moments_.word(i), fired, after);
  }
  return only(after);
}

/// E2 to E5. The context's fields are set already.
Outcome MissionFunctions::enter(ir::StateId id, const z3::expr& word) {
  const ir::State& state = mission_[id];
  const z3::expr entered = word == moments_.word(kGliderEnter);
  const auto onlyIfEntered = [&](Moment& moment, auto then) {
    Moment changed = moment;
    then(changed);
    moment = moments_.either(entered, changed, moment);
  };
  Moment moment = moments_.first();
  onlyIfEntered(moment, [&](Moment& now) {
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
      onlyIfEntered(moment, [&](Moment& now) { startWindow(now, {i}); });
    }
    watch(moment, {i}, When::Start);
  }
  if (ir::samples(mission_)) {
    sample(moment, state);
  }
  onlyIfEntered(moment, [&](Moment& now) { run(now, state.entry); });
  begin(moment, state.profile, index_.memory_blocks[id.index].profile, word);
  begin(moment, state.route, index_.memory_blocks[id.index].route, word);
  return only(moment);
}

void MissionFunctions::begin(Moment& moment, const ir::Activity& activity, uint32_t block,
                             const z3::expr& phase) {
  if (isInC(mission_, activity)) {
    behaviour(moment, activity, block, phase);
  } else {
    run(moment, activity.entry);
  }
}

void MissionFunctions::behaviour(Moment& moment, const ir::Activity& activity, uint32_t block,
                                 const z3::expr& phase) {
  std::vector<z3::expr> arguments{
      context(), moments_.address(moments_.places().behaviourMemory(block)), phase};
  for (const ir::ExprId argument : activity.arguments) {
    arguments.push_back(expressions_.asNumber(moment, argument));
  }
  code_.command(moment, mission_[activity.behaviour].symbol, arguments);
}

/// Step 3, the part of the state, and S8.
Outcome MissionFunctions::advance(ir::StateId id) {
  Moment moment = moments_.first();
  for (uint32_t i = 0; i < mission_.temporals.size(); ++i) {
    const ir::Temporal& temporal = mission_.temporals[i];
    if (temporal.list != ir::ListKind::Always && temporal.state == id) {
      watch(moment, {i}, When::Advance);
    }
  }
  if (ir::samplingChanges(mission_, mission_[id])) {
    sample(moment, mission_[id]);
  }
  return only(moment);
}

/// Step 3, the part of `always`.
Outcome MissionFunctions::advanceAlways() {
  Moment moment = moments_.first();
  for (uint32_t i = 0; i < mission_.temporals.size(); ++i) {
    if (mission_.temporals[i].list == ir::ListKind::Always) {
      watch(moment, {i}, When::Advance);
    }
  }
  run(moment, mission_.every_tick);
  return only(moment);
}

/// E8.
Outcome MissionFunctions::begin() {
  Moment moment = moments_.first();
  for (uint32_t i = 0; i < mission_.variables.size(); ++i) {
    if (mission_.variables[i].kind == ir::VariableKind::Mission) {
      assign(moment, {i}, expressions_.asNumber(moment, mission_.variables[i].initial));
    }
  }
  for (uint32_t i = 0; i < mission_.temporals.size(); ++i) {
    const ir::Temporal& temporal = mission_.temporals[i];
    if (temporal.list != ir::ListKind::Always) {
      continue;
    }
    if (ir::isWindow(temporal.kind)) {
      startWindow(moment, {i});
    }
    watch(moment, {i}, When::Start);
  }
  run(moment, mission_.every_tick);
  return only(moment);
}

Outcome MissionFunctions::condition() {
  Moment moment = moments_.first();
  WaysOut ways(moments_);
  z3::expr open = moments_.truth(true);
  for (uint32_t i = 0; i < mission_.conditions.size(); ++i) {
    const z3::expr holds = expressions_.isTrue(moment, mission_.conditions[i]);
    ways.add((open && !holds).simplify(), moments_.word(i), moment);
    open = (open && holds).simplify();
  }
  ways.add(open, moments_.word(GLIDER_NO_CASE), moment);
  return ways.together();
}

/// Steps 4 and 5, of a profile or route.
Outcome MissionFunctions::fly(const ir::Activity& activity, uint32_t memory_block) {
  Moment moment = moments_.first();
  if (isInC(mission_, activity)) {
    behaviour(moment, activity, memory_block, moments_.word(kGliderTick));
    return {moments_.word(GLIDER_NO_CASE), moment};
  }
  WaysOut ways(moments_);
  z3::expr open = moments_.truth(true);
  for (uint32_t i = 0; i < activity.cases.size(); ++i) {
    const ir::Case& one = activity.cases[i];
    const z3::expr fires = expressions_.isTrue(moment, one.guard);
    Moment fired = moment;
    run(fired, one.action);
    if (one.transition == ir::Transition::Done) {
      assign(fired, activity.done, numbers().constant(1));
    }
    ways.add((open && fires).simplify(), moments_.word(i), fired);
    open = (open && !fires).simplify();
  }
  ways.add(open, moments_.word(GLIDER_NO_CASE), moment);
  return ways.together();
}

/// S8.
void MissionFunctions::sample(Moment& moment, const ir::State& state) {
  z3::expr word = numbers().constant(0);
  for (const ir::Sampling& one : state.sampling) {
    const z3::expr weight = numbers().constant(ir::samplingWeight(one.place));
    word = numbers().add(word, numbers().multiply(expressions_.number(moment, one.code), weight));
  }
  code_.command(moment, "gliderSample", {context(), word});
}

}  // namespace glider::codegen::validate
