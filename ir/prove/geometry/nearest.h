// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

/// Distances between places without comparing all pairs of them: missions may have 10,000.
namespace glider::ir::prove {

/// Some places on the Earth.
class PlaceIndex {
 public:
  explicit PlaceIndex(const std::vector<Position>& places);
  ~PlaceIndex();
  PlaceIndex(const PlaceIndex&) = delete;
  PlaceIndex& operator=(const PlaceIndex&) = delete;

  /// Metres from `place` to the nearest different place; infinite if there is none.
  [[nodiscard]] double nearestOther(const Position& place) const;
  /// Whether at least `count` of the places, each as often as it was given, are within `metres` of
  /// `place`.
  [[nodiscard]] bool hasAround(const Position& place, double metres, size_t count) const;
  /// How often `place` was given.
  [[nodiscard]] size_t timesGiven(const Position& place) const;

 private:
  /// nearestOther() if the `k` nearest places decide it.
  [[nodiscard]] std::optional<double> nearestAmong(const Position& place, size_t k) const;

  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// For each of some angles, degrees: the distance round the circle to the nearest different one, 0
/// to 180; infinite if all are the same. 190 and -170 are the same.
std::vector<double> nearestOnCircle(const std::vector<double>& degrees);

}  // namespace glider::ir::prove
