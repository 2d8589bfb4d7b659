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
  Unlisted,  ///< read from a file, or of a vehicle in tests: its values are its kind and its text
};

/// What readers group events by: the rows of event_kinds.def.
enum class EventKind : uint8_t {
#define EVENT_KIND(name, word) name,
#include "support/trace/event_kinds.def"
#undef EVENT_KIND
};

/// A value of an event, in the order of its words.
using EventValue = std::variant<double, std::string>;

/// What happened between cycles. Programs recognize an event by its id and values; its text is made
/// when a person is to read it.
struct TraceEvent {
  double time_s = 0;  ///< vehicle time since the mission start
  double mission_time_s = std::numeric_limits<double>::quiet_NaN();  ///< the SBC's missiontime; NaN
                                                                     ///< when it was not in control
  EventId id = EventId::Unlisted;
  std::vector<EventValue> values = {};  ///< in the order of the places in its words
  std::string why = {};  ///< one line: the guard and the values that fired it; "" if there is none
  std::string shown = {};  ///< its text for people, with rounded numbers and units; "": textOf
};

/// An event of events.def with all values of its words.
TraceEvent makeEvent(double time_s, EventId id, std::vector<EventValue> values = {},
                     std::string why = "");
/// An event of which only the words are known.
TraceEvent unlistedEvent(double time_s, double mission_time_s, std::string kind, std::string text,
                         std::string why);

/// The event in words, one line: "s1 → s2 (call)".
std::string textOf(const TraceEvent& event);
/// The same as people read it in a summary or a report.
std::string shownTextOf(const TraceEvent& event);
/// The word for its kind: "transition", "control", "hook"…
std::string kindOf(const TraceEvent& event);
bool isOfKind(const TraceEvent& event, EventKind kind);

}  // namespace glider::support
