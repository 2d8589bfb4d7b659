// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/control.h"
#include "ir/prove/context/state_bounds.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace glider::ir::prove {

/// The states that a question follows, with what they call. Where none of them is current or waits,
/// the mission may do anything at any time, within what is known of every state: a smaller
/// question, which says nothing about what is possible.
struct Scope {
  std::vector<bool> follows;  ///< by state
  /// Stands for all controls that are not followed; with `just_returned` for those of them on whose
  /// next tick a state's own cases come before those of `always`.
  Control elsewhere;
  std::vector<Control> entered;         ///< those with which a state that is followed is entered
  std::vector<Control> others;          ///< those for which `elsewhere` stands
  bool fine = false;                    ///< variables, clocks and depths are followed too
  std::span<const StateBounds> bounds;  ///< of every state
  double deepest = 0;                   ///< upper bound of the true depth elsewhere, m
  /// The first cases of `always`, which read only what a tick brings: elsewhere the first of them
  /// that is true fires, but not just after a return.
  std::vector<uint32_t> sure = {};
  /// Guards of which one is true on a tick that ends the mission elsewhere; none: any tick may.
  std::optional<std::vector<ExprId>> exits = {};
  bool returns = false;        ///< a state that is resumed elsewhere may put `always` off
  bool returns_again = false;  ///< by returning on its next tick

  [[nodiscard]] bool holds(const Control& control) const {
    return follows[control.state.index] ||
           std::ranges::any_of(control.stack, [&](const Control::Waiting& waiting) {
             return follows[waiting.state.index];
           });
  }
  /// Whether a control is followed whose state only climbs: of others no command is kept.
  [[nodiscard]] bool climbs(const Control& control) const {
    return holds(control) && bounds[control.state.index].climbs;
  }
};

}  // namespace glider::ir::prove
