// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/warnings.h"

#include "report/figures.h"
#include "report/text.h"
#include "support/diagnostics/ids/flights.h"
#include "support/diagnostics/ids/vehicle.h"
#include "support/utc.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace glider::report {
namespace {

using support::EventId;
using support::Trace;
using support::TraceEvent;

constexpr size_t kMostNames = 20;

/// A value of an event that is a text.
std::string textValue(const TraceEvent& event, size_t number) {
  return std::get<std::string>(event.values.at(number));
}

/// "1250 s", or for a log the UTC.
std::string timeText(const Trace& trace, double time_s) {
  return trace.log ? support::utcText(trace.log->utc_s + time_s) + " UTC"
                   : fmt::format("{:.0f} s", time_s);
}

/// The time, as timeText() writes it, of the first of `trace`'s events of a kind, and "; 3 times in
/// all".
struct EventMention {
  const TraceEvent* first = nullptr;
  std::string at;
  std::string more;
};

EventMention tell(const Trace& trace, EventId id) {
  EventMention told;
  const auto count = std::ranges::count(trace.events, id, &TraceEvent::id);
  if (count > 0) {
    told.first = &*std::ranges::find(trace.events, id, &TraceEvent::id);
    told.at = timeText(trace, told.first->time_s);
    told.more = count > 1 ? fmt::format("; {} times in total", count) : "";
  }
  return told;
}

/// The mission that the SBC reports, if it is not the one whose names the trace has; otherwise "".
std::string otherMission(const Trace& trace) {
  constexpr size_t kMostOnTheLine = 47;  // a longer name is cut
  for (const TraceEvent& event : trace.events) {
    if (!trace.state_names.empty() && event.id == EventId::SbcAnswers) {
      const std::string name = textValue(event, 0);
      const bool same = name == trace.mission ||
                        (name.size() >= kMostOnTheLine && trace.mission.starts_with(name));
      return same ? "" : name;
    }
  }
  return "";
}

/// Vehicle time of the end of the mission; none: it has not ended.
std::optional<double> endOf(const Trace& trace) {
  const auto end = std::ranges::find(trace.events, EventId::MissionEnds, &TraceEvent::id);
  return end == trace.events.end() ? std::nullopt : std::optional(end->time_s);
}

/// Whether the flight ended because its time was over, before the mission ended.
bool wasCutShort(const Trace& trace) {
  return !trace.state_names.empty() && tell(trace, EventId::TimeIsOver).first != nullptr &&
         !endOf(trace);
}

/// Vehicle time at which the mission took control; none: never.
std::optional<double> controlOf(const Trace& trace) {
  const int active = trace.column("hook_active");
  for (size_t row = 0; active >= 0 && row < trace.rowCount(); ++row) {
    if (trace.at(row, active) == 1) {
      return trace.at(row, 0);
    }
  }
  return std::nullopt;
}

std::string neverVisited(const Trace& trace) {
  if (!controlOf(trace)) {
    return "; it was never in control of the vehicle";
  }
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
  return names.empty()
             ? ""
             : fmt::format("; never visited (the time was too short, or no case led there): {}{}",
                           fmt::join(names, ", "),
                           more == 0 ? "" : fmt::format(" and {} more", more));
}

/// Which requirements the flight was too short for; empty: none.
std::string notDecided(const Trace& trace) {
  std::string list;
  std::string why;
  for (const support::FlownPromise& promise : trace.facts.promises) {
    if (promise.verdict == support::Verdict::Undecided) {
      list += fmt::format("{}`{}`", list.empty() ? "" : ", ", plain(promise.text));
      why = promise.words;
    }
  }
  return list.empty() ? "" : fmt::format("not decided, {}: {}", why, list);
}

/// When `count` transitions within `within_s` seconds begin; none: never.
std::optional<double> restlessFrom(const Trace& trace, size_t count, double within_s) {
  std::vector<double> times;
  for (const TraceEvent& event : trace.events) {
    if (event.id == EventId::Transition || event.id == EventId::MissionEnds) {
      times.push_back(event.time_s);
    }
    const bool enough = times.size() >= count;
    if (enough && times.back() - times[times.size() - count] <= within_s) {
      return times[times.size() - count];
    }
  }
  return std::nullopt;
}

std::string largestConsumer(const Trace& trace) {
  if (!trace.battery || trace.battery->consumers.empty()) {
    return "";
  }
  return plain(
      std::ranges::max_element(trace.battery->consumers, {}, &support::Consumer::used_Wh)->device);
}

/// The end of a simulated flight.
struct LastRow {
  double depth_m = 0, clearance_m = 0;
};

/// None for a log, or a trace without the true depth.
std::optional<LastRow> lastRowOf(const Trace& trace) {
  const int depth = trace.column("true_depth"), water = trace.column("water_depth");
  if (trace.log || depth < 0 || water < 0 || trace.rowCount() == 0) {
    return std::nullopt;
  }
  const size_t last = trace.rowCount() - 1;
  return LastRow{trace.at(last, depth), trace.at(last, water) - trace.at(last, depth)};
}

/// Reports a flight in which the batteries ran out.
void reportEmpty(const Trace& trace, support::DiagnosticEngine& diagnostics) {
  if (const EventMention told = tell(trace, EventId::PackEmpty); told.first != nullptr) {
    const std::string most = largestConsumer(trace);
    diagnostics.report(support::diagnostics::packEmpty, {}, told.at,
                       fmt::format("{:.1f}", std::get<double>(told.first->values.at(0))),
                       most.empty() ? "" : fmt::format("most went to: {}", most));
  }
}

/// Reports a flight that ended on the bottom, or whose abort did not bring the vehicle up.
void reportEnd(const Trace& trace, support::DiagnosticEngine& diagnostics) {
  constexpr double kTouches = 0.5, kAfloat = 1;  // m
  const auto last = lastRowOf(trace);
  if (!last || !(last->depth_m > kAfloat)) {
    return;
  }
  const EventMention abort = tell(trace, EventId::Aborts);
  if (last->clearance_m < kTouches) {
    diagnostics.report(support::diagnostics::endedOnBottom, {},
                       fmt::format("{:.0f}", last->depth_m),
                       abort.first != nullptr ? ", after the mission was aborted" : "");
  } else if (abort.first != nullptr) {
    diagnostics.report(support::diagnostics::notUpAfterAbort, {}, abort.at,
                       fmt::format("{:.0f}", last->depth_m));
  }
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

bool spokeTheProtocol(const Trace& trace) {
  return tell(trace, EventId::SbcAnswers).first != nullptr;
}

size_t refusedInstructions(const Trace& trace) {
  return static_cast<size_t>(
      std::ranges::count(trace.events, EventId::InstructionRefused, &TraceEvent::id));
}

void reportFlight(const Trace& trace, support::DiagnosticEngine& diagnostics,
                  const std::string& port_folder) {
  if (wasNeverInControl(trace)) {
    const bool spoke = spokeTheProtocol(trace);
    const std::string hint =
        spoke ? "see the events for how far the SBC and the vehicle got"
        : port_folder.empty()
            ? "the SBC never used this version of the hook protocol: check that the program or "
              "device runs a mission"
            : fmt::format(
                  "the SBC never wrote to the port: `glidercc dock {} --port DEVICE` checks "
                  "the program and the line",
                  port_folder);
    diagnostics.report(support::diagnostics::neverInControl, {}, hint);
  }
  if (const EventMention told = tell(trace, EventId::ScienceProgramEnds); told.first != nullptr) {
    diagnostics.report(support::diagnostics::scienceProgramEnds, {}, told.at,
                       plain(textValue(*told.first, 0)) + told.more);
  }
  if (const EventMention told = tell(trace, EventId::Aborts); told.first != nullptr) {
    const std::string why = told.first->why.empty() ? "" : ", " + plain(told.first->why);
    diagnostics.report(support::diagnostics::flightAborted, {}, told.at,
                       plain(shownTextOf(*told.first)) + why + told.more);
  }
  reportEmpty(trace, diagnostics);
  reportEnd(trace, diagnostics);
  if (const EventMention told = tell(trace, EventId::TouchesBottom); told.first != nullptr) {
    diagnostics.report(support::diagnostics::bottomTouched, {}, told.at,
                       plain(told.first->why) + told.more);
  }
  if (const EventMention told = tell(trace, EventId::InstructionRefused); told.first != nullptr) {
    diagnostics.report(support::diagnostics::commandRefused, {}, told.at,
                       plain(textValue(*told.first, 1)) + told.more);
  }
  if (const EventMention told = tell(trace, EventId::GuardClimbs); told.first != nullptr) {
    const double depth_m = std::get<double>(told.first->values.at(1));
    diagnostics.report(support::diagnostics::guardIntervened, {}, told.at,
                       fmt::format("{} (m_depth {:.1f} m){}", plain(textValue(*told.first, 0)),
                                   depth_m, told.more));
  }
}

void reportRestless(const Trace& trace, const std::string& hint,
                    support::DiagnosticEngine& diagnostics) {
  constexpr double kShort_s = 300;
  constexpr size_t kMany = 20;
  if (const auto from = restlessFrom(trace, kMany, kShort_s)) {
    diagnostics.report(
        support::diagnostics::flightUnusual, {},
        fmt::format("from {} on the mission changed its state {} times within {:.0f} min",
                    timeText(trace, *from), kMany, kShort_s / 60),
        hint);
  }
}

void reportUnusual(const Trace& trace, const std::string& hint,
                   support::DiagnosticEngine& diagnostics) {
  constexpr double kSoon_s = 60;
  if (wasCutShort(trace)) {
    diagnostics.report(
        support::diagnostics::flightUnusual, {},
        "the mission had not ended when the simulated time was up" + neverVisited(trace), hint);
  }
  const auto control = controlOf(trace);
  const auto end = endOf(trace);
  if (control && end && *end - *control < kSoon_s) {
    diagnostics.report(
        support::diagnostics::flightUnusual, {},
        fmt::format("the mission ended {:.0f} s after it had taken control", *end - *control),
        hint);
  }
  reportRestless(trace, hint, diagnostics);
}

std::vector<std::string> flightNotes(const Trace& trace) {
  std::vector<std::string> notes;
  if (trace.log) {
    return trace.log->notes;
  }
  if (const std::string other = otherMission(trace); !other.empty()) {
    notes.push_back(
        fmt::format("the SBC flies mission {}, not {}, so the state names shown are "
                    "wrong",
                    plain(other), plain(trace.mission)));
  }
  if (tell(trace, EventId::DeclinationUnknown).first != nullptr) {
    notes.emplace_back(
        "the magnetic declination was unknown, so headings were taken as magnetic; add a line such "
        "as `declination -12 deg` to the mission (GL2162)");
  }
  if (wasCutShort(trace)) {
    notes.push_back(
        "the mission had not ended when the simulated time was up (`--duration` flies longer)" +
        neverVisited(trace));
  }
  if (const std::string undecided = notDecided(trace); !undecided.empty()) {
    notes.push_back(undecided);
  }
  return notes;
}

std::string warningsToJson(const std::vector<support::Diagnostic>& reported,
                           const std::vector<std::string>& others) {
  using nlohmann::json;
  json out = json::array();
  for (const support::Diagnostic& d : reported) {
    out.push_back({{"code", support::code(d.id)},
                   {"slug", support::catalogueRow(d.id).slug},
                   {"message", d.message},
                   {"hint", d.hint}});
  }
  for (const std::string& text : others) {
    out.push_back({{"code", ""}, {"slug", ""}, {"message", text}, {"hint", ""}});
  }
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace glider::report
