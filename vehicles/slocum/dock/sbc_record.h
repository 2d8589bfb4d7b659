// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/port.h"
#include "vehicles/slocum/dock/played_vehicle.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace glider::slocum {

/// A control cycle that was reported to the SBC, and what it wrote after that.
struct AnsweredCycle {
  DockCycle cycle;
  double said_s = 0;                 ///< when the report had been handed to the device
  uint64_t sent_bytes = 0;           ///< of the report
  std::optional<double> answered_s;  ///< when the count of the SBC arrived
  double count = 0;                  ///< of the SBC, with that answer
  uint64_t heard_bytes = 0;          ///< in good sentences
  std::map<uint32_t, double> written;
};

/// The indices from here on are what the program says of itself in each answer; those before it
/// steer.
inline constexpr auto kFirstOfItself = static_cast<uint32_t>(hooks::extctl::PortSensor::State);

/// Whether the SBC wrote what steers.
bool steers(const AnsweredCycle& cycle);

/// What an SBC has said to the played vehicle.
struct SbcRecord {
  explicit SbcRecord(uint32_t written_sensors) : written_sensors_(written_sensors) {}

  void begin(const DockCycle& cycle, double said_s, uint64_t sent_bytes);
  /// Takes the body of a sentence that arrived at `now_s`.
  void take(const std::string& body, double now_s);

  std::vector<AnsweredCycle> cycles;
  std::string mission;  ///< its name; empty: it was not said
  uint32_t bad_pairs = 0;
  std::set<uint32_t> unknown;  ///< indices that it may not write
  uint32_t mode_sentences = 0;
  bool vehicle_is_there = false;  ///< a sentence that only a vehicle says

 private:
  void takePairs(const std::string& body, double now_s);

  uint32_t written_sensors_;
};

}  // namespace glider::slocum
