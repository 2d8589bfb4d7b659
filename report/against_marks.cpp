// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/against_marks.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::report {
namespace {

/// A requirement or an assumption, which is `guard`.
bool isBroken(const FollowedStep& step) {
  return step.kind == "violation" || step.kind == "assumption";
}

std::string stepText(const FollowedStep& step) {
  if (step.kind == "start") {
    return fmt::format("the mission would have started in {}", step.to);
  }
  if (isBroken(step)) {
    return fmt::format("{} `{}`{}{}", step.kind == "violation" ? "violates" : "breaks", step.guard,
                       step.words.empty() ? "" : ": ", step.words);
  }
  if (step.kind == "gap") {
    return fmt::format("the log has a gap: the mission would have ended in {}", step.from);
  }
  return fmt::format("{} → {} ({}{})", step.from, step.to.empty() ? "end" : step.to, step.kind,
                     step.always ? ", always" : "");
}

std::string whyText(const FollowedStep& step) {
  const std::string values = loggedValues(step.at, step.values);
  return isBroken(step) || step.guard.empty() ? values : fmt::format("{} ({})", step.guard, values);
}

std::string flickerText(const LoggedCase& of, const Flicker& flicker) {
  return fmt::format("{} flickers: true {} times within {:.0f} s",
                     of.state.empty() ? "a guard of `always`" : "a guard of " + of.state,
                     flicker.count, flicker.seconds);
}

}  // namespace

void markAgainst(const std::string& mission, const AgainstLogs& against, support::Trace& flight) {
  const auto add = [&](double utc_s, const char* kind, std::string what, std::string why) {
    support::TraceEvent event;
    event.time_s = utc_s - flight.log->utc_s;
    event.kind = kind;
    event.what = std::move(what);
    event.why = std::move(why);
    flight.events.push_back(std::move(event));
  };
  for (const FollowedStep& step : against.followed) {
    if (step.kind != "stay") {
      add(step.at.time_s, "transition", stepText(step), whyText(step));
    }
  }
  for (const LoggedCase& of : against.cases) {
    for (const Flicker& flicker : of.flickers) {
      add(of.firings[flicker.first].at.time_s, "guard", flickerText(of, flicker), of.guard);
    }
  }
  std::ranges::stable_sort(flight.events, {}, &support::TraceEvent::time_s);
  flight.log->notes.push_back(fmt::format(
      "Transitions are those that the mission {} would have made; the vehicle did not obey it.",
      mission));
}

}  // namespace glider::report
