// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// When the SBC may sleep: ir/README.md, F1 to F5, as ir/eval/foresee.cpp evaluates the tree.

#include "codegen/llvm/validate/mission_functions.h"
#include "runtime/abi/glider_abi.h"
#include "support/check.h"

#include <utility>
#include <vector>

namespace glider::codegen::validate {
namespace {

unsigned firedField(ir::ListKind list) {
  switch (list) {
    case ir::ListKind::Always:
      return field::GliderContext::fired_always;
    case ir::ListKind::State:
      return field::GliderContext::fired_state;
    case ir::ListKind::Profile:
      return field::GliderContext::fired_profile;
    case ir::ListKind::Route:
      return field::GliderContext::fired_route;
  }
  CHECK(false, "a list that a tick does not try");
}

}  // namespace

/// Where the function returns before its end: under which condition, with which memory; no two of
/// these hold.
struct MissionFunctions::EarlyReturns {
  std::vector<std::pair<z3::expr, Memory>> all;
};

Outcome MissionFunctions::foresee(ir::StateId state) {
  const z3::expr nap = effects_.address(effects_.places().object("nap"));
  Memory memory = effects_.first();
  EarlyReturns returns;
  z3::expr open = effects_.truth(true);
  if (mission_.nap_s) {
    const ir::Wake wake = ir::wakeOf(mission_, state);
    if (ir::maySleep(mission_, wake)) {
      add(memory, wake, open, nap, returns);
    }
  }
  for (const auto& [when, then] : returns.all) {
    memory = effects_.either(when, then, memory);
  }
  return only(memory);
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void MissionFunctions::add(Memory& memory, const ir::Wake& wake, z3::expr& open,
                           const z3::expr& nap, EarlyReturns& returns) {
  const auto awakeUnless = [&](const z3::expr& condition) {
    Memory awake = memory;
    code_.command(awake, "gliderNapAwake", {nap});
    returns.all.emplace_back((open && !condition).simplify(), awake);
    open = (open && condition).simplify();
  };
  const auto sensor = [&] { return effects_.word(wake.sensor.index); };
  switch (wake.kind) {
    case ir::WakeKind::Nothing:
      return;
    case ir::WakeKind::Awake:
      return code_.command(memory, "gliderNapAwake", {nap});
    case ir::WakeKind::All:
      for (const ir::Wake& part : wake.parts) {
        add(memory, part, open, nap, returns);
      }
      return;
    case ir::WakeKind::Branch: {
      const z3::expr test = wake.of_false ? expressions_.isFalse(memory, wake.test)
                                          : expressions_.isTrue(memory, wake.test);
      Memory yes = memory;
      Memory no = memory;
      z3::expr open_yes = (open && test).simplify();
      z3::expr open_no = (open && !test).simplify();
      add(yes, wake.parts.at(0), open_yes, nap, returns);
      add(no, wake.parts.at(1), open_no, nap, returns);
      memory = effects_.either(test, yes, no);
      open = (open_yes || open_no).simplify();
      return;
    }
    case ir::WakeKind::Until: {
      const z3::expr right = expressions_.number(memory, wake.right);
      const z3::expr left = expressions_.number(memory, wake.left);
      return code_.command(memory, "gliderNapUntil", {nap, numbers().subtract(right, left)});
    }
    case ir::WakeKind::Crossed:
      return code_.command(memory, "gliderNapCrossed",
                           {nap, context(), sensor(), expressions_.number(memory, wake.right)});
    case ir::WakeKind::Known:
      return code_.command(memory, "gliderNapKnown", {nap, context(), sensor()});
    case ir::WakeKind::Lost:
      return code_.command(memory, "gliderNapLost", {nap, context(), sensor()});
    case ir::WakeKind::Repeats:
      return awakeUnless(effects_.load(memory, effects_.places().context(firedField(wake.list))) ==
                         effects_.word(wake.number));
    case ir::WakeKind::Keeps: {
      const z3::expr becomes =
          wake.right.valid() ? expressions_.asNumber(memory, wake.right) : numbers().constant(1);
      return awakeUnless(numbers().equal(
          effects_.load(memory, effects_.places().variable(wake.variable)), becomes));
    }
  }
}

}  // namespace glider::codegen::validate
