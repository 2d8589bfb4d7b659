// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/energy/energy_use.h"
#include "ir/prove/energy/greatest_walk.h"

#include <vector>

namespace glider::ir::prove {

/// A bound of what is used in t seconds: no more joules than `offset` and t times `rate` together.
/// (Of their single fields that is not said, but that `rate` lasts a second and `offset` none.)
struct EnergyLine {
  EnergyUse rate;  ///< of a second
  EnergyUse offset;
};

/// Each of them is a bound; the first is that of a long time.
using EnergyLines = std::vector<EnergyLine>;

/// Of the walks of a graph that has a cycle.
EnergyLines linesOf(const EnergyGraph& graph, const GreatestPower& power);

/// What may be used in `least` to `most` seconds: at both, and at each time from which on another
/// line is the least.
std::vector<EnergyUse> usesWithin(const EnergyLines& lines, const GreatestPower& power,
                                  double least, double most);

}  // namespace glider::ir::prove
