// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/promises/pattern.h"

#include <fmt/format.h>

namespace glider::frontend {

using ir::ExprId;

void writeNever(const PromisedPlace& place, ast::NeverWhen when, const PromisedPlace* event,
                Pattern& pattern) {
  ir::MonitorWriter& m = pattern.monitor;
  const ExprId visited = pattern.sight.visited(place);
  if (event == nullptr) {
    m.violation(visited, place.words + (place.state.valid() ? " was entered" : " was true"));
    return;
  }
  const ir::VariableId seen = m.flag("seen " + event->words);
  const bool before = when == ast::NeverWhen::Before;
  const auto see = [&] { m.when(pattern.sight.visited(*event), [&] { m.set(seen, true); }); };
  // Of two states only one is entered on a tick; a state does not come after its own entry.
  const bool later = !before && place.state.valid() && event->state.valid();
  if (!later) {
    see();
  }
  const ExprId after = m.read(seen);
  m.violation(m.both(visited, before ? m.negation(after) : after),
              fmt::format("{} came {} {}", place.words, before ? "before" : "after", event->words));
  if (later) {
    see();
  }
}

}  // namespace glider::frontend
