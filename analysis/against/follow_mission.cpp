// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/against/follow_mission.h"

#include "analysis/against/held_guards.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/context/requirement_monitor.h"
#include "ir/worlds/depth_sensor.h"
#include "support/one_line.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace glider::analysis {
namespace {

using ir::ListKind;
using report::FollowedKind;
using report::FollowedStep;

/// Runs the mission on the interpreter along the ticks of a log. The vehicle did not obey it, so
/// what it finds is what the mission would have done with these readings, tick by tick, and not a
/// flight.
class LogFollower {
 public:
  LogFollower(const compiler::Checked& checked, const LogTicks& log,
              std::span<const double> parameters)
      : checked_(checked),
        m_(checked.mission()),
        log_(log),
        parameters_(parameters),
        surface_m_(checked.platform().world.surface_depth_m),
        watched_(watchedCases(checked)),
        once_(watched_.size()),
        values_(watched_.size()),
        depth_(ir::depthSensor(m_, checked.platform())) {}

  Followed run() {
    out_.states.assign(log_.ticks.size(), Followed::kNoState);
    out_.true_ticks.assign(watched_.size(), 0);
    for (uint32_t tick = firstDive(); tick < log_.ticks.size(); ++tick) {
      if (running_ && isAfterGap(tick)) {
        interrupt(tick);
      }
      if (running_) {
        step(tick);
      } else if (dives(tick)) {
        start(tick);
      }
    }
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool submerged(uint32_t tick) const {
    return log_.ticks[tick].depth_m > surface_m_;
  }

  [[nodiscard]] bool isUp(uint32_t tick) const { return log_.ticks[tick].depth_m <= surface_m_; }

  /// The first tick below the surface; the first of all if the depth is never known.
  [[nodiscard]] uint32_t firstDive() {
    for (uint32_t tick = 0; tick < log_.ticks.size(); ++tick) {
      if (submerged(tick)) {
        return tick;
      }
    }
    const bool unknown = std::ranges::all_of(
        log_.ticks, [](const LogTick& tick) { return std::isnan(tick.depth_m); });
    blind_ = unknown;
    return unknown ? 0 : static_cast<uint32_t>(log_.ticks.size());
  }

  bool dives(uint32_t tick) {
    was_up_ = was_up_ || isUp(tick);
    return was_up_ && (submerged(tick) || blind_);
  }

  void start(uint32_t tick) {
    running_.emplace(m_, checked_.facts.stack_depth);
    origin_s_ = log_.ticks[tick].time_s;
    const ir::TickResult begun = running_->start(log_.ticks[tick].frame, parameters_);
    once_.assign(watched_.size(), {});
    state_ = begun.state;
    was_up_ = blind_ = false;
    out_.states[tick] = state_.index;
    out_.steps.push_back({.at = momentOf(log_, tick),
                          .kind = FollowedKind::Start,
                          .from = "",
                          .to = m_[state_].name,
                          .range = {},
                          .guard = "",
                          .values = {}});
    watches_.clear();
    for (const ir::Requirement& requirement : m_.requirements) {
      watches_.push_back(
          {FollowedKind::Violation, &requirement, {m_, requirement, surface_m_, depth_}});
    }
    for (const ir::Assumption& assumption : m_.assumptions) {
      if (assumption.isWatched()) {
        watches_.push_back({FollowedKind::Assumption,
                            &assumption.watch,
                            {m_, assumption.watch, surface_m_, depth_}});
      }
    }
    watchRequirements(tick, begun);
  }

  /// Whether so much time has passed that the mission would not continue after a power cut.
  [[nodiscard]] bool isAfterGap(uint32_t tick) const {
    return log_.ticks[tick].time_s - log_.ticks[tick - 1].time_s > m_.resume_within_s;
  }

  void interrupt(uint32_t tick) {
    out_.steps.push_back({.at = momentOf(log_, tick - 1),
                          .kind = FollowedKind::Gap,
                          .from = m_[state_].name,
                          .to = "",
                          .range = {},
                          .guard = "",
                          .values = {}});
    running_.reset();
    was_up_ = true;
  }

  void step(uint32_t tick) {
    running_->advance(log_.ticks[tick].time_s - origin_s_, log_.ticks[tick].frame);
    for (size_t i = 0; i < watched_.size(); ++i) {
      const bool true_now =
          current(watched_[i]) && running_->truthOf(guardOf(i)) == ir::Truth::True;
      once_[i].look(true_now);
      out_.true_ticks[i] += true_now ? 1 : 0;
      values_[i] = true_now ? valuesOf(watched_[i].reads, *running_) : Values();
    }
    const ir::TickResult result = running_->decide();
    for (size_t i = 0; i < watched_.size(); ++i) {
      const WatchedCase& one = watched_[i];
      const bool fired = current(one) && result.firedIn(one.list) == one.number;
      const bool moved = fired && result.moved == ir::CaseOf{one.list, one.number};
      if (moved || (fired && once_[i].due())) {
        tell(tick, i, result);
        once_[i].fire();
      }
    }
    watchRequirements(tick, result);
    if (result.finished) {
      running_.reset();
      was_up_ = isUp(tick);
      return;
    }
    state_ = result.state;
    out_.states[tick] = state_.index;
  }

  /// Whether the case belongs to the state in which the tick began.
  [[nodiscard]] bool current(const WatchedCase& watched) const {
    return !watched.state.valid() || watched.state == state_;
  }
  [[nodiscard]] ir::ExprId guardOf(size_t watched) const {
    return caseOf(m_, watched_[watched]).guard;
  }

  void tell(uint32_t tick, size_t watched, const ir::TickResult& result) {
    const ir::Case& fired = caseOf(m_, watched_[watched]);
    const support::SourceRange guard = m_[fired.guard].range;
    FollowedStep step;
    step.at = momentOf(log_, tick);
    step.kind = kindOf(fired.transition);
    step.from = m_[state_].name;
    step.to = step.kind == FollowedKind::Exit   ? ""
              : step.kind == FollowedKind::Stay ? step.from
                                                : m_[result.state].name;
    step.always = watched_[watched].list == ListKind::Always;
    step.range = fired.range;
    step.guard = guard.valid() ? support::conditionOnOneLine(checked_.sources().text(guard)) : "";
    step.values = values_[watched];
    out_.steps.push_back(std::move(step));
  }

  /// Each requirement that has not been violated yet, and each assumption that has not been broken,
  /// since the mission started. The depth of the log counts as the true one.
  void watchRequirements(uint32_t tick, const ir::TickResult& result) {
    for (Watched& watch : watches_) {
      const ir::Requirement& requirement = *watch.requirement;
      if (requirement.kind == ir::RequirementKind::Reach || watch.monitor.when()) {
        continue;
      }
      const LogTick& now = log_.ticks[tick];
      watch.monitor.tick(*running_, now.time_s - origin_s_, result, now.depth_m);
      if (watch.monitor.when()) {
        FollowedStep step;
        step.at = momentOf(log_, tick);
        step.kind = watch.kind;
        step.from = m_[result.state].name;
        step.range = requirement.range;
        step.guard = support::onOneLine(checked_.sources().text(requirement.range));
        step.words = watch.monitor.words();
        out_.steps.push_back(std::move(step));
      }
    }
  }

  static FollowedKind kindOf(ir::Transition transition) {
    switch (transition) {
      case ir::Transition::Goto:
        return FollowedKind::Goto;
      case ir::Transition::Call:
        return FollowedKind::Call;
      case ir::Transition::Return:
        return FollowedKind::Return;
      case ir::Transition::Exit:
        return FollowedKind::Exit;
      case ir::Transition::Stay:
      case ir::Transition::Done:
        break;
    }
    return FollowedKind::Stay;
  }

  using Values = std::vector<report::LoggedValue>;

  const compiler::Checked& checked_;
  const ir::Mission& m_;
  const LogTicks& log_;
  std::span<const double> parameters_;
  double surface_m_;
  std::vector<WatchedCase> watched_;
  std::vector<FiringOnce> once_;
  std::vector<Values> values_;
  std::optional<ir::Interpreter> running_;
  std::optional<ir::SensorId> depth_;  ///< the vehicle's own
  /// Of a requirement or an assumption.
  struct Watched {
    FollowedKind kind;
    const ir::Requirement* requirement;
    ir::RequirementMonitor monitor;
  };
  std::vector<Watched> watches_;
  double origin_s_ = 0;  ///< mission time 0 of the current start, in the log
  ir::StateId state_{0};
  bool was_up_ = true;
  bool blind_ = false;  ///< the log has no depth, and the mission has not started yet
  Followed out_;
};

}  // namespace

Followed followMission(const compiler::Checked& checked, const LogTicks& log,
                       std::span<const double> parameters) {
  return LogFollower(checked, log, parameters).run();
}

}  // namespace glider::analysis
