// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/promises/pattern.h"

namespace glider::frontend {
namespace {

using ir::ExprId;
using ir::ObservationKind;

/// Whether the promise is watched on this tick. `monitor` keeps what has happened before.
ExprId watchedNow(const PlacedScope& scope, ir::MonitorWriter& monitor) {
  Sight sight(monitor, {});
  switch (scope.kind) {
    case ast::ScopeKind::In:
      return monitor.isTrue(sight.holds(scope.place));
    case ast::ScopeKind::Outside:
      return monitor.isTrue(sight.fails(scope.place));
    case ast::ScopeKind::Before:
    case ast::ScopeKind::After: {
      const ir::VariableId seen = monitor.flag("seen");
      monitor.when(sight.visited(scope.place), [&] { monitor.set(seen, true); });
      const ExprId after = monitor.read(seen);
      return scope.kind == ast::ScopeKind::After ? after : monitor.negation(after);
    }
    case ast::ScopeKind::FromTo:
      break;
  }
  const ir::VariableId open = monitor.flag("open");
  monitor.when(sight.visited(scope.place), [&] { monitor.set(open, true); });
  monitor.when(sight.visited(*scope.to), [&] { monitor.set(open, false); });
  return monitor.read(open);
}

}  // namespace

ExprId Pattern::late(const PromiseTime& time) {
  monitor.longest(time.seconds);
  if (start.valid()) {
    return monitor.passed(start, time.seconds);
  }
  const ir::Type type = quantity(support::dimension::time);
  const ExprId now = monitor.now();
  return monitor.operation(ir::Op::Greater, boolean(), {now, monitor.number(time.seconds, type)});
}

void writeScoped(const PlacedScope* scope, bool or_exit, ir::MonitorWriter& monitor,
                 const std::function<void(Pattern&)>& write) {
  if (scope == nullptr) {
    const ExprId over = or_exit ? monitor.truth(false) : monitor.observed(ObservationKind::Ended);
    Pattern pattern{monitor, Sight(monitor, {}), {}, over, "the mission ended"};
    write(pattern);
    monitor.runAtEnd();
    return;
  }
  // Of the promise, and set to their first values each time that it begins to be watched.
  const ir::VariableId on = monitor.momentary("on");
  ir::VariableId start;
  ir::BlockId reset;
  const ir::BlockId body = monitor.blockOf([&] {
    start = monitor.clock("start");
    const ExprId closed = monitor.negation(monitor.read(on));
    const ExprId ended = monitor.observed(ObservationKind::Ended);
    const ExprId over =
        or_exit ? monitor.both(closed, monitor.negation(ended)) : monitor.either(closed, ended);
    Pattern pattern{monitor, Sight(monitor, monitor.read(on)), start, over,
                    "the time in which it is required ended"};
    write(pattern);
    monitor.runAtEnd();
    reset = monitor.blockOf([&] { monitor.reset(); });
  });
  const ir::VariableId was = monitor.flag("was");
  const ExprId watched = watchedNow(*scope, monitor);
  monitor.when(watched, [&] { monitor.set(on, true); });
  monitor.run(monitor.both(monitor.read(on), monitor.negation(monitor.read(was))), reset);
  monitor.run(monitor.either(monitor.read(on), monitor.read(was)), body);
  monitor.set(was, monitor.read(on));
}

}  // namespace glider::frontend
