// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_missions/random.h"
#include "tests/random_missions/random_mission.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace glider::random_missions {
namespace {

using Limits = std::numeric_limits<double>;

constexpr double kSpecial[] = {std::bit_cast<double>(0x7FF8000000000000ULL),
                               std::bit_cast<double>(0xFFF8000000000001ULL),
                               std::bit_cast<double>(0x7FF0000000000001ULL),  // signalling
                               std::bit_cast<double>(0xFFF4000000000000ULL),  // signalling
                               Limits::infinity(),
                               -Limits::infinity(),
                               0.0,
                               -0.0,
                               Limits::denorm_min(),
                               -Limits::denorm_min(),
                               0x1.8p-1023,
                               Limits::min(),
                               Limits::max(),
                               -Limits::max(),
                               1e300,
                               5959.999999999999,
                               3960.0,
                               -7399.5};

/// What one sensor reports, tick by tick.
class SensorStream {
 public:
  SensorStream(const ir::Sensor& sensor, Random& random)
      : random_(random),
        lowest_(std::max(sensor.lowest, -1e3)),
        highest_(std::min(sensor.highest, 1e3)),
        value_(random.uniform(lowest_, highest_)) {
    if (sensor.encoding == ir::Encoding::DegreesMinutes) {
      lowest_ = sensor.lowest;
      highest_ = sensor.highest;
    }
  }

  /// Whether this frame holds the sensor, and then its raw value.
  std::optional<double> next() {
    if (silent_ > 0) {
      --silent_;
      return std::nullopt;
    }
    if (random_.chance(0.02)) {
      silent_ = random_.between(2, 40);
    }
    return random_.chance(0.8) ? std::optional(value()) : std::nullopt;
  }

 private:
  double value() {
    const double span = highest_ - lowest_;
    const double kind = random_.unit();
    if (kind < 0.07) {
      return random_.pick(kSpecial);  // the wandering goes on from where it was
    }
    if (kind < 0.12) {
      const double end = random_.chance(0.5) ? lowest_ : highest_;
      return random_.chance(0.5) ? end : std::nextafter(end, random_.chance(0.5) ? 2 * end + 1 : 0);
    }
    if (kind < 0.25) {
      return value_;
    }
    if (kind < 0.45) {
      value_ = random_.uniform(lowest_, highest_);
    } else {
      value_ += span * random_.uniform(-0.1, 0.1);
      value_ = std::clamp(value_, lowest_ - 0.1 * span, highest_ + 0.1 * span);
    }
    return value_;
  }

  Random& random_;
  double lowest_;
  double highest_;
  double value_;
  uint32_t silent_ = 0;
};

double step(Random& random) {
  // A window takes readings of up to 6 s: that age to the bit, too.
  constexpr double kOdd[] = {0, 0, 0.1, 2, 3.97, 4.25, 6, 6, 8, 12, -4, 90, 700};
  return random.chance(0.85) ? 4 : random.pick(kOdd);
}

}  // namespace

std::vector<StreamTick> randomStream(const ir::Mission& mission, uint64_t seed, size_t ticks) {
  Random random(seed);
  std::vector<SensorStream> sensors;
  for (const ir::Sensor& sensor : mission.sensors) {
    sensors.emplace_back(sensor, random);
  }
  std::vector<StreamTick> stream;
  double time = 0;
  for (size_t i = 0; i <= ticks; ++i) {
    StreamTick tick{time, {}};
    const bool silence = random.chance(0.03);  // a tick of the clock alone
    for (uint32_t s = 0; s < sensors.size(); ++s) {
      const std::optional<double> raw = sensors[s].next();
      if (raw && !silence && mission.sensors[s].symbol.empty()) {
        tick.frame.push_back({{s}, *raw});
      }
    }
    stream.push_back(std::move(tick));
    time += step(random);
  }
  return stream;
}

}  // namespace glider::random_missions
