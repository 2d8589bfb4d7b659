// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/energy/energy_lines.h"

#include <algorithm>

namespace glider::ir::prove {
namespace {

EnergyUse useAt(const EnergyLines& lines, const GreatestPower& power, double seconds) {
  const auto at = [&](const EnergyLine& line) { return line.offset + line.rate * seconds; };
  return at(*std::ranges::min_element(
      lines, {}, [&](const EnergyLine& line) { return power.joules(at(line)); }));
}

}  // namespace

EnergyLines linesOf(const EnergyGraph& graph, const GreatestPower& power) {
  EnergyLines lines;
  const EnergyUse cycle = graph.costliestCycle();
  for (const double times : {1.0, 1.5, 3.0, 10.0}) {
    // Just above, so that rounding leaves no cycle that gains.
    EnergyUse rate = cycle * (times * (1 + 1e-9) / cycle.seconds);
    rate.seconds = 1;  // a steeper line takes more in a second, not more seconds
    const EnergyUse walk = graph.greatestWalk(power.joules(rate));
    lines.push_back({rate, walk - rate * walk.seconds});
  }
  return lines;
}

std::vector<EnergyUse> usesWithin(const EnergyLines& lines, const GreatestPower& power,
                                  double least, double most) {
  std::vector<EnergyUse> uses{useAt(lines, power, least), useAt(lines, power, most)};
  for (size_t i = 0; i < lines.size(); ++i) {
    for (size_t k = i + 1; k < lines.size(); ++k) {
      const double meet = (power.joules(lines[i].offset) - power.joules(lines[k].offset)) /
                          (power.joules(lines[k].rate) - power.joules(lines[i].rate));
      if (meet > least && meet < most) {
        uses.push_back(useAt(lines, power, meet));
      }
    }
  }
  return uses;
}

}  // namespace glider::ir::prove
