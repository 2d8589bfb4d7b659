// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/fleet/separations.h"

#include <algorithm>
#include <cmath>

namespace glider::simulator {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

double distanceOf(const TruePlace& one, const TruePlace& other) {
  return std::hypot(one.east_m - other.east_m, one.north_m - other.north_m,
                    one.depth_m - other.depth_m);
}

}  // namespace

Separations::Separations(size_t vehicles) : vehicles_(vehicles) {
  for (size_t one = 0; one < vehicles; ++one) {
    for (size_t other = one + 1; other < vehicles; ++other) {
      pairs_.push_back({.pair = {one, other}});
    }
  }
  series_.resize(pairs_.size());
  since_.assign(pairs_.size(), kNever);
}

void Separations::look(double now_s, std::span<const std::optional<TruePlace>> places) {
  for (size_t i = 0; i < pairs_.size(); ++i) {
    PairDistance& pair = pairs_[i];
    const auto& one = places[pair.pair.one];
    const auto& other = places[pair.pair.other];
    if (!one || !other) {
      continue;
    }
    const double apart_m = distanceOf(*one, *other);
    since_[i] = std::min(since_[i], apart_m);
    if (apart_m < pair.least_m) {
      pair.least_m = apart_m;
      pair.least_at_s = now_s;
      pair.least_depths_m[0] = one->depth_m;
      pair.least_depths_m[1] = other->depth_m;
    }
  }
  if (times_.empty() || now_s >= times_.back() + step_s_) {
    sample(now_s);
  }
}

void Separations::sample(double now_s) {
  if (times_.size() == kMostSamples) {
    halve();
  }
  times_.push_back(now_s);
  for (size_t i = 0; i < pairs_.size(); ++i) {
    series_[i].push_back(since_[i]);
    since_[i] = kNever;
  }
}

/// Two samples become one: the least of both, at the later time.
void Separations::halve() {
  const size_t half = times_.size() / 2;
  for (size_t i = 0; i < half; ++i) {
    times_[i] = times_[2 * i + 1];
  }
  times_.resize(half);
  for (std::vector<double>& series : series_) {
    for (size_t i = 0; i < half; ++i) {
      series[i] = std::min(series[2 * i], series[2 * i + 1]);
    }
    series.resize(half);
  }
  step_s_ *= 2;
}

}  // namespace glider::simulator
