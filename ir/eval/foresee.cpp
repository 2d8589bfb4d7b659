// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/foresee.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::ir {
namespace {

class Foreseeing {
 public:
  Foreseeing(const Interpreter& interpreter, const TickResult& tick)
      : interpreter_(interpreter), tick_(tick) {}

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  void add(const Wake& wake) {
    switch (wake.kind) {
      case WakeKind::Nothing:
        return;
      case WakeKind::Awake:
        found.awake = true;
        return;
      case WakeKind::All:
        add(wake.parts[0]);
        return add(wake.parts[1]);
      case WakeKind::Branch: {
        const Truth wanted = wake.of_false ? Truth::False : Truth::True;
        return add(wake.parts[interpreter_.truthOf(wake.test) == wanted ? 0 : 1]);
      }
      case WakeKind::Until:
        return until(interpreter_.number(wake.right) - interpreter_.number(wake.left));
      case WakeKind::Crossed:
        return cross(wake);
      case WakeKind::Known:
      case WakeKind::Lost:
        return cause(wake, 0);
      case WakeKind::Repeats:
        found.awake |=
            tick_.fired.at(static_cast<size_t>(wake.list)).value_or(Wake::kNoCase) != wake.number;
        return;
      case WakeKind::Keeps:
        found.awake |= !keeps(wake);
        return;
    }
  }

  Foreseen found;

 private:
  void until(double seconds) {
    if (seconds >= 0) {
      found.seconds = std::min(found.seconds, seconds);
    }
  }

  void cross(const Wake& wake) {
    const double number = interpreter_.number(wake.right);
    if (!std::isnan(number)) {
      cause(wake, number);
    }
  }

  void cause(const Wake& wake, double number) {
    found.causes.push_back({wake.kind, wake.sensor, number});
  }

  [[nodiscard]] bool keeps(const Wake& wake) const {
    const double becomes = wake.right.valid() ? asNumber(interpreter_.evaluate(wake.right)) : 1.0;
    return interpreter_.value(wake.variable) == becomes;
  }

  const Interpreter& interpreter_;
  const TickResult& tick_;
};

}  // namespace

Foreseen foresee(const Interpreter& interpreter, const Wake& wake, const TickResult& tick) {
  Foreseeing foreseeing(interpreter, tick);
  foreseeing.add(wake);
  return std::move(foreseeing.found);
}

}  // namespace glider::ir
