// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/glider_abi.h"

#include <stdint.h>
#include <string.h>

/// Arguments for the functions of runtime/numbers, the same on every machine, and a digest of their
/// results: boards that agree on it agree on every bit. Plain enough to run on a board.
namespace glider::numbers_samples {

/// Marsaglia's xorshift64.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  uint64_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return state_;
  }
  /// Even over [low, high), to 2^-32 of its width.
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 32) * 0x1p-32);
  }
  /// Any sign, any fraction, an exponent between these.
  double spread(int32_t low, int32_t high) {
    const uint64_t bits = next();
    const uint64_t exponent =
        static_cast<uint64_t>(low + 1023) + (next() >> 8) % static_cast<uint64_t>(high - low + 1);
    const uint64_t all = (bits & 0x800FFFFFFFFFFFFFU) | (exponent << 52);
    double value;
    memcpy(&value, &all, sizeof value);
    return value;
  }

 private:
  uint64_t state_;
};

/// Fowler, Noll and Vo's hash, by words.
class Digest {
 public:
  void add(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    state_ = (state_ ^ bits) * 0x100000001B3U;
  }
  [[nodiscard]] uint64_t value() const { return state_; }

 private:
  uint64_t state_ = 0xCBF29CE484222325U;
};

inline void addAngle(double angle, Digest& digest) {
  digest.add(gliderSin(angle));
  digest.add(gliderCos(angle));
  digest.add(gliderTan(angle));
}

inline void addPlaces(double latitude, double longitude, double to_latitude, double to_longitude,
                      Digest& digest) {
  digest.add(gliderDistance(latitude, longitude, to_latitude, to_longitude));
  digest.add(gliderBearing(latitude, longitude, to_latitude, to_longitude));
}

inline void addOffset(double latitude, double longitude, double bearing, double distance,
                      Digest& digest) {
  digest.add(gliderOffsetLatitude(latitude, longitude, bearing, distance));
  digest.add(gliderOffsetLongitude(latitude, longitude, bearing, distance));
}

inline void addWater(double conductivity, double temperature, double pressure, Digest& digest) {
  digest.add(gliderSalinity(conductivity, temperature, pressure));
  digest.add(gliderDensity(conductivity, temperature, pressure));
}

/// Ends of every range, ties and zeros.
inline void addAwkward(Digest& digest) {
  const double awkward[] = {0.0,      -0.0,       1.0,          -1.0,     90.0,
                            -90.0,    180.0,      -180.0,       360.0,    0x1p-1022,
                            -0x1p-60, 0x1p-1021,  0x1p-1070,    0x1p1023, -0x1.fffffffffffffp1023,
                            0x1p20,   0x1p-28,    0x1p-27,      45.0,     -45.0,
                            1e-300,   1e300,      0x1.8p-1022,  0x1p-60,  0x1.921fb54442d18p0,
                            90.0001,  -360.00001, 89.999999999, 0x1p-540, 1e308 * 10};
  for (const double a : awkward) {
    addAngle(a, digest);
    for (const double b : awkward) {
      digest.add(gliderAtan2(a, b));
      digest.add(gliderRemainder(a, b));
      addWater(a, b, a, digest);
      addPlaces(a, b, b, -b, digest);
      addPlaces(a, b, -a, 180.0, digest);
      addPlaces(90.0, a, 0x1p-60, b, digest);
      addOffset(a, b, b, a, digest);
      addOffset(a, 180.0, b, 20015114.4, digest);
    }
  }
}

/// The digest of `count` rounds of random arguments after the awkward ones.
inline uint64_t digestOf(uint32_t count) {
  Random random(88172645463325252U);
  Digest digest;
  addAwkward(digest);
  for (uint32_t i = 0; i < count; ++i) {
    addAngle(random.spread(-1022, 20), digest);
    addAngle(random.between(-10.0, 10.0), digest);
    const double y = random.spread(-1022, 1023);
    digest.add(gliderAtan2(y, random.spread(-1022, 1023)));
    const double north = random.between(-100.0, 100.0);
    digest.add(gliderAtan2(north, random.between(-100.0, 100.0)));
    const double latitude = random.between(-90.0, 90.0);
    const double longitude = random.between(-180.0, 180.0);
    const double near = latitude + random.spread(-50, -3);
    addPlaces(latitude, longitude, near, longitude + random.spread(-50, -3), digest);
    const double far = random.between(-90.0, 90.0);
    addPlaces(latitude, longitude, far, random.between(-180.0, 180.0), digest);
    // One draw a line: compilers evaluate arguments in different orders.
    const double bearing = random.between(-10.0, 10.0);
    addOffset(latitude, longitude, bearing, random.spread(-60, 25), digest);
    const double conductivity = random.between(-0.1, 8.0);
    const double temperature = random.between(-5.0, 46.0);
    addWater(conductivity, temperature, random.between(-1e5, 1.3e8), digest);
    const double whole = random.spread(-30, 40);
    digest.add(gliderRemainder(whole, random.spread(-20, 30)));
    const double tiny = random.spread(-1022, -40);
    addPlaces(tiny, random.spread(-1022, -40), far, tiny, digest);
  }
  return digest.value();
}

}  // namespace glider::numbers_samples
