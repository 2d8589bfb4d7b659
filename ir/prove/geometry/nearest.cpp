// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/geometry/nearest.h"

#include "ir/eval/arithmetic.h"
#include "ir/prove/geometry/sphere.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

namespace glider::ir::prove {
namespace {

namespace geometry = boost::geometry;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// On a sphere of radius 1: chords are in the same order as distances.
using SpherePoint = geometry::model::point<double, 3, geometry::cs::cartesian>;

struct RepeatedPlace {
  Position place;
  size_t times = 0;
};
using Entry = std::pair<SpherePoint, RepeatedPlace>;

SpherePoint onSphere(const Position& place) {
  const double north = place.latitude * std::numbers::pi / 180;
  const double east = place.longitude * std::numbers::pi / 180;
  return {std::cos(north) * std::cos(east), std::cos(north) * std::sin(east), std::sin(north)};
}

bool before(const Position& a, const Position& b) {
  return std::pair(a.latitude, a.longitude) < std::pair(b.latitude, b.longitude);
}

double apart(double a, double b) {
  return std::fabs(std::remainder(a - b, 360));
}

}  // namespace

struct PlaceIndex::Tree {
  geometry::index::rtree<Entry, geometry::index::quadratic<16>> places;
};

PlaceIndex::PlaceIndex(const std::vector<Position>& places) : tree_(std::make_unique<Tree>()) {
  std::vector<Position> sorted = places;
  std::ranges::sort(sorted, before);
  std::vector<Entry> entries;
  for (const Position& place : sorted) {
    if (entries.empty() || !(entries.back().second.place == place)) {
      entries.push_back({onSphere(place), {place, 0}});
    }
    ++entries.back().second.times;
  }
  tree_->places = {entries.begin(), entries.end()};
}

PlaceIndex::~PlaceIndex() = default;

double PlaceIndex::nearestOther(const Position& place) const {
  // The `k` nearest: a search of Boost's takes as long as `k` is great, so it begins with few.
  constexpr size_t kFirst = 4;
  for (size_t k = kFirst;; k *= 4) {
    if (const auto least = nearestAmong(place, k)) {
      return *least;
    }
  }
}

std::optional<double> PlaceIndex::nearestAmong(const Position& place, size_t k) const {
  // Chords are rounded differently from distances, so all places about as near are also measured.
  constexpr double kRounding = 1e-9;
  const SpherePoint here = onSphere(place);
  std::vector<Entry> near;
  tree_->places.query(geometry::index::nearest(here, static_cast<unsigned>(k)),
                      std::back_inserter(near));
  std::ranges::sort(near, {},
                    [&](const Entry& one) { return geometry::distance(here, one.first); });
  double least = kInfinite;
  double chord_of_least = 0;
  for (const auto& [point, given] : near) {
    const double chord = geometry::distance(here, point);
    if (std::isfinite(least) && chord > chord_of_least + kRounding) {
      return least;
    }
    const double metres = onEarth(Op::Distance, place, given.place);
    if (metres > 0 && !std::isfinite(least)) {
      chord_of_least = chord;
    }
    least = metres > 0 ? std::min(least, metres) : least;
  }
  return near.size() < k ? std::optional(least) : std::nullopt;
}

size_t PlaceIndex::timesGiven(const Position& place) const {
  size_t times = 0;
  const SpherePoint here = onSphere(place);
  for (auto it = tree_->places.qbegin(geometry::index::intersects(here));
       it != tree_->places.qend(); ++it) {
    times += it->second.place == place ? it->second.times : 0;
  }
  return times;
}

bool PlaceIndex::hasAround(const Position& place, double metres, size_t count) const {
  // A chord is no longer than its arc, so all within `metres` are in this box.
  const double chord = metres / kEarthRadius;
  const SpherePoint here = onSphere(place);
  const geometry::model::box<SpherePoint> box(
      {here.get<0>() - chord, here.get<1>() - chord, here.get<2>() - chord},
      {here.get<0>() + chord, here.get<1>() + chord, here.get<2>() + chord});
  size_t found = 0;
  for (auto it = tree_->places.qbegin(geometry::index::intersects(box));
       it != tree_->places.qend() && found < count; ++it) {
    found += onEarth(Op::Distance, place, it->second.place) < metres ? it->second.times : 0;
  }
  return found >= count;
}

std::vector<double> nearestOnCircle(const std::vector<double>& degrees) {
  std::vector<double> once;
  for (const double each : degrees) {
    once.push_back(std::remainder(each, 360));  // exact
  }
  std::ranges::sort(once);
  once.erase(std::ranges::unique(once).begin(), once.end());
  if (once.size() > 1 && apart(once.front(), once.back()) == 0) {
    once.pop_back();  // -180 and 180
  }
  std::vector<double> nearest;
  for (const double each : degrees) {
    // The two before and the two after it: one of them may be the same except for rounding.
    const auto here = std::ranges::lower_bound(once, std::remainder(each, 360)) - once.begin();
    const auto count = static_cast<std::ptrdiff_t>(once.size());
    double least = kInfinite;
    for (std::ptrdiff_t i = here - 2; i <= here + 2; ++i) {
      const double other = apart(each, once[static_cast<size_t>((i % count + count) % count)]);
      least = other > 0 ? std::min(least, other) : least;
    }
    nearest.push_back(least);
  }
  return nearest;
}

}  // namespace glider::ir::prove
