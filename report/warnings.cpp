// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/warnings.h"

#include "report/figures.h"
#include "report/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

namespace glider::report {
namespace {

using support::Trace;
using support::TraceEvent;

constexpr size_t kMostNames = 20;

bool isRefusal(const TraceEvent& event) {
  return event.kind == "hook" && event.what.starts_with("instruction ") &&
         event.what.find(" refused: ") != std::string::npos;
}

/// The mission that the SBC says it flies if it is not the one whose names the trace has; else "".
std::string otherMission(const Trace& trace) {
  constexpr std::string_view kSaid = "the SBC answers: mission ";
  constexpr size_t kMostOnTheLine = 47;  // of a longer name the rest is not told
  for (const TraceEvent& event : trace.events) {
    if (!trace.state_names.empty() && event.kind == "link" && event.what.starts_with(kSaid)) {
      const std::string name = event.what.substr(kSaid.size());
      const bool same = name == trace.mission ||
                        (name.size() >= kMostOnTheLine && trace.mission.starts_with(name));
      return same ? "" : name;
    }
  }
  return "";
}

/// True if the flight ended because its time was over, with the mission still on its way.
bool wasCutShort(const Trace& trace) {
  const auto any = [&](std::string_view kind, std::string_view part) {
    return std::ranges::any_of(trace.events, [&](const TraceEvent& event) {
      return event.kind == kind && event.what.find(part) != std::string::npos;
    });
  };
  return !trace.state_names.empty() && any("log", "simulated time of") &&
         !any("transition", "(exit)");
}

std::string neverVisited(const Trace& trace) {
  const FlightFigures figures = flightFigures(trace);
  std::vector<std::string> names;
  for (size_t id = 0; id < trace.state_names.size(); ++id) {
    const bool visited = std::ranges::any_of(figures.states, [&](const StateFigures& state) {
      return state.id == static_cast<double>(id);
    });
    if (!visited) {
      names.push_back(plain(trace.state_names[id]));
    }
  }
  const size_t more = names.size() > kMostNames ? names.size() - kMostNames : 0;
  names.resize(names.size() - more);
  return names.empty() ? ""
                       : fmt::format("; never visited: {}{}", fmt::join(names, ", "),
                                     more == 0 ? "" : fmt::format(" and {} more", more));
}

/// The note of runtime/core/compass.cpp.
bool saysNoDeclination(const TraceEvent& event) {
  return event.kind == "log" && event.what == "declination unknown: headings are magnetic";
}

}  // namespace

bool wasNeverInControl(const Trace& trace) {
  const int active = trace.column("hook_active");
  if (trace.way.empty() || trace.way == "none" || active < 0) {
    return false;
  }
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    if (trace.at(row, active) == 1) {
      return false;
    }
  }
  return trace.rowCount() > 0;
}

size_t refusedInstructions(const Trace& trace) {
  return static_cast<size_t>(std::ranges::count_if(trace.events, isRefusal));
}

std::vector<std::string> flightWarnings(const Trace& trace) {
  std::vector<std::string> warnings;
  if (wasNeverInControl(trace)) {
    warnings.emplace_back("the mission was never in control");
  }
  if (const std::string other = otherMission(trace); !other.empty()) {
    warnings.push_back(
        fmt::format("the SBC flies mission {}, not {}: the names of its states are "
                    "those of the wrong mission",
                    plain(other), plain(trace.mission)));
  }
  if (const size_t refused = refusedInstructions(trace); refused > 0) {
    const auto first = std::ranges::find_if(trace.events, isRefusal);
    warnings.push_back(fmt::format("{} instruction{} refused, the first at {:.0f} s: {}", refused,
                                   refused == 1 ? "" : "s", first->time_s, plain(first->what)));
  }
  if (std::ranges::any_of(trace.events, saysNoDeclination)) {
    warnings.emplace_back(
        "the magnetic declination was not known: headings were taken as magnetic. The mission can "
        "say it, as `declination -12 deg` (GL2162)");
  }
  if (wasCutShort(trace)) {
    warnings.push_back(fmt::format("the mission had not ended when the simulated time was over{}",
                                   neverVisited(trace)));
  }
  return warnings;
}

}  // namespace glider::report
