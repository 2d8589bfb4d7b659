// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/promises.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::simulator {
namespace {

// The client no longer claims control after this many ticks without an answer.
constexpr double kUnansweredTicks = 6;
// How far a dive at 35 degrees continues past its target while the pump reverses it, with a wave.
constexpr double kOvershoot = 5;  // m, the platform's inflection_overshoot_m
constexpr double kTenMetres = 10;
constexpr double kOneAndAHalf = 1.5;

std::string controlText(Control control, const ControlTimes& times) {
  switch (control) {
    case Control::Kept:
      return "kept until the exit";
    case Control::Unanswered:
      return fmt::format("ends within {:.0f} s if an instruction gets no answer",
                         releaseSecs(control, times));
    case Control::Silent:
      return fmt::format("ends within {:.0f} s", releaseSecs(control, times));
    case Control::AtOnce:
      return "ends at once, until a new handshake";
    case Control::ForGood:
      return "ends at once, permanently";
    case Control::Any:
      break;
  }
  return "depends on the mission";
}

std::string deepestText(Deepest deepest) {
  switch (deepest) {
    case Deepest::OneAndAHalf:
      return fmt::format("{} times the limit", kOneAndAHalf);
    case Deepest::TenMetres:
      return fmt::format("{} m past the limit", kTenMetres);
    case Deepest::Sinks:
      return fmt::format("{} m past the limit, and what it sinks in `takes_s`", kOvershoot);
    case Deepest::Overshoot:
      break;
  }
  return fmt::format("{} m past the limit", kOvershoot);
}

}  // namespace

std::vector<FaultKind> allFaultKinds() {
  return {
#define FAULT_KIND(name, ...) FaultKind::name,
#include "simulator/campaign/fault_kinds.def"
  };
}

const char* nameOf(FaultKind kind) {
  switch (kind) {
#define FAULT_KIND(name, text, ...) \
  case FaultKind::name:             \
    return text;
#include "simulator/campaign/fault_kinds.def"
  }
  return "";
}

Promise promiseOf(FaultKind kind) {
  switch (kind) {
#define FAULT_KIND(name, text, control, depth, clearance, follows) \
  case FaultKind::name:                                            \
    return {Control::control, Deepest::depth, clearance, follows};
#include "simulator/campaign/fault_kinds.def"
  }
  return {};
}

bool isOfSensors(FaultKind kind) {
  return promiseOf(kind).deepest >= Deepest::TenMetres;
}

bool leavesTheSbc(FaultKind kind) {
  const Control control = promiseOf(kind).control;
  return kind != FaultKind::Clock && kind != FaultKind::Several &&
         (control == Control::Kept || control == Control::Any);
}

Promise promiseOf(std::span<const FaultKind> kinds) {
  Promise all;
  for (const FaultKind kind : kinds) {
    if (kind == FaultKind::Several && kinds.size() > 1) {
      continue;
    }
    const Promise one = promiseOf(kind);
    all.control = std::max(all.control, one.control);
    all.deepest = std::max(all.deepest, one.deepest);
    all.clearance = all.clearance && one.clearance;
    all.follows = all.follows && one.follows;
  }
  const auto wrong = std::ranges::count_if(
      kinds, [](FaultKind kind) { return kind != FaultKind::Several && isOfSensors(kind); });
  if (wrong > 1) {
    all.deepest = Deepest::OneAndAHalf;
  }
  return all;
}

double deepestAllowed(Deepest deepest, double limit_m) {
  return deepest == Deepest::OneAndAHalf
             ? std::max(limit_m * kOneAndAHalf, limit_m + kTenMetres)
             : limit_m + (deepest == Deepest::TenMetres ? kTenMetres : kOvershoot);
}

double releaseSecs(Control control, const ControlTimes& times) {
  // The last heartbeat may still be on the line.
  const double silent = times.lag_s + times.silence_s + 2 * times.cycle_s;
  return control == Control::Unanswered ? silent + kUnansweredTicks * times.cycle_s : silent;
}

std::string promiseTable(const ControlTimes& times) {
  std::string table;
  for (uint32_t i = 0; i < kFaultKinds; ++i) {
    const auto kind = static_cast<FaultKind>(i);
    const Promise promise = promiseOf(kind);
    table += fmt::format("| {} | {} | {} | {} | {} |\n", nameOf(kind),
                         controlText(promise.control, times), deepestText(promise.deepest),
                         promise.clearance ? "kept" : "one contact a place, without an echo",
                         promise.follows ? "yes" : "not guaranteed");
  }
  return table;
}

}  // namespace glider::simulator
