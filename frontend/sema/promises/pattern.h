// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"
#include "frontend/sema/promises/places.h"
#include "ir/core/monitor_writer.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glider::frontend {

/// A time in a promise.
struct PromiseTime {
  double seconds = 0;
  std::string words;  ///< as written
};

/// What each pattern is written with. It describes one tick in which the promise is watched.
struct Pattern {
  ir::MonitorWriter& monitor;
  Sight sight;
  ir::VariableId
      start;          ///< a clock: when the promise began to be watched; invalid: with the mission
  ir::ExprId over;    ///< from now on it is not watched, and what is owed is not met
  std::string ended;  ///< "the mission ended"

  /// Whether more than this time has passed since the promise began to be watched.
  ir::ExprId late(const PromiseTime& time);
};

void writeVisit(const std::vector<PromisedPlace>& places, ast::Manner manner,
                const PromiseTime& within, Pattern& pattern);
void writePatrol(const std::vector<PromisedPlace>& places, ast::Manner manner,
                 const PromiseTime& every, Pattern& pattern);
/// Each place is visited again only after its successor, round the list.
void writeFairness(const std::vector<PromisedPlace>& places, Pattern& pattern);
/// Each place is visited again only after its predecessor, round the list.
void writeOrder(const std::vector<PromisedPlace>& places, Pattern& pattern);
void writeCount(const PromisedPlace& place, ast::CountBound bound, uint32_t times,
                const PromiseTime& within, Pattern& pattern);
/// `event` is null for Ever.
void writeNever(const PromisedPlace& place, ast::NeverWhen when, const PromisedPlace* event,
                Pattern& pattern);
void writeReaction(const ast::ReactionPromise& node, const PromisedPlace& cause,
                   const PromisedPlace& response, const PromiseTime& time, Pattern& pattern);
void writeHold(const PromisedPlace& place, const PromisedPlace& until, const PromiseTime& within,
               Pattern& pattern);

/// When a promise is watched, as places.
struct PlacedScope {
  ast::ScopeKind kind = ast::ScopeKind::In;
  PromisedPlace place;
  std::optional<PromisedPlace> to;  ///< of FromTo
};
/// Writes what `write` writes, for as long as `scope` says (null: the whole flight). With
/// `or_exit`, what is owed at the end counts as met.
void writeScoped(const PlacedScope* scope, bool or_exit, ir::MonitorWriter& monitor,
                 const std::function<void(Pattern&)>& write);

}  // namespace glider::frontend
