// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace glider::ir {

/// Why a case cannot fire.
enum class Dead : uint8_t { No, AlwaysFalse, Hidden };

/// A `goto` or `call` that can fire.
struct Edge {
  uint32_t from = 0;
  uint32_t case_index = 0;
  uint32_t to = 0;
  bool call = false;
};

/// What the live cases of a state can do.
struct Moves {
  std::vector<Edge> edges;
  std::optional<uint32_t> return_case;  ///< the first
  std::optional<uint32_t> exit_case;
  std::vector<Dead> dead;  ///< of every case

  [[nodiscard]] bool leaves() const { return !edges.empty() || return_case || exit_case; }
};

/// A state together with whether it was entered with an empty call stack (at the start or by
/// `goto`) or by `call`.
struct Place {
  uint32_t state = 0;
  bool called = false;
};

/// The mission as a pushdown system, where every live case may fire at any tick.
///
/// What makes the checks exact and linear: between a call and its return only the called state
/// itself is ever current at that height of the stack, for a `goto` throws the stack away and a
/// `return` comes back to it. So a state is reached exactly if a path of gotos and calls leads to
/// it; it meets an empty stack exactly if it is the first or a reached state goes to it; and the
/// stacks that can lie under a state are exactly the chains of calls from a state that meets an
/// empty stack.
class Structure {
 public:
  explicit Structure(const Mission& mission);

  const Mission& mission;
  std::vector<Moves> moves;     ///< of every state
  std::vector<uint32_t> order;  ///< the reached states, nearest to the start first

  [[nodiscard]] uint32_t size() const { return static_cast<uint32_t>(moves.size()); }
  [[nodiscard]] bool reached(uint32_t state) const {
    return at({state, false}) || at({state, true});
  }
  /// Whether the place is reached.
  [[nodiscard]] bool at(Place place) const { return arrivals_[index(place)].reached; }
  /// How a reached place is reached with the fewest transitions, the first of them first.
  [[nodiscard]] std::vector<Edge> pathTo(Place place) const;
  /// The reached one of a reached state's two places that is nearer to the start.
  [[nodiscard]] Place nearest(uint32_t state) const { return {state, nearest_called_[state]}; }

 private:
  struct Arrival {
    bool reached = false;
    Place before;
    std::optional<Edge> edge;  ///< none: the start
  };

  static size_t index(Place place) { return 2 * size_t{place.state} + (place.called ? 1 : 0); }
  void explore();

  std::vector<Arrival> arrivals_;
  std::vector<bool> nearest_called_;
};

}  // namespace glider::ir
