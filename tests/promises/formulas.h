// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <memory>
#include <vector>

/// Linear temporal logic on a whole flight, evaluated by its definition: what monitors are compared
/// with. Positions are the ticks from the start to the one that ends the mission.
namespace glider::tests::ltl {

/// One tick, as a promise sees it.
struct Tick {
  double time = 0;
  std::vector<bool> entered;  ///< by state: entered on this tick
  std::vector<bool> inside;   ///< by state: current
  int cause = 0;              ///< of a condition: 1 true, 0 false, -1 unknown
  int response = 0;
};
using Flight = std::vector<Tick>;

/// A formula: its value at a position.
using Formula = std::function<bool(const Flight&, size_t)>;

Formula atom(std::function<bool(const Tick&)> is);
Formula no(Formula a);
Formula both(Formula a, Formula b);
Formula either(Formula a, Formula b);
Formula implies(Formula a, Formula b);
/// Strong next: there is a next tick, and `a` holds there.
Formula next(Formula a);
/// Weak next: if there is a next tick, `a` holds there.
Formula weakNext(Formula a);
Formula eventually(Formula a);
Formula globally(Formula a);
/// `a` holds until `b` does, which must happen.
Formula until(Formula a, Formula b);
/// The same, but `b` need not happen.
Formula weakUntil(Formula a, Formula b);
/// `a` holds at a tick not more than `seconds` after this one.
Formula soon(double seconds, Formula a);
/// `a` holds at all ticks not more than `seconds` after this one.
Formula during(double seconds, Formula a);
Formula all(const std::vector<Formula>& formulas);

}  // namespace glider::tests::ltl
