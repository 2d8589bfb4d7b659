// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/control.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace glider::ir::prove {

/// Where a trace can be, for a search over the ways from place to place. A place is a state as
/// entered, or a state as resumed.
///
/// Of states alone, stacks are not followed: what a state returns to is a place of its own, from
/// which every state goes on that may wait for it; and a case of `always` may fire in every state
/// but its target and those whose greatestLimits exclude it.
///
/// Of configurations, each state is a place of its own for each stack below it, so `return` leads
/// to where the call came from, and a case of `always` fires only where L1 to L4 let it.
class SurfacingPlaces {
 public:
  static SurfacingPlaces ofStates(const Mission& mission);
  static SurfacingPlaces ofConfigurations(const Mission& mission);

  /// That of the start.
  [[nodiscard]] size_t start() const { return 0; }
  /// So far: the places of configurations are found on the way.
  [[nodiscard]] size_t size() const;
  /// Whether a state is current there; else it is what a state returns to.
  [[nodiscard]] bool isState(size_t at) const { return exact_ || at < 2 * count_; }
  [[nodiscard]] uint32_t stateOf(size_t at) const;
  /// Whether it is a state as resumed.
  [[nodiscard]] bool isAgain(size_t at) const;
  [[nodiscard]] bool mayInterrupt(size_t at, size_t always_case) const;
  /// Where goto, call or return by a case leads; none: no trace does that.
  std::optional<size_t> ledTo(size_t at, ListKind list, size_t number);
  /// The states that go on from what a state returns to.
  [[nodiscard]] std::vector<size_t> goingOn(size_t at) const;

  /// Of states: the place of one as entered or resumed.
  [[nodiscard]] size_t ofState(size_t state, bool again) const {
    return again ? count_ + state : state;
  }
  /// Whether they are of configurations.
  [[nodiscard]] bool areExact() const { return exact_; }
  /// Of configurations: the control there.
  [[nodiscard]] const Control& controlAt(size_t at) const { return exact_places_[at].first; }

 private:
  SurfacingPlaces(const Mission& mission, bool exact);
  size_t idOf(Control control);
  void addCaller(const Case& c, uint32_t state);
  [[nodiscard]] bool mayInterruptState(uint32_t state, size_t always_case) const;

  const Mission* mission_;
  size_t count_;
  bool exact_;
  std::vector<size_t> limits_;                  ///< of each state
  std::vector<std::vector<uint32_t>> callers_;  ///< of each state
  std::vector<std::pair<Control, bool>> exact_places_;
  std::map<std::pair<Control, bool>, size_t> ids_;
};

}  // namespace glider::ir::prove
