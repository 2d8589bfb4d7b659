// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/read_envelope.h"

#include "platforms/load/read_numbers.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace glider::platforms {
namespace {

constexpr NumberKey<Envelope> kEnvelope[] = {
    {"greatest_depth_m", &Envelope::greatest_depth_m},
    {"vertical_rate_m_s", &Envelope::vertical_rate_m_s},
    {"inflection_overshoot_m", &Envelope::inflection_overshoot_m},
    {"drift_m_s", &Envelope::drift_m_s},
    {"cycle_s", &Envelope::cycle_s}};

/// Of a vehicle that glides.
constexpr NumberKey<Envelope> kGlides[] = {
    {"steepest_pitch_rad", &Envelope::steepest_pitch_rad},
    {"shallowest_pitch_rad", &Envelope::shallowest_pitch_rad},
    {"pump_cc", &Envelope::pump_cc}};
constexpr std::string_view kGlidesToo[] = {"usual_pitch_rad", "battery_in", "steep_overshoot_m",
                                           "overshoot_pitch_rad"};

/// Of a vehicle with a propeller.
constexpr NumberKey<Envelope> kDrives[] = {{"slowest_m_s", &Envelope::slowest_m_s},
                                           {"usual_speed_m_s", &Envelope::usual_speed_m_s},
                                           {"fastest_m_s", &Envelope::fastest_m_s}};

/// Sets the fields of `keys`, each above 0, of a table that has more.
template <size_t kCount>
void readInto(TomlReader& reader, const NumberKey<Envelope> (&keys)[kCount], Envelope& envelope) {
  for (const NumberKey<Envelope>& key : keys) {
    envelope.*key.field = reader.number(key.key);
    if (!(envelope.*key.field > 0)) {
      reader.refuse(key.key, "must be above 0");
    }
  }
}

template <size_t kCount>
void addKeys(const NumberKey<Envelope> (&keys)[kCount], std::vector<std::string_view>& all) {
  std::ranges::transform(keys, std::back_inserter(all), &NumberKey<Envelope>::key);
}

void readPitches(TomlReader& reader, Envelope& envelope) {
  readInto(reader, kGlides, envelope);
  constexpr double kUsualPitch = 0.4537856055185257;  // 26 degrees
  const double steepest = std::max(envelope.shallowest_pitch_rad, envelope.steepest_pitch_rad);
  envelope.usual_pitch_rad = reader.numberOr(
      "usual_pitch_rad", std::clamp(kUsualPitch, envelope.shallowest_pitch_rad, steepest));
  if (!(envelope.usual_pitch_rad >= envelope.shallowest_pitch_rad &&
        envelope.usual_pitch_rad <= steepest)) {
    reader.refuse("usual_pitch_rad",
                  "must be between `shallowest_pitch_rad` and `steepest_pitch_rad`");
  }
}

/// Both or neither.
void readSteepOvershoot(TomlReader& reader, Envelope& envelope) {
  envelope.steep_overshoot_m = reader.numberOr("steep_overshoot_m", 0);
  envelope.overshoot_pitch_rad = reader.numberOr("overshoot_pitch_rad", 0);
  const bool none = envelope.steep_overshoot_m == 0 && envelope.overshoot_pitch_rad == 0;
  if (!none && !(envelope.steep_overshoot_m >= envelope.inflection_overshoot_m)) {
    reader.refuse("steep_overshoot_m", "must not be below `inflection_overshoot_m`");
  }
  if (!none && !(envelope.overshoot_pitch_rad > 0)) {
    reader.refuse("overshoot_pitch_rad", "must be above 0");
  }
}

void readSpeeds(TomlReader& reader, Envelope& envelope) {
  readInto(reader, kDrives, envelope);
  if (!(envelope.usual_speed_m_s >= envelope.slowest_m_s &&
        envelope.usual_speed_m_s <= envelope.fastest_m_s)) {
    reader.refuse("usual_speed_m_s", "must be between `slowest_m_s` and `fastest_m_s`");
  }
}

}  // namespace

Envelope readEnvelope(TomlReader& reader) {
  const bool drives = reader.numberOr("fastest_m_s", 0) != 0;
  std::vector<std::string_view> others = {"fin_rad"};
  if (drives) {
    addKeys(kDrives, others);
  } else {
    addKeys(kGlides, others);
    std::ranges::copy(kGlidesToo, std::back_inserter(others));
  }
  auto envelope = readNumbers(reader, kEnvelope, std::move(others));
  if (drives) {
    readSpeeds(reader, envelope);
  } else {
    readPitches(reader, envelope);
    readSteepOvershoot(reader, envelope);
  }
  envelope.fin_rad = reader.numberOr("fin_rad", 0);
  constexpr double kQuarterTurn = 1.5707963267948966;
  if (!(envelope.fin_rad >= 0 && envelope.fin_rad <= kQuarterTurn)) {
    reader.refuse("fin_rad", "must be between 0 and a quarter of a turn");
  }
  envelope.battery_in = reader.numberOr("battery_in", 0);
  if (!(envelope.battery_in >= 0)) {
    reader.refuse("battery_in", "must not be below 0");
  }
  return envelope;
}

}  // namespace glider::platforms
