// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/control.h"

#include <algorithm>

namespace glider::ir::prove {

bool Control::holds(StateId wanted) const {
  return state == wanted ||
         std::ranges::any_of(stack, [&](const Waiting& w) { return w.state == wanted; });
}

bool Control::mayInterrupt(const Mission& mission, uint32_t always_case) const {
  const Case& c = mission.always[always_case];
  return always_case < limit && !(c.target.valid() && holds(c.target));
}

}  // namespace glider::ir::prove
