// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <compare>
#include <map>
#include <optional>
#include <vector>

namespace glider::ir::opt {

/// A sensor or clock that guards compare with constants.
struct Watched {
  Op source = Op::MissionTime;
  SensorId sensor;
  auto operator<=>(const Watched&) const = default;
};

/// Where a number must lie: past `above`, not past `below`; or unknown. With neither it must be
/// known.
struct Bounds {
  std::optional<Cut> above;
  std::optional<Cut> below;
  bool unknown = false;
};

/// Bounds that must all hold.
struct Conjunction {
  std::map<Watched, Bounds> bounds;
  bool exact = true;    ///< false: the guard requires more than the bounds
  uint32_t number = 0;  ///< for the caller
};

/// A guard in disjunctive normal form: it is true exactly if one of these holds. One that is not
/// exact stands for "its bounds hold and the guard is true". True is meant as for a guard: unknown
/// is not true.
std::vector<Conjunction> disjunctionOf(const Mission& mission, ExprId guard);

}  // namespace glider::ir::opt
