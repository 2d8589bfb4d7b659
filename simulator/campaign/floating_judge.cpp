// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/floating_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
  verdict_.take_s = verdict_.take_s == 0 ? now_s : verdict_.take_s;
  deepest_told_m_ = std::max(deepest_told_m_, depth_m);
  // What is newer and as deep takes the place of what is before it.
  while (!told_.empty() && told_.back().depth_m <= depth_m) {
    told_.pop_back();
  }
  if (std::isfinite(depth_m)) {
    told_.push_back({now_s, depth_m});
  }
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

/// The deepest command that it may be obeying; empty: it need not obey any.
std::optional<double> FloatingJudge::deepestInForce(double now_s) {
  while (!told_.empty() && now_s - told_.front().at_s > promise_.lets_go_s) {
    told_.pop_front();
  }
  return told_.empty() ? std::nullopt : std::optional(told_.front().depth_m);
}

/// Below what it may be at, it is no deeper than it can be by floating up since it got there. A
/// propeller would be faster, but may have stopped at any time.
void FloatingJudge::checkAscent(const CycleView& view) {
  const std::optional<double> told_m = deepestInForce(view.time_s);
  const bool silent = told_s_ >= 0 && !told_m;
  verdict_.releases += silent && !silent_ && !ended_ ? 1 : 0;
  silent_ = silent;
  const double goal_m = told_m.value_or(0);
  const double may_m = goal_m > kSurface_m ? goal_m + promise_.overshoot_m : kSurface_m;
  if (view.true_depth_m <= may_m || due_s_ < 0) {
    due_s_ = view.time_s;
    due_m_ = view.true_depth_m;
    return;
  }
  const double rising_s = std::max(0.0, view.time_s - due_s_ - promise_.turn_s);
  const double most_m =
      std::max(may_m, due_m_ + promise_.overshoot_m - promise_.rises_m_s * rising_s);
  if (view.true_depth_m > most_m) {
    violate(JudgeId::Ascent, view.time_s,
            fmt::format(
                "{:.1f} m deep, {:.0f} s after {}, at most {:.1f} m", view.true_depth_m,
                view.time_s - (silent ? told_s_ : due_s_),
                silent ? "the last " + command_ : fmt::format("it was to rise to {:.1f} m", goal_m),
                most_m));
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
  checkAscent(view);
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
