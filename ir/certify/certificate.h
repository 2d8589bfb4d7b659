// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

/// What a certificate of a proof says: an inductive invariant for each call configuration. Shared
/// by the prover, which writes it, and by the rules that check it.
namespace glider::ir::certify {

/// Every case of `always` may fire.
inline constexpr uint32_t kNoLimit = UINT32_MAX;

/// A state on the call stack, with the limit (rule L) that its return restores.
struct Waiting {
  StateId state;
  uint32_t limit = kNoLimit;
  auto operator<=>(const Waiting&) const = default;
};

/// The call configuration between two ticks.
struct Configuration {
  StateId state;
  std::vector<Waiting> stack;  ///< outermost first
  uint32_t limit = kNoLimit;
  bool just_returned = false;
  auto operator<=>(const Configuration&) const = default;
};

/// What an invariant may refer to: a symbol of SMT-LIB.
struct Name {
  std::string text;    ///< in bars: "|time|"
  bool truth = false;  ///< Bool; otherwise Real
  bool operator==(const Name&) const = default;
};

/// All names of a configuration after a tick, before time has passed:
///   |time|                     mission time
///   |entered k|                of the waiting states, outermost first, then of the current state
///   |resumed|                  of the current state
///   |var N|, |var N known|     a variable that has started, if it is a number
///   |var N true|, |var N false|  if it is a truth value; unknown if both are false
///   |was i|, |since i|         `became` or `held` number i, of `always` or the current state:
///   whether
///                              its operand was true when it last advanced or started, and B3's
///                              time
///   |depth|, |deepest|, |climbing|, |climbing since|, |top|  the vehicle (vehicle.h)
///   |after seen|               of a requirement `never S after A`
///   |surfaced|                 of `surfaces every`: mission time when it was last at the surface
/// In N, a bar, a backslash and a byte outside of printable ASCII are `\`-free hexadecimal: `%7C`;
/// so is `%` itself.
std::vector<Name> namesIn(const Mission& mission, const Requirement& requirement,
                          const Configuration& at);

struct Invariant {
  Configuration at;
  std::string formula;  ///< a term of SMT-LIB of sort Bool over namesIn(at)
};

}  // namespace glider::ir::certify
