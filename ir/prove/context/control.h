// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/certificate.h"
#include "ir/core/mission.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace glider::ir::prove {

/// The part of a running mission that is not a number: the current state, the waiting states, and
/// the cases of `always` that may interrupt. There are finitely many.
struct Control {
  static constexpr uint32_t kNoLimit = UINT32_MAX;

  struct Waiting {
    StateId state;
    uint32_t limit = kNoLimit;
    auto operator<=>(const Waiting&) const = default;
  };

  StateId state;
  std::vector<Waiting> stack;  ///< outermost first
  uint32_t limit = kNoLimit;
  bool just_returned = false;
  auto operator<=>(const Control&) const = default;

  [[nodiscard]] bool holds(StateId wanted) const;
  [[nodiscard]] bool mayInterrupt(const Mission& mission, uint32_t always_case) const;
  /// The control after goto, call or return by case `number` of `list`, which is `c`.
  [[nodiscard]] Control moved(ListKind list, uint32_t number, const Case& c) const;
};

/// Whether nothing is ever called from the state, by a case of its own or of `always`: it is then
/// never resumed, and `resumetime` is `statetime`.
bool isNeverResumed(const Mission& mission, StateId state);
/// Whether a state is entered as the first of the mission and never again: its `statetime` is the
/// mission time.
bool isEnteredOnlyAtStart(const Mission& mission, StateId state);

/// A control as certificates have it.
certify::Configuration configurationOf(const Control& control);

}  // namespace glider::ir::prove
