// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/port_judge.h"

#include "hooks/extctl/pairs.h"
#include "hooks/extctl/port.h"
#include "simulator/slocum/own_mission.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace glider::slocum::oracles {
namespace {

using hooks::extctl::PortSensor;
using simulator::JudgeId;
using simulator::Verdict;

/// Above, the vehicle is at the surface, m.
constexpr double kSurface = 1;
/// Nearer, it is on the bottom, m.
constexpr double kTouches = 0.1;
/// A flight is over when the SBC's mission has ended and the vehicle has floated for so long, s.
constexpr double kSettled = 300;

}  // namespace

const MissionFile* portFileIn(const simulator::Scenario& scenario) {
  const simulator::SlocumMission& own = simulator::slocumMissionOf(scenario);
  return own.extctl ? &own.file : nullptr;
}

std::optional<double> programDepthIn(const simulator::Scenario& scenario) {
  return simulator::slocumMissionOf(scenario).program_depth_m;
}

void PortJudge::said(std::span<const uint8_t> bytes, double now_s) {
  for (const uint8_t byte : bytes) {
    if (sentences_.push(byte) &&
        std::string_view(sentences_.body(), sentences_.size()).starts_with("SW,")) {
      hear(sentences_.body() + 3, sentences_.size() - 3, now_s);
    }
  }
}

/// The state of the mission, from 1 while it flies, and the target of its dives.
void PortJudge::hear(const char* pairs, uint32_t size, double now_s) {
  hooks::extctl::PairReader reader(pairs, size);
  for (hooks::extctl::Pair pair; reader.next(&pair);) {
    if (pair.index == static_cast<uint32_t>(PortSensor::DiveDepth)) {
      verdict_.instructions += pair.value != dive_m_ ? 1 : 0;
      dive_m_ = pair.value;
    }
    if (pair.index != static_cast<uint32_t>(PortSensor::State)) {
      continue;
    }
    const bool flies = pair.value > 0;
    if (flies && verdict_.take_s == 0) {
      verdict_.take_s = now_s;
    }
    ended_ = !flies && verdict_.take_s > 0;
    if (ended_ && verdict_.release_s == 0) {
      verdict_.release_s = now_s;
    }
  }
}

void PortJudge::violate(JudgeId judge, double now_s, std::string what) {
  const bool seen = std::ranges::any_of(
      verdict_.violations, [&](const auto& violation) { return violation.judge == judge; });
  if (seen) {
    return;
  }
  if (verdict_.violations.empty()) {
    verdict_.violation = what;
    verdict_.violation_s = now_s;
  }
  verdict_.violations.push_back({judge, now_s, std::move(what)});
}

bool PortJudge::cycle(const simulator::CycleView& view) {
  const double now_s = view.time_s;
  verdict_.end_s = now_s;
  verdict_.deepest_m = std::max(verdict_.deepest_m, view.true_depth_m);
  verdict_.mean_W = now_s > 0 ? view.used_J / now_s : 0;
  const bool floats = view.true_depth_m < kSurface;
  floats_s_ = !floats ? -1 : floats_s_ < 0 ? now_s : floats_s_;
  up_s_ = floats ? now_s : up_s_;
  if (view.true_depth_m > promise_.deepest_m) {
    violate(JudgeId::Depth, now_s,
            fmt::format("{:.1f} m deep, at most {:.1f} m", view.true_depth_m, promise_.deepest_m));
  }
  if (promise_.sees_bottom && !floats && view.clearance_m < kTouches) {
    violate(JudgeId::Bottom, now_s, fmt::format("on the bottom at {:.1f} m", view.true_depth_m));
  }
  if (now_s - up_s_ > promise_.under_s + promise_.cycle_s) {
    violate(
        JudgeId::Surface, now_s,
        fmt::format("under water for {:.0f} s, at most {:.0f} s", now_s - up_s_, promise_.under_s));
  }
  if (view.aborted && !promise_.may_abort) {
    violate(JudgeId::Ending, now_s, "the vehicle has aborted its mission");
  }
  const bool over = ended_ || view.ended || view.aborted;
  return !(over && floats && now_s - floats_s_ >= kSettled);
}

Verdict PortJudge::verdict() const {
  Verdict verdict = verdict_;
  verdict.outcome = !verdict.violations.empty() ? Verdict::Outcome::Violation
                    : ended_                    ? Verdict::Outcome::Exited
                                                : Verdict::Outcome::Released;
  return verdict;
}

}  // namespace glider::slocum::oracles
