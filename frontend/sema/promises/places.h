// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"
#include "ir/core/monitor_writer.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::frontend {

/// What a promise is about: a state, a condition that may have a name, or both, combined.
struct PromisedPlace {
  std::string words;     ///< as written, in backticks
  ir::StateId state;     ///< invalid: a condition, or combined
  ir::ExprId condition;  ///< invalid: a state, or combined
  /// Combined by `op`, And, Or or Not: `drift && depth > 3 m`. A state counts while it is current
  /// or waits.
  std::vector<PromisedPlace> parts = {};
  ir::Op op = ir::Op::And;

  /// "visited", or of a condition "true".
  [[nodiscard]] const char* visited() const { return state.valid() ? "visited" : "true"; }
  /// "`a` was current or waited", or of a condition "`a` was true".
  [[nodiscard]] std::string wasSo() const {
    return words + (state.valid() ? " was current or waited" : " was true");
  }
};

/// Enters the `place` declarations of a mission. Their conditions are checked where they are used.
void declarePlaces(const ast::File& file, Scope& scope);

/// Whether `expr` combines states or places with something, as only promises may.
bool combinesPlaces(const ast::Expr& expr, const Scope& scope);
/// The place that `expr` names: a state, a `place`, a condition, or states and conditions combined;
/// empty, and reported, if it is none.
std::optional<PromisedPlace> lowerPlace(const ast::Expr& expr, Scope& scope);

/// Checks the conditions of the places that no promise names.
void checkUnusedPlaces(Scope& scope);

/// How a promise sees its places, in one tick. With `on` they are only seen where that is true.
class Sight {
 public:
  Sight(ir::MonitorWriter& monitor, ir::ExprId on) : monitor_(monitor), on_(on) {}

  /// The same condition where the promise is watched: not on the tick after its scope.
  ir::ExprId watched(ir::ExprId condition) { return gated(condition); }
  /// A state that is entered; a condition that is true.
  ir::ExprId visited(const PromisedPlace& place) {
    return gated(now(place, ir::ObservationKind::Entered));
  }
  /// A state that is entered; a condition that becomes true.
  ir::ExprId begins(const PromisedPlace& place);
  /// A state that is current or waits; a condition that is true.
  ir::ExprId holds(const PromisedPlace& place) {
    return gated(now(place, ir::ObservationKind::Inside));
  }
  /// The same where it is certainly false.
  ir::ExprId fails(const PromisedPlace& place) {
    return gated(monitor_.negation(now(place, ir::ObservationKind::Inside)));
  }

 private:
  ir::ExprId now(const PromisedPlace& place, ir::ObservationKind kind);
  ir::ExprId gated(ir::ExprId seen) { return on_.valid() ? monitor_.both(on_, seen) : seen; }

  ir::MonitorWriter& monitor_;
  ir::ExprId on_;
};

}  // namespace glider::frontend
