// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/promises/pattern.h"

#include <fmt/format.h>

namespace glider::frontend {

using ir::ExprId;

void writeHold(const PromisedPlace& place, const PromisedPlace& until, const PromiseTime& within,
               Pattern& pattern) {
  ir::MonitorWriter& m = pattern.monitor;
  const ir::VariableId released = m.flag("released");
  const ExprId late = pattern.late(within);
  m.when(m.both(m.negation(late), pattern.sight.holds(until)), [&] { m.set(released, true); });
  const auto waiting = [&] { return m.negation(m.read(released)); };
  m.violation(m.both(waiting(), pattern.sight.fails(place)),
              fmt::format("{} did not hold until {}", place.words, until.words));
  m.violation(m.both(waiting(), late),
              fmt::format("{} had passed without {}", within.words, until.words));
  m.violation(m.both(waiting(), pattern.over),
              fmt::format("{} without {}", pattern.ended, until.words));
}

}  // namespace glider::frontend
