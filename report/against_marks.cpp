// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/against_marks.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::report {
namespace {

using support::EventId;
using support::makeEvent;
using support::TraceEvent;

/// A requirement or an assumption, which is `guard`.
bool isBroken(const FollowedStep& step) {
  return step.kind == FollowedKind::Violation || step.kind == FollowedKind::Assumption;
}

std::string whyText(const FollowedStep& step) {
  const std::string values = loggedValues(step.at, step.values);
  return isBroken(step) || step.guard.empty() ? values : fmt::format("{} ({})", step.guard, values);
}

TraceEvent eventOf(const FollowedStep& step, double time_s) {
  std::string why = whyText(step);
  if (step.kind == FollowedKind::Start) {
    return makeEvent(time_s, EventId::WouldStart, {step.to}, std::move(why));
  }
  if (isBroken(step)) {
    const bool required = step.kind == FollowedKind::Violation;
    return makeEvent(time_s, required ? EventId::RequirementBroken : EventId::AssumptionBroken,
                     {step.guard, step.words.empty() ? "" : ": " + step.words}, std::move(why));
  }
  if (step.kind == FollowedKind::Gap) {
    return makeEvent(time_s, EventId::WouldEndInGap, {step.from}, std::move(why));
  }
  const std::string how = std::string(wordOf(step.kind)) + (step.always ? ", always" : "");
  return step.kind == FollowedKind::Exit
             ? makeEvent(time_s, EventId::MissionEnds, {step.from, how}, std::move(why))
             : makeEvent(time_s, EventId::Transition, {step.from, step.to, how}, std::move(why));
}

TraceEvent eventOf(const LoggedCase& of, const Flicker& flicker, double time_s) {
  return makeEvent(time_s, EventId::GuardFlickers,
                   {of.state.empty() ? "a guard of `always`" : "a guard of " + of.state,
                    static_cast<double>(flicker.count), flicker.seconds},
                   of.guard);
}

}  // namespace

void markAgainst(const std::string& mission, const AgainstLogs& against, support::Trace& flight) {
  const double began_s = flight.log->utc_s;
  for (const FollowedStep& step : against.followed) {
    if (step.kind != FollowedKind::Stay) {
      flight.events.push_back(eventOf(step, step.at.time_s - began_s));
    }
  }
  for (const LoggedCase& of : against.cases) {
    for (const Flicker& flicker : of.flickers) {
      const double time_s = of.firings[flicker.first].at.time_s - began_s;
      flight.events.push_back(eventOf(of, flicker, time_s));
    }
  }
  std::ranges::stable_sort(flight.events, {}, &support::TraceEvent::time_s);
  flight.log->notes.push_back(fmt::format(
      "Transitions are those that the mission {} would have made; the vehicle did not obey it.",
      mission));
}

}  // namespace glider::report
