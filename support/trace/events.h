// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace glider::support {

/// What can happen in a flight: the rows of events.def.
enum class EventId : uint8_t {
#define EVENT(name, kind, words) name,
#include "support/trace/events.def"
#undef EVENT
  Unlisted,  ///< of a trace that only has words
};

/// A value of an event, in the order of its words.
using EventValue = std::variant<double, std::string>;

/// What happened between cycles.
struct TraceEvent {
  double time_s = 0;  ///< vehicle time since the mission start
  double mission_time_s = std::numeric_limits<double>::quiet_NaN();  ///< the SBC's missiontime; NaN
                                                                     ///< when it was not in control
  std::string kind;  ///< as in events.def: "transition", "control", "hook"…
  std::string what;  ///< one line: "s1 → s2 (call)"
  std::string why;   ///< one line: the guard and the values that fired it; "" if there is none
  EventId id = EventId::Unlisted;
  std::vector<EventValue> values = {};  ///< those in `what`
};

/// An event of events.def with all values of its words.
TraceEvent makeEvent(double time_s, EventId id, std::vector<EventValue> values = {},
                     std::string why = "");

}  // namespace glider::support
