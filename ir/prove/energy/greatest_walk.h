// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/energy/energy_use.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace glider::ir::prove {

/// A way from one vertex to another. It takes one of these uses; or one between two of them, which
/// no price of time makes better than both.
struct EnergyArc {
  size_t from = 0, to = 0;
  std::vector<EnergyUse> uses;  ///< one at least
};

/// The walks from vertex 0 of a graph whose arcs take time and energy. A walk may end at any
/// vertex.
class EnergyGraph {
 public:
  using Joules = std::function<double(const EnergyUse&)>;

  EnergyGraph(size_t vertices, std::vector<EnergyArc> arcs, Joules joules);

  /// The cycle that takes the most energy for its time, once around; seconds 0: there is none, or
  /// none that takes energy.
  [[nodiscard]] const EnergyUse& costliestCycle() const { return cycle_.use; }
  /// Its vertices, each once.
  [[nodiscard]] const std::vector<size_t>& verticesOfCycle() const { return cycle_.vertices; }
  /// Its power, W; the greatest that any walk can take on average for long.
  [[nodiscard]] double costliestPower() const { return power_; }
  /// The walk for which the energy less `power` (W) times its time is greatest: no walk of t
  /// seconds takes more than that difference and `power` t. `power` is not less than
  /// costliestPower().
  [[nodiscard]] EnergyUse greatestWalk(double power) const;

 private:
  struct Search;
  struct Cycle {
    EnergyUse use;
    std::vector<size_t> vertices;
  };
  /// A cycle for which that difference is positive; none if there is none.
  [[nodiscard]] std::optional<Cycle> cycleAbove(double power) const;
  [[nodiscard]] Search search(double power) const;
  [[nodiscard]] size_t bestUse(const EnergyArc& arc, double power) const;
  [[nodiscard]] std::optional<Cycle> around(const Search& found) const;

  size_t vertices_;
  std::vector<EnergyArc> arcs_;
  Joules joules_;
  std::vector<std::vector<double>> joules_of_;  ///< of each use of each arc
  Cycle cycle_;
  double power_ = 0;
};

}  // namespace glider::ir::prove
