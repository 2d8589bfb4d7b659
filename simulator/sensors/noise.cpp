// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/noise.h"

#include <algorithm>
#include <iterator>

namespace glider::simulator {
namespace {

struct Numbered {
  std::string_view source;
  uint64_t stream;
};

/// The sources whose streams had numbers before streams had names. They keep their numbers, so that
/// their flights do not change. Never add a source here.
constexpr Numbered kNumbered[] = {
    {"m_depth", 0},
    {"m_pitch", 1},
    {"m_heading", 2},
    {"m_altitude", 3},
    {"gps", 4},
    {"sci_water_temp", 5},
    {"ctd dropout", 6},
    {"ctd depth", 7},
    {"ctd repeat", 8},
    {"altimeter dropout", 9},
    {"sci_flbbcd_chlor_units", 10},
    {"sci_oxy4_oxygen", 11},
};

/// FNV-1a; the highest bit is set, so that the result is not the number of a numbered stream.
uint64_t hash(std::string_view text) {
  uint64_t sum = 0xcbf29ce484222325;
  for (const char c : text) {
    sum = (sum ^ static_cast<uint8_t>(c)) * 0x100000001b3;
  }
  return sum | (uint64_t{1} << 63U);
}

uint64_t streamOf(std::string_view source) {
  const auto* const found = std::ranges::find(kNumbered, source, &Numbered::source);
  return found != std::end(kNumbered) ? found->stream : hash(source);
}

}  // namespace

uint64_t seedOfVehicle(uint64_t world_seed, uint32_t number) {
  uint64_t z = number * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return world_seed ^ z ^ (z >> 31U);
}

Noise::Noise(uint64_t seed, std::string_view source)
    : key_{{static_cast<uint32_t>(seed), static_cast<uint32_t>(seed >> 32U)}},
      stream_(streamOf(source)) {}

}  // namespace glider::simulator
