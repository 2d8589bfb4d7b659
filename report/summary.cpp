// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/summary.h"

#include "report/figures.h"
#include "report/text.h"
#include "report/warnings.h"
#include "support/grouped.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace glider::report {

namespace {

using support::EventKind;
using support::Trace;
using support::TraceEvent;

constexpr size_t kWidth = 100;
constexpr size_t kMostEvents = 60;  // of each of the two lists; the page and the CSV have them all
constexpr size_t kMostStates = 40;

std::string wayName(const std::string& way, const std::string& own_control) {
  if (way == "in-process") {
    return "in process";
  }
  if (way == "none") {
    return "by " + plain(own_control) + " alone";
  }
  return way.empty() ? "" : "on " + plain(way);
}

std::string heading(const Trace& trace) {
  std::string out = trace.mission.empty() ? "flight" : plain(trace.mission);
  const std::string way = wayName(trace.way, trace.own_control);
  out += trace.scenario.empty() ? "" : fmt::format(", scenario {}", plain(trace.scenario));
  out += way.empty() ? "" : fmt::format(", flown {}", way);
  out += fmt::format(", seed {}", trace.seed);
  return wrapped(out, kWidth, 2);
}

std::string lengthText(double metres) {
  constexpr double kKilometre = 1000;
  return metres < kKilometre ? fmt::format("{:.0f} m", metres)
                             : fmt::format("{:.1f} km", metres / kKilometre);
}

/// "0.61 %", "22.4 %".
std::string percentText(double share) {
  constexpr double kPercent = 100, kSmall = 0.1;
  return share < kSmall ? fmt::format("{:.2f} %", kPercent * share)
                        : fmt::format("{:.1f} %", kPercent * share);
}

/// "3.9 h", "4.2 days", "20 days".
std::string daysText(double days) {
  constexpr double kHoursPerDay = 24, kFew = 2, kMany = 10;
  return days < kFew    ? fmt::format("{:.1f} h", days * kHoursPerDay)
         : days < kMany ? fmt::format("{:.1f} days", days)
                        : fmt::format("{:.0f} days", days);
}

/// A flight may go on after its mission has ended, and hookbeh's guards are not in the bound.
std::string boundText(const EnergyFigures& energy) {
  const bool beyond = energy.capacity_Wh > 0 && energy.atMost_Wh() > energy.capacity_Wh;
  return fmt::format(
      "at most {} Wh until the mission ends{}{}", support::atMost(energy.atMost_Wh()),
      beyond ? fmt::format(", more than the {:.0f} Wh of a full pack", energy.capacity_Wh) : "",
      energy.used_Wh > energy.atMost_Wh()
          ? "; the flight took more, after its end or by what no bound counts"
          : "");
}

/// "12.3 Wh used, 0.61 % of the pack; 2208.6 Wh to go (99.4 %), 20 days at this rate".
std::string energyText(const EnergyFigures& energy) {
  std::string text = fmt::format("{:.1f} Wh used", energy.used_Wh);
  if (energy.partly_known) {
    text += fmt::format(" in {} of the flight, not known for the rest", clockText(energy.known_s));
  }
  if (energy.capacity_Wh > 0) {
    text += fmt::format(", {} of the pack; {:.1f} Wh to go ({})",
                        percentText(energy.used_Wh / energy.capacity_Wh), energy.to_go_Wh,
                        percentText(energy.to_go_Wh / energy.capacity_Wh));
  }
  if (std::isfinite(energy.days_left)) {
    text += fmt::format(", {} at this rate", daysText(energy.days_left));
  }
  return text;
}

/// "SBC 60 %, hotel 23 %, pump 15 %, others 2 %".
std::string consumersText(const EnergyFigures& energy) {
  constexpr double kLeastShare = 0.01;
  std::string text;
  double others_Wh = 0;
  const auto add = [&](std::string_view name, double used_Wh) {
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", name,
                        100 * used_Wh / energy.used_Wh);
  };
  for (const support::Consumer& one : energy.consumers) {
    if (one.used_Wh < kLeastShare * energy.used_Wh) {
      others_Wh += one.used_Wh;
    } else {
      add(one.device, one.used_Wh);
    }
  }
  constexpr double kShown = 0.005;
  if (others_Wh > kShown * energy.used_Wh) {
    add("others", others_Wh);
  }
  return text;
}

/// "10 yos", "3 yos and 18 swings about the depth of a hover".
std::string yosText(const FlightFigures& figures) {
  const auto counted = [](size_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  const std::string yos = counted(figures.yos, "yo");
  const std::string swings = counted(figures.swings, "swing") + " about the depth of a hover";
  return figures.swings == 0 ? yos : figures.yos == 0 ? swings : yos + " and " + swings;
}

constexpr std::string_view kSavesNothing = "; it saves nothing: no lower `asleep_W` is given";

std::string figureLines(const FlightFigures& figures) {
  std::string out;
  const auto line = [&out](std::string_view label, const std::string& value) {
    out += fmt::format("  {:<13}{}\n", label, value);
  };
  if (std::isfinite(figures.duration_s)) {
    line("duration",
         fmt::format("{} ({:.0f} s)", clockText(figures.duration_s), figures.duration_s));
  }
  if (std::isfinite(figures.deepest_m)) {
    line("depth", fmt::format("{:.1f} to {:.1f} m, {}", figures.shallowest_m, figures.deepest_m,
                              yosText(figures)));
  }
  if (std::isfinite(figures.distance_m)) {
    line("distance",
         fmt::format("{:.0f} m over ground{}, {:.0f} m made good", figures.distance_m,
                     figures.track == TrackSource::DeadReckoned ? " (dead reckoned)" : "",
                     figures.made_good_m));
  }
  if (std::isfinite(figures.apart_m)) {
    line("position", fmt::format("dead-reckoned and true position up to {} apart",
                                 lengthText(figures.apart_m)));
  }
  if (std::isfinite(figures.energy.used_Wh)) {
    line("energy", energyText(figures.energy));
  }
  if (!figures.energy.consumers.empty()) {
    line("  of it", consumersText(figures.energy));
  }
  if (!figures.energy.at_most.empty()) {
    line("  bound", boundText(figures.energy));
  }
  if (figures.sleeps > 0) {
    line("SBC asleep",
         fmt::format("{} of the flight, {} time{}{}",
                     percentText(figures.asleep_s / figures.duration_s), figures.sleeps,
                     figures.sleeps == 1 ? "" : "s", figures.sleep_saves ? "" : kSavesNothing));
  }
  if (std::isfinite(figures.warmest_degC)) {
    line("temperature",
         fmt::format("{:.1f} to {:.1f} degC", figures.coldest_degC, figures.warmest_degC));
  }
  return out;
}

std::string stateLines(const FlightFigures& figures, const Trace& trace) {
  if (figures.states.empty() && !(figures.stateless_s > 0)) {
    return "";
  }
  const std::string own_control = "(" + plain(trace.own_control) + ")";
  size_t column = std::max(width(own_control), std::string_view("(SBC, no state)").size());
  for (const StateFigures& state : figures.states) {
    column = std::max(column, std::min<size_t>(width(plain(state.name)), 56));
  }
  std::string out = fmt::format("\n{}current       time  share\n", padded("states", column + 2));
  const auto line = [&](const std::string& name, const std::string& stretches, double time_s) {
    const double share = figures.duration_s > 0 ? 100.0 * time_s / figures.duration_s : 0.0;
    out += fmt::format("  {}{:>7} {:>8.0f} s {:>4.0f} %\n", padded(cut(name, column), column),
                       stretches, time_s, share);
  };
  for (size_t i = 0; i < std::min(figures.states.size(), kMostStates); ++i) {
    const StateFigures& state = figures.states[i];
    line(plain(state.name), fmt::format("{}", state.stretches), state.time_s);
  }
  if (figures.states.size() > kMostStates) {
    out += fmt::format("  and {} more\n", figures.states.size() - kMostStates);
  }
  if (figures.stateless_s > 0) {
    line("(SBC, no state)", "", figures.stateless_s);
  }
  if (figures.layered_s > 0) {
    line(own_control, "", figures.layered_s);
  }
  return out;
}

/// Whether a transition led to the state or from it: it may have been current for one tick only, of
/// which the trace has no row.
bool wasLeft(const Trace& trace, const std::string& name) {
  return std::ranges::any_of(trace.events, [&](const TraceEvent& event) {
    const bool moved = event.id == EventId::Transition || event.id == EventId::MissionEnds;
    return moved &&
           std::ranges::find(event.values, support::EventValue(name)) != event.values.end();
  });
}

/// The states of the mission that were never current; empty: all were.
std::string neverEntered(const FlightFigures& figures, const Trace& trace) {
  constexpr size_t kNamed = 8;
  std::vector<std::string> names;
  for (size_t id = 0; id < trace.state_names.size() && !figures.states.empty(); ++id) {
    const auto entered = [&](const StateFigures& state) {
      return state.id == static_cast<double>(id);
    };
    if (std::ranges::none_of(figures.states, entered) && !wasLeft(trace, trace.state_names[id])) {
      names.push_back("`" + plain(trace.state_names[id]) + "`");
    }
  }
  if (names.empty()) {
    return "";
  }
  const size_t left = names.size() - std::min(names.size(), kNamed);
  names.resize(names.size() - left);
  return wrapped(fmt::format("  never entered in this flight: {}{}", fmt::join(names, ", "),
                             left == 0 ? "" : fmt::format(" and {} more", left)),
                 kWidth, 4);
}

std::string secondsText(double seconds) {
  return std::isfinite(seconds) ? fmt::format("{:.0f} s", seconds) : "-";
}

std::string eventLine(const TraceEvent& event, bool with_kind) {
  const std::string times =
      fmt::format("  {:>9} {:>9}  ", secondsText(event.time_s), secondsText(event.mission_time_s));
  const std::string kind = with_kind ? padded(cut(plain(kindOf(event)), 12), 12) : "";
  const size_t indent = times.size() + width(kind);
  const std::string what = plain(shownTextOf(event));
  const std::string why = plain(event.why);
  if (indent + width(what) + 2 + width(why) <= kWidth) {
    return fmt::format("{}{}{}{}\n", times, kind, what, why.empty() ? "" : "  " + why);
  }
  std::string out = wrapped(times + kind + what, kWidth, indent + 2);
  if (!why.empty()) {
    out += wrapped(std::string(indent + 2, ' ') + why, kWidth, indent + 2);
  }
  return out;
}

/// Routine steering would hide what matters; it is in the report. So would the turns of the
/// vehicle's own yo, while the SBC's mission sets its depths.
bool isRoutine(const TraceEvent& event) {
  return isOfKind(event, EventKind::Steering) ||
         (event.id == EventId::LegOver && std::isfinite(event.mission_time_s));
}

std::string eventLines(const Trace& trace, bool transitions) {
  std::string out;
  size_t count = 0;
  for (const TraceEvent& event : trace.events) {
    if (isOfKind(event, EventKind::Transition) != transitions || isRoutine(event)) {
      continue;
    }
    if (++count <= kMostEvents) {
      out += eventLine(event, !transitions);
    }
  }
  if (count == 0) {
    return "";
  }
  if (count > kMostEvents) {
    out += fmt::format("  and {} more: see the report\n", count - kMostEvents);
  }
  return fmt::format("\n{}\n       time   mission\n{}",
                     transitions ? "transitions" : "other events", out);
}

}  // namespace

std::string summarize(const Trace& trace) {
  const FlightFigures figures = flightFigures(trace);
  std::string out = heading(trace);
  for (const std::string& note : flightNotes(trace)) {
    out += wrapped("  note: " + note, kWidth, 4);
  }
  out += figures.rows == 0 ? "  nothing was recorded\n" : figureLines(figures);
  out += stateLines(figures, trace);
  out += neverEntered(figures, trace);
  out += eventLines(trace, true);
  out += eventLines(trace, false);
  return out;
}

}  // namespace glider::report
