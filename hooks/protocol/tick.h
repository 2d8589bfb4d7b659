// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame.h"
#include "hooks/protocol/sensors.h"
#include "hooks/protocol/values.h"

#include <stdint.h>

/// What the vehicle reports to the SBC, and how much of it: the messages Tick and Subscribe.
namespace glider::hooks {

inline constexpr uint32_t kMostSubscriptions = 64;

struct Subscribe {
  uint8_t count = 0;
  Subscription sensors[kMostSubscriptions] = {};
};

/// Head of a Tick.
struct TickHead {
  bool virtual_time = false;
  uint32_t link = 0;
  double vehicle_time_s = 0;  ///< from the 4-byte sensor m_present_secs_into_mission
  uint32_t cycle = 0;         ///< at most 16777215, as are link and session
  uint16_t subscription = 0;  ///< subscriptionCheck of the list that is served
  HookState hook_state = HookState::Absent;
  HookAnswer answer = HookAnswer::None;
  uint16_t answered_sequence = 0;
  uint32_t session = 0;
  uint32_t clock_s = 0;  ///< m_present_time, whole seconds since 1970; 0: unknown
};

/// What a Tick reports about a subscribed sensor.
enum class ReadingReport : uint8_t {
  Nothing,    ///< not reported in this cycle, or not due yet
  Unchanged,  ///< reported, with the value that the SBC holds (or within the dead band of it)
  Value,      ///< reported, with this value
};

/// What a Tick reports about each subscribed sensor, in the subscription's order.
struct TickReadings {
  ReadingReport told[kMostSubscriptions] = {};
  double values[kMostSubscriptions] = {};  ///< of those with ReadingReport::Value
};

void encode(const Subscribe& subscribe, Frame& frame);
/// Also false if it names a sensor that `dictionary` lacks.
[[nodiscard]] bool decode(const GliderDictionary& dictionary, const Frame& frame,
                          Subscribe& subscribe);
/// CRC-16 over the list as encoded in a Subscribe: shows whether both ends use the same list.
uint16_t subscriptionCheck(const Subscribe& subscribe);

/// `readings` are those of `subscription`.
void encode(const GliderDictionary& dictionary, const TickHead& head, const Subscribe& subscription,
            const TickReadings& readings, Frame& frame);
/// The head alone: a receiver with a different subscription cannot read the rest.
[[nodiscard]] bool decode(const Frame& frame, TickHead& head);
/// The rest; false if it does not match `subscription`.
[[nodiscard]] bool decode(const GliderDictionary& dictionary, const Frame& frame,
                          const Subscribe& subscription, TickReadings& readings);

}  // namespace glider::hooks
