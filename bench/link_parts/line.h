// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/clock.h"
#include "simulator/link/serial_line.h"
#include "simulator/sensors/noise.h"

#include <limits>

/// What both benches of the link have in common: the lines' speeds, and what spoils their bytes.
namespace glider::bench {

using simulator::Noise;
using simulator::SerialLine;

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kFastBaud = 115200;

/// Passes bytes on, counts them, and damages some: a flipped bit or a lost byte.
class Tap {
 public:
  Tap(GliderByteStream inner, double damage, Noise noise)
      : inner_(inner), damage_(damage), noise_(noise) {}
  GliderByteStream stream() { return {this, read, write}; }
  uint64_t written = 0;

 private:
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity) {
    auto& tap = *static_cast<Tap*>(self);
    const int32_t got = tap.inner_.read(tap.inner_.self, bytes, capacity);
    int32_t kept = 0;
    for (int32_t i = 0; i < got; ++i) {
      if (tap.damage_ > 0 && tap.noise_.uniform() < tap.damage_) {
        if (tap.noise_.uniform() < 0.5) {
          continue;
        }
        bytes[i] = static_cast<uint8_t>(bytes[i] ^
                                        (1U << static_cast<uint32_t>(tap.noise_.uniform() * 8)));
      }
      bytes[kept++] = bytes[i];
    }
    return got <= 0 ? got : kept;
  }
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count) {
    auto& tap = *static_cast<Tap*>(self);
    const int32_t taken = tap.inner_.write(tap.inner_.self, bytes, count);
    tap.written += taken > 0 ? static_cast<uint64_t>(taken) : 0;
    return taken;
  }

  GliderByteStream inner_;
  double damage_;
  Noise noise_;
};

/// A clock that shows the time in `now`.
inline GliderClock clockAt(double& now) {
  return {&now, [](void* self) { return *static_cast<double*>(self); }};
}

}  // namespace glider::bench
