// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/draw_faults.h"
#include "simulator/sensors/noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace glider::simulator {

/// Random times and numbers for the faults of one flight.
class Draw {
 public:
  Draw(uint64_t seed, Manner manner, const FlightTimes& times)
      : noise_(seed, static_cast<uint32_t>(NoiseStream::Campaign)),
        manner_(manner),
        times_(times),
        anchor_s_(between(0, times.flight_s)) {}

  double between(double low, double high) { return low + (high - low) * noise_.uniform(); }
  /// Every power of ten is equally likely.
  double scale(double low, double high) { return low * std::pow(high / low, noise_.uniform()); }
  bool chance(double share) { return noise_.uniform() < share; }
  uint32_t below(uint32_t count) { return static_cast<uint32_t>(noise_.uniform() * count); }
  LineWay anyWay() { return static_cast<LineWay>(below(4)); }
  /// A kind other than None and Several.
  FaultKind otherKind() {
    constexpr auto kFirst = static_cast<uint32_t>(FaultKind::None) + 1;
    constexpr auto kAfter = static_cast<uint32_t>(FaultKind::Several);
    return static_cast<FaultKind>(kFirst + below(kAfter - kFirst));
  }

  /// The time at which something goes wrong.
  double moment() {
    switch (manner_) {
      case Manner::Handshake:
        return std::max(0.0, between(times_.take_s - 30, times_.take_s + 30));
      case Manner::Exit:
        return std::max(0.0, between(times_.release_s - 40, times_.release_s + 30));
      case Manner::Together:
        return anchor_s_ + between(0, 20);
      case Manner::Once:
      case Manner::Recurring:
      case Manner::ForGood:
        break;
    }
    // A fault shows otherwise in a hover, and few missions hover for long.
    constexpr double kShort = 60;  // s
    const bool hovers = times_.hover.to_s - times_.hover.from_s > kShort;
    return hovers && chance(0.5) ? between(times_.hover.from_s, times_.hover.to_s)
                                 : between(0, times_.flight_s);
  }
  /// Times of a fault; with those that may last, some do not end.
  std::vector<Span> windows() { return windows(1, 900, true); }
  /// Times that end.
  std::vector<Span> passing(double shortest_s, double longest_s) {
    return windows(shortest_s, longest_s, false);
  }
  [[nodiscard]] const FlightTimes& times() const { return times_; }

 private:
  std::vector<Span> windows(double shortest_s, double longest_s, bool may_last) {
    const bool short_ones =
        manner_ == Manner::Recurring || manner_ == Manner::Handshake || manner_ == Manner::Exit;
    const uint32_t count = manner_ == Manner::Recurring ? 3 + below(4) : 1;
    std::vector<Span> spans;
    for (uint32_t i = 0; i < count; ++i) {
      const double from = moment();
      const double takes = scale(shortest_s, short_ones ? std::min(longest_s, 120.0) : longest_s);
      const bool lasts = manner_ == Manner::ForGood || (manner_ == Manner::Once && chance(0.125));
      spans.push_back({from, may_last && lasts ? kForever : from + takes});
    }
    return spans;
  }

  Noise noise_;
  Manner manner_;
  FlightTimes times_;
  double anchor_s_;
};

}  // namespace glider::simulator
