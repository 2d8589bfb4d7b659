// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/truth.h"
#include "ir/verify/path.h"

#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>
#include <set>
#include <vector>

namespace glider::ir {

/// For every expression: true or false if it is so for any values of sensors and clocks; Unknown
/// for everything else.
std::vector<Truth> constantTruths(const Mission& mission);

/// Why a case cannot fire.
enum class Dead : uint8_t { No, AlwaysFalse, Hidden, Proved };

/// A case of `always`, or of a state.
struct CasePlace {
  StateId state;  ///< invalid: of `always`
  uint32_t number = 0;
  auto operator<=>(const CasePlace&) const = default;
};

/// What the live cases of a list can do.
struct Moves {
  std::vector<Edge> edges;              ///< of `always`: `from` means nothing
  std::optional<uint32_t> return_case;  ///< the first
  std::optional<uint32_t> exit_case;
  std::vector<Dead> dead;  ///< of every case

  [[nodiscard]] bool leaves() const { return !edges.empty() || return_case || exit_case; }
};

/// How a state became current: by the start or by a state's `goto`, so that every case of `always`
/// may interrupt it; by a `goto` of `always`, so that only earlier cases may; or by a `call`.
enum class Arrived : uint8_t { Free, Limited, Called };
constexpr Arrived kArrivals[] = {Arrived::Free, Arrived::Limited, Arrived::Called};

struct Place {
  uint32_t state = 0;
  Arrived arrived = Arrived::Free;
};

/// Every case of `always` may fire.
constexpr uint32_t kEndlessLimit = UINT32_MAX;

/// The mission as a pushdown system, where every live case may fire at any tick; ir/README.md, "The
/// checks", says why its results are exact.
class Structure {
 public:
  /// `dead`: cases that the caller knows never to fire.
  explicit Structure(const Mission& mission, const std::set<CasePlace>& dead = {});

  const Mission& mission;
  std::vector<Moves> moves;  ///< of every state
  Moves always;
  std::vector<uint32_t> order;  ///< the reached states, nearest to the start first

  [[nodiscard]] uint32_t size() const { return static_cast<uint32_t>(moves.size()); }
  [[nodiscard]] bool reached(uint32_t state) const;
  /// Whether the place is reached.
  [[nodiscard]] bool at(Place place) const { return arrivals_[index(place)].reached; }
  /// Whether the state can be current with an empty stack.
  [[nodiscard]] bool meetsEmptyStack(uint32_t state) const {
    return at({state, Arrived::Free}) || at({state, Arrived::Limited});
  }
  /// How a state meets an empty stack with the greatest limit.
  [[nodiscard]] Place root(uint32_t state) const {
    return {state, at({state, Arrived::Free}) ? Arrived::Free : Arrived::Limited};
  }
  /// The greatest limit with which the state meets an empty stack; empty: it does not.
  [[nodiscard]] std::optional<uint32_t> rootLimit(uint32_t state) const;
  /// A state, other than these two, that meets an empty stack with a limit above `limit`.
  [[nodiscard]] std::optional<uint32_t> otherRoot(uint32_t limit, uint32_t not_this,
                                                  uint32_t nor_this) const;
  /// Whether the state is one of the three that `otherRoot` chooses from.
  [[nodiscard]] bool highRoot(uint32_t state) const;
  /// The smallest limit with which a reached state can be current.
  [[nodiscard]] uint32_t lowestLimit(uint32_t state) const { return lowest_limit_[state]; }
  /// Whether there is a moment after which nothing ever leaves the reached state.
  [[nodiscard]] bool deadEnd(uint32_t state) const;
  /// How a reached place is reached.
  [[nodiscard]] Path pathTo(Place place) const;
  /// The place of a reached state nearest to the start.
  [[nodiscard]] Place nearest(uint32_t state) const { return {state, nearest_[state]}; }
  /// The case of an edge.
  [[nodiscard]] const Case& caseOf(const Edge& edge) const;

 private:
  struct Arrival {
    bool reached = false;
    Place before;
    std::optional<Edge> edge;  ///< none: the start
    uint32_t steps = 0;        ///< from the start
    Place early;  ///< the place on the way here Path::kFirst steps from the start, or this one
  };

  static size_t index(Place place) {
    return std::size(kArrivals) * place.state + static_cast<size_t>(place.arrived);
  }
  void explore();
  void visit(const Edge& edge, Place before, std::deque<Place>& pending);
  [[nodiscard]] Edge edgeTo(Place place) const;
  void findRoots();
  void findLimits();

  std::vector<Arrival> arrivals_;
  std::vector<Arrived> nearest_;
  std::vector<uint32_t> highest_roots_;  ///< the three that have the greatest limits
  std::vector<uint32_t> limits_;         ///< of states that meet an empty stack with a limit
  std::vector<uint32_t> lowest_limit_;
};

}  // namespace glider::ir
