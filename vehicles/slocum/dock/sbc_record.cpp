// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/dock/sbc_record.h"

#include "hooks/extctl/pairs.h"
#include "hooks/extctl/port.h"
#include "hooks/extctl/sentence.h"
#include "vehicles/slocum/dock/dock_run.h"

#include <algorithm>
#include <string_view>

namespace glider::slocum {

bool steers(const AnsweredCycle& cycle) {
  return std::ranges::any_of(cycle.written,
                             [](const auto& one) { return one.first < kFirstOfItself; });
}

void SbcRecord::begin(const DockCycle& cycle, double said_s, uint64_t sent_bytes) {
  cycles.push_back({.cycle = cycle,
                    .said_s = said_s,
                    .sent_bytes = sent_bytes,
                    .answered_s = {},
                    .written = {}});
}

void SbcRecord::take(const std::string& body, double now_s) {
  constexpr std::string_view kMission = "TXT,mission,";
  const std::string name = nameOf(body);
  if (!cycles.empty()) {
    cycles.back().heard_bytes += body.size() + hooks::extctl::kSentenceEnd + 1;
  }
  if (name == "SW") {
    takePairs(body, now_s);
  } else if (name == "MD") {
    ++mode_sentences;
  } else if (body.starts_with(kMission)) {
    mission = body.substr(kMission.size());
  }
  vehicle_is_there = vehicle_is_there || isOfVehicle(name);
}

void SbcRecord::takePairs(const std::string& body, double now_s) {
  constexpr uint32_t kName = 2;
  hooks::extctl::PairReader reader(body.data() + kName, static_cast<uint32_t>(body.size()) - kName);
  for (hooks::extctl::Pair pair; reader.next(&pair);) {
    if (!pair.good) {
      ++bad_pairs;
    } else if (pair.index >= written_sensors_) {
      unknown.insert(pair.index);
    } else if (!cycles.empty()) {
      AnsweredCycle& newest = cycles.back();
      newest.written[pair.index] = pair.value;
      if (pair.index == static_cast<uint32_t>(hooks::extctl::PortSensor::Beat)) {
        newest.count = pair.value;
        newest.answered_s = newest.answered_s ? newest.answered_s : now_s;
      }
    }
  }
}

}  // namespace glider::slocum
