// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_traces/events.h"

#include "support/trace/submersions.h"
#include "vehicles/slocum/data_traces/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace glider::slocum {
namespace {

using support::EventId;
using support::Trace;
using support::TraceEvent;

/// A mission that is flown has 0; those below have ended without an abort.
constexpr int kInProgress = 0, kEndedNormally = -1, kEndedAbnormally = -2;

struct StatusText {
  int code;
  const char* text;
};

constexpr StatusText kStatusTexts[] = {
    {1, "no behaviour is active"},
    {2, "no behaviour commands the heading"},
    {3, "no behaviour commands the pitch"},
    {4, "no behaviour commands the buoyancy pump"},
    {5, "no behaviour commands the thermal engine"},
    {6, "a behaviour failed"},
    {7, "too deep"},
    {8, "the mission took too long"},
    {9, "the battery's voltage is too low"},
    {10, "the depth has not changed for too long"},
    {11, "an operator stopped the mission"},
    {12, "no input"},
    {13, "an inflection took too long"},
    {14, "the watchdog was not tickled in time"},
    {15, "the pressure of the thermal engine"},
    {16, "a device failed"},
    {17, "a device is not installed"},
    {18, "the waypoint is too far away"},
    {24, "leak"},
    {32, "the battery's relative charge is low"},
};

/// Adds events with their mission time.
class Adder {
 public:
  Adder(const Merged& merged, Trace& trace)
      : mission_time_(samplesOf(merged, "m_present_secs_into_mission")), trace_(trace) {}

  /// `time_s`: since 1970.
  void add(double time_s, EventId id, std::vector<support::EventValue> values = {},
           std::string why = "") {
    trace_.events.push_back(
        support::makeEvent(time_s - trace_.log->utc_s, id, std::move(values), std::move(why)));
    trace_.events.back().mission_time_s = resampled(mission_time_, {time_s}, Between::Line)[0];
  }

 private:
  Samples mission_time_;
  Trace& trace_;
};

void addSegments(const Merged& merged, Adder& events) {
  std::set<std::string> seen;
  for (const LogFile& file : merged.files) {
    const double begin = file.span().first;
    if (!std::isnan(begin) && seen.insert(file.data.header.full_name).second) {
      events.add(begin, EventId::SegmentBegins, {file.data.header.full_name},
                 fmt::format("mission {}", file.data.header.mission));
    }
  }
}

void addSurfacings(const Trace& trace, Adder& events) {
  const auto at = [&](size_t row) { return trace.log->utc_s + trace.at(row, 0); };
  for (const support::Submersion& submersion : support::submersions(trace)) {
    if (submersion.begin > 0) {
      events.add(at(submersion.begin), EventId::Dives);
    }
    if (submersion.end) {
      events.add(at(*submersion.end), EventId::Surfaces);
    }
  }
}

void addWaypoints(const Merged& merged, Adder& events) {
  const Samples hit = samplesOf(merged, "x_hit_a_waypoint");
  for (size_t i = 1; i < hit.values.size(); ++i) {
    if (hit.values[i] == 1 && hit.values[i - 1] == 0) {
      events.add(hit.times_s[i], EventId::WaypointHit);
    }
  }
}

void addStatus(int code, double time_s, Adder& events) {
  const std::string status = fmt::format("mission status {}", code);
  if (code > kInProgress) {
    const std::string text = missionStatusText(code);
    events.add(time_s, EventId::Aborts, {text.empty() ? "for a reason that is not known" : text},
               status);
  } else if (code == kEndedNormally || code == kEndedAbnormally) {
    events.add(time_s, code == kEndedNormally ? EventId::EndedNormally : EventId::EndedAbnormally,
               {}, status);
  }
}

/// A mission's status, where it changes; it is repeated in every segment.
void addMissionStatus(const Merged& merged, Adder& events) {
  Samples status = samplesOf(merged, "x_mission_status");
  if (status.empty()) {
    status = samplesOf(merged, "cc_final_mission_status_mode");
  }
  int before = kInProgress;
  for (size_t i = 0; i < status.values.size(); ++i) {
    if (std::isnan(status.values[i])) {
      continue;
    }
    const int code = static_cast<int>(status.values[i]);
    if (code != before) {
      addStatus(code, status.times_s[i], events);
    }
    before = code;
  }
}

}  // namespace

std::vector<std::string> eventSensors() {
  return {"m_present_secs_into_mission", "x_hit_a_waypoint", "x_mission_status",
          "cc_final_mission_status_mode"};
}

std::string missionStatusText(int code) {
  const auto* found = std::ranges::find(kStatusTexts, code, &StatusText::code);
  return found == std::end(kStatusTexts) ? "" : found->text;
}

void addEvents(const Merged& merged, Trace& trace) {
  Adder events(merged, trace);
  addSegments(merged, events);
  addSurfacings(trace, events);
  addWaypoints(merged, events);
  addMissionStatus(merged, events);
  std::ranges::stable_sort(trace.events, {}, &TraceEvent::time_s);
}

}  // namespace glider::slocum
