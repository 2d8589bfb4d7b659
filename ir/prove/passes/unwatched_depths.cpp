// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `unwatchedDepths`: states that command pump or battery although no case that may fire
// while they last reads a depth (GL3143). In: the commands of each state, and the sensors that the
// guards of its cases, of its profile and route, and of `always` read. Not reported: a state whose
// pump is always out. A hint: a case by the clock may be soon enough.

#include "ir/core/walk.h"
#include "ir/prove/abstract/held_ranges.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace glider::ir::prove {
namespace {

/// What shows how deep the vehicle is, or how near the bottom.
constexpr std::array<std::string_view, 7> kShowDepth = {
    "m_depth",      "m_pressure",   "m_altitude", "m_water_depth", "sci_water_pressure",
    "m_depth_rate", "m_depth_state"};

class DepthWatchCheck {
 public:
  explicit DepthWatchCheck(Proof& proof) : proof_(proof), m_(proof.proof_context.mission) {}

  void run() {
    const bool always = watches(m_.always);
    for (const State& state : m_.states) {
      if (!always && !inC(state) && maySink(state) && !watched(state)) {
        proof_.diagnostics.report(support::diagnostics::depthUnwatched, state.profile.range,
                                  state.name);
      }
    }
  }

 private:
  /// Code in C may do anything about the depth.
  [[nodiscard]] bool inC(const State& state) const {
    return !m_[state.profile.behaviour].symbol.empty() || !m_[state.route.behaviour].symbol.empty();
  }

  /// Whether it may command a pump that is not out, or a battery without a pump.
  [[nodiscard]] bool maySink(const State& state) {
    bool moves = false;
    bool lifts = false;
    for (const Statement* command : commandsOf(m_, state)) {
      moves = moves || movesActuators(command->command);
      if (command->command == Command::Pump) {
        const Interval& volume = held(command->values.at(0));
        if (!volume.empty && volume.lowest <= 0) {
          return true;
        }
        lifts = true;
      }
    }
    return moves && !lifts;
  }

  /// The range of an expression; few missions command the pump.
  const Interval& held(ExprId id) {
    if (held_.empty()) {
      held_ = heldIntervals(m_);
    }
    return held_[id.index];
  }

  [[nodiscard]] bool watched(const State& state) const {
    return watches(state.cases) || watches(state.profile.cases) || watches(state.route.cases);
  }

  [[nodiscard]] bool watches(const std::vector<Case>& cases) const {
    return std::ranges::any_of(cases, [&](const Case& c) { return readsDepth(c.guard); });
  }

  [[nodiscard]] bool readsDepth(ExprId guard) const {
    bool found = false;
    forEachIn(m_, guard, [&](const Expr& e) {
      found =
          found || (e.sensor.valid() &&
                    std::ranges::find(kShowDepth, m_[e.sensor].vehicle_name) != kShowDepth.end());
    });
    return found;
  }

  Proof& proof_;
  const Mission& m_;
  std::vector<Interval> held_;  ///< of every expression, once one is needed
};

}  // namespace

void passes::unwatchedDepths(Proof& proof) {
  DepthWatchCheck(proof).run();
}

}  // namespace glider::ir::prove
