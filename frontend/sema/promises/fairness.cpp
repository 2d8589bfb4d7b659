// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/promises/pattern.h"

#include <fmt/format.h>

namespace glider::frontend {
namespace {

/// PromisedPlace i waits after a visit until place `awaited(i)` is visited, and must not be visited
/// before. From the start, those wait for which `waits` is true.
void writeWaits(const std::vector<PromisedPlace>& places,
                const std::function<size_t(size_t)>& awaited,
                const std::function<bool(size_t)>& waits, Pattern& pattern) {
  ir::MonitorWriter& monitor = pattern.monitor;
  std::vector<ir::VariableId> waiting;
  for (size_t i = 0; i < places.size(); ++i) {
    waiting.push_back(monitor.flag("waiting " + places[i].words, waits(i)));
  }
  for (size_t i = 0; i < places.size(); ++i) {
    monitor.when(pattern.sight.visited(places[awaited(i)]),
                 [&] { monitor.set(waiting[i], false); });
  }
  for (size_t i = 0; i < places.size(); ++i) {
    const ir::ExprId begins = monitor.isTrue(pattern.sight.begins(places[i]));
    monitor.violation(monitor.both(begins, monitor.read(waiting[i])),
                      fmt::format("{} was visited {}before {}", places[i].words,
                                  waits(i) ? "" : "again ", places[awaited(i)].words));
    monitor.when(begins, [&] { monitor.set(waiting[i], true); });
  }
}

}  // namespace

void writeFairness(const std::vector<PromisedPlace>& places, Pattern& pattern) {
  const size_t count = places.size();
  writeWaits(
      places, [&](size_t i) { return (i + 1) % count; }, [](size_t) { return false; }, pattern);
}

void writeOrder(const std::vector<PromisedPlace>& places, Pattern& pattern) {
  const size_t count = places.size();
  writeWaits(
      places, [&](size_t i) { return (i + count - 1) % count; }, [](size_t i) { return i > 0; },
      pattern);
}

}  // namespace glider::frontend
