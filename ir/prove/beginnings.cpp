// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/orders.h"
#include "ir/prove/passes.h"

#include <algorithm>
#include <set>
#include <utility>

namespace glider::ir::prove {
namespace {

/// An order stays in force until the next one, so what every profile and route orders when it
/// begins makes sure that each tick leaves pitch, pump and heading commanded.
class BeginningCheck {
 public:
  explicit BeginningCheck(Proof& proof) : proof_(proof), m_(proof.ground.mission) {}

  void run() {
    for (const State& state : m_.states) {
      check(state.profile, true, "this profile", "neither depth nor pitch");
      check(state.route, false, "this route", "no heading");
    }
  }

 private:
  void check(const Activity& activity, bool vertical, const char* who, const char* what) {
    const bool in_c = !m_[activity.behaviour].symbol.empty();
    if (in_c || orders(activity.entry, vertical)) {
      return;
    }
    if (told_.emplace(activity.range.file, activity.range.begin).second) {
      proof_.diagnostics.report(support::DiagnosticId::nothingOrdered, activity.range, who, what);
    }
  }

  /// Whether every way through the block gives an order.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] bool orders(BlockId block, bool vertical) const {
    if (!block.valid()) {
      return false;
    }
    return std::ranges::any_of(m_[block].statements, [&](const Statement& statement) {
      if (statement.kind == StatementKind::Command) {
        return isVertical(statement.command) == vertical;
      }
      // An unknown condition takes neither branch.
      return statement.kind == StatementKind::If &&
             proof_.ground.known.expressions[statement.value.index] &&
             orders(statement.then, vertical) && orders(statement.otherwise, vertical);
    });
  }

  Proof& proof_;
  const Mission& m_;
  std::set<std::pair<uint32_t, uint32_t>> told_;
};

}  // namespace

void passes::beginnings(Proof& proof) {
  BeginningCheck(proof).run();
}

}  // namespace glider::ir::prove
