// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/difference/compare_missions.h"
#include "compiler/compilation.h"
#include "support/result.h"

#include <cstddef>
#include <string>
#include <vector>

namespace glider::analysis {

/// A flight on which two versions of a mission part: until then they do the same.
struct Parting {
  std::string flight;       ///< "scenario default, --seed 1", or "random readings"
  double mission_time = 0;  ///< s
  std::string state;        ///< current before
  std::string old_does, new_does;
  std::vector<std::string> readings;  ///< "depth = 12 m"
};

/// The result of the search for such a flight.
struct PartingSearch {
  size_t flights = 0;  ///< simulated ones that were flown, by each version
  size_t random = 0;   ///< flights with random readings
  bool found = false;
  Parting parting;
};

/// Flies both versions in each scenario that comes with glidercc, and then with random readings,
/// until they part: until they command or go to something different. With the default parameters.
/// Missions that need code in C, or are for different vehicles, are not flown. Fails as compiling
/// and simulating do.
support::Result<PartingSearch> searchParting(const compiler::Optimised& before,
                                             const compiler::Optimised& after,
                                             const MissionDifference& difference);

}  // namespace glider::analysis
