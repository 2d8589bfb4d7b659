// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/floating_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace glider::simulator {
namespace {

/// Above, the vehicle is at the surface, m.
constexpr double kSurface_m = 1;
/// A flight is over when control has ended and the vehicle has floated for so long, s.
constexpr double kSettled_s = 60;

}  // namespace

void FloatingJudge::takeCommand(double depth_m, bool whole, double now_s) {
  ++verdict_.instructions;
  told_s_ = now_s;
  stopped_m_ = -1;
  verdict_.take_s = verdict_.take_s == 0 ? now_s : verdict_.take_s;
  deepest_told_m_ = std::max(deepest_told_m_, depth_m);
  if (!whole || !(depth_m <= promise_.greatest_depth_m)) {
    violate(JudgeId::Commands, now_s,
            fmt::format("a {} to {:.1f} m, at most {:.1f} m", command_, depth_m,
                        promise_.greatest_depth_m));
  }
}

void FloatingJudge::takeEnd(bool ends, double now_s) {
  ended_ = ends;
  if (ended_ && verdict_.release_s == 0) {
    verdict_.release_s = now_s;
  }
}

void FloatingJudge::violate(JudgeId judge, double now_s, std::string what) {
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

/// Without commands it is no deeper than it can be by floating up since the propeller stopped.
void FloatingJudge::checkSilence(const CycleView& view) {
  const double silent_s = view.time_s - told_s_;
  if (told_s_ < 0 || silent_s <= promise_.lets_go_s) {
    return;
  }
  if (stopped_m_ < 0) {
    stopped_m_ = view.true_depth_m;
    stopped_s_ = view.time_s;
    verdict_.releases += ended_ ? 0 : 1;
  }
  const double rising_s = std::max(0.0, view.time_s - stopped_s_ - promise_.turn_s);
  const double most_m =
      std::max(kSurface_m, stopped_m_ + promise_.overshoot_m - promise_.rises_m_s * rising_s);
  if (view.true_depth_m > most_m) {
    violate(JudgeId::Ascent, view.time_s,
            fmt::format("{:.1f} m deep, {:.0f} s after the last {}, at most {:.1f} m",
                        view.true_depth_m, silent_s, command_, most_m));
  }
}

bool FloatingJudge::cycle(const CycleView& view) {
  const double now_s = view.time_s;
  verdict_.end_s = now_s;
  verdict_.deepest_m = std::max(verdict_.deepest_m, view.true_depth_m);
  verdict_.mean_W = now_s > 0 ? view.used_J / now_s : 0;
  const double deepest_m = deepest_told_m_ + promise_.overshoot_m;
  if (view.true_depth_m > std::max(deepest_m, kSurface_m)) {
    violate(JudgeId::Depth, now_s,
            fmt::format("{:.1f} m deep, at most {:.1f} m", view.true_depth_m, deepest_m));
  }
  checkSilence(view);
  const bool floats = view.true_depth_m < kSurface_m;
  floats_s_ = !floats ? -1 : floats_s_ < 0 ? now_s : floats_s_;
  return !((ended_ || view.ended) && floats && now_s - floats_s_ >= kSettled_s);
}

Verdict FloatingJudge::verdict() const {
  Verdict verdict = verdict_;
  verdict.outcome = !verdict.violations.empty() ? Verdict::Outcome::Violation
                    : ended_                    ? Verdict::Outcome::Exited
                                                : Verdict::Outcome::Released;
  return verdict;
}

}  // namespace glider::simulator
