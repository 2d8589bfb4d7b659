// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// When the SBC may sleep: ir/README.md, F1 to F5, as ir/eval/foresee.cpp evaluates the tree.

#include "codegen/llvm/validate/mission_functions.h"
#include "runtime/abi/glider_abi.h"
#include "support/check.h"

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

Outcome MissionFunctions::foresee(ir::StateId state) {
  const z3::expr nap = moments_.address(moments_.places().object("nap"));
  Moment moment = moments_.first();
  WaysOut ways(moments_);
  z3::expr open = moments_.truth(true);
  if (mission_.nap_s) {
    const ir::Wake wake = ir::wakeOf(mission_, state);
    if (ir::maySleep(mission_, wake)) {
      add(moment, wake, open, nap, ways);
    }
  }
  ways.add(open, moments_.word(0), moment);
  return ways.together();
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void MissionFunctions::add(Moment& moment, const ir::Wake& wake, z3::expr& open,
                           const z3::expr& nap, WaysOut& ways) {
  const auto awakeUnless = [&](const z3::expr& condition) {
    Moment awake = moment;
    code_.command(awake, "gliderNapAwake", {nap});
    ways.add((open && !condition).simplify(), moments_.word(0), awake);
    open = (open && condition).simplify();
  };
  const auto sensor = [&] { return moments_.word(wake.sensor.index); };
  switch (wake.kind) {
    case ir::WakeKind::Nothing:
      return;
    case ir::WakeKind::Awake:
      return code_.command(moment, "gliderNapAwake", {nap});
    case ir::WakeKind::All:
      for (const ir::Wake& part : wake.parts) {
        add(moment, part, open, nap, ways);
      }
      return;
    case ir::WakeKind::Branch: {
      const z3::expr test = wake.of_false ? expressions_.isFalse(moment, wake.test)
                                          : expressions_.isTrue(moment, wake.test);
      Moment yes = moment;
      Moment no = moment;
      z3::expr open_yes = (open && test).simplify();
      z3::expr open_no = (open && !test).simplify();
      add(yes, wake.parts.at(0), open_yes, nap, ways);
      add(no, wake.parts.at(1), open_no, nap, ways);
      moment = moments_.either(test, yes, no);
      open = (open_yes || open_no).simplify();
      return;
    }
    case ir::WakeKind::Until: {
      const z3::expr right = expressions_.number(moment, wake.right);
      const z3::expr left = expressions_.number(moment, wake.left);
      return code_.command(moment, "gliderNapUntil", {nap, numbers().subtract(right, left)});
    }
    case ir::WakeKind::Crossed:
      return code_.command(moment, "gliderNapCrossed",
                           {nap, context(), sensor(), expressions_.number(moment, wake.right)});
    case ir::WakeKind::Known:
      return code_.command(moment, "gliderNapKnown", {nap, context(), sensor()});
    case ir::WakeKind::Lost:
      return code_.command(moment, "gliderNapLost", {nap, context(), sensor()});
    case ir::WakeKind::Repeats:
      return awakeUnless(moments_.load(moment, moments_.places().context(firedField(wake.list))) ==
                         moments_.word(wake.number));
    case ir::WakeKind::Keeps: {
      const z3::expr becomes =
          wake.right.valid() ? expressions_.asNumber(moment, wake.right) : numbers().constant(1);
      return awakeUnless(numbers().equal(
          moments_.load(moment, moments_.places().variable(wake.variable)), becomes));
    }
  }
}

}  // namespace glider::codegen::validate
