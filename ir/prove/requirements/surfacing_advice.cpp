// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Notes on a `surfaces every` that is not proved: which state leaves the surface before the climb
// to it is over. In: the diagnostic that is being reported, and the mission or the counterexample;
// out: notes on that diagnostic. Used by `requirements` (GL3111) and violation_report.cpp (GL3110).

#include "ir/core/walk.h"
#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/abstract/surfacing.h"
#include "ir/prove/abstract/watch_times.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/context/sensors_read.h"
#include "ir/prove/context/vehicle_rules.h"
#include "ir/prove/encoding/safety_properties.h"
#include "ir/prove/requirements/advice.h"
#include "ir/verify/intervals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace glider::ir::prove {
namespace {

/// ", or leave it only when `depth < 1.1 m`": no deeper does a reading show that the vehicle is at
/// `depth` (m) or above.
std::string orAt(double depth, const ProofContext& proof_context) {
  const double reading = depth - proof_context.platform.world.depth_error_m;
  return proof_context.depth && reading > 0
             ? fmt::format(", or leave it only when `{} < {:.3g} m`",
                           proof_context.mission[*proof_context.depth].name, reading)
             : "";
}

/// ", as a reading of `depth` may be 4.1 m wrong": where a case reads it.
std::string asReadingsErr(const ProofContext& proof_context, ExprId guard) {
  bool reads = false;
  forEachSensorRead(proof_context.mission, guard, [&](SensorId id) {
    reads = reads || (proof_context.depth && id == *proof_context.depth);
  });
  return reads ? fmt::format(", as a reading of `{}` may be {:.3g} m wrong",
                             proof_context.mission[*proof_context.depth].name,
                             proof_context.platform.world.depth_error_m)
               : "";
}

/// Whether cases may fire below a depth (m), for any readings.
class UnderWater {
 public:
  UnderWater(const ProofContext& proof_context, double below)
      : proof_context_(proof_context), values_(anyValues(proof_context.mission)), below_(below) {}

  /// The least time in its state, s, to the second, after which the case may fire; none: it does
  /// not before `latest`.
  [[nodiscard]] std::optional<double> firesAfter(const Case& c, double latest) const {
    double never = -1, fires = std::floor(latest);
    if (!mayFire(c, fires)) {
      return std::nullopt;
    }
    while (fires - never > 1) {
      const double middle = std::floor((never + fires) / 2);
      (mayFire(c, middle) ? fires : never) = middle;
    }
    return fires;
  }

 private:
  [[nodiscard]] bool mayFire(const Case& c, double by) const {
    const Interval ever{0, kLongestMission, false};
    const Interval stay{0, by, false};
    const IdleTemporals idle = idleBefore(proof_context_, c.guard, by, false);
    return AbstractEvaluator(proof_context_, values_, {ever, stay, stay}, deep(), &idle)
        .truth(c.guard)
        .is_true;
  }

  [[nodiscard]] std::optional<AssumedReading> deep() const {
    if (!proof_context_.depth) {
      return std::nullopt;
    }
    const platforms::EnvironmentModel& world = proof_context_.platform.world;
    const Interval& all = proof_context_.sensors[proof_context_.depth->index];
    const double lowest = std::max(all.lowest, below_ - world.depth_error_m);
    return AssumedReading{*proof_context_.depth,
                          {lowest, all.highest, all.empty || lowest > all.highest}};
  }

  const ProofContext& proof_context_;
  Valuation values_;
  double below_;
};

}  // namespace

namespace {

/// The slowest climb of a state that commands the surface.
struct Climb {
  double from = 0, to = 0;  ///< m
  double seconds = 0;
};

void noteEarlyLeave(support::DiagnosticBuilder& diagnostic, const State& state, const Climb& climb,
                    const ProofContext& proof_context) {
  const UnderWater under(proof_context, climb.to);
  for (const Case& c : state.cases) {
    const bool leads_on = c.transition != Transition::Stay && c.transition != Transition::Exit;
    const auto after = leads_on ? under.firesAfter(c, climb.seconds) : std::nullopt;
    if (after && *after < climb.seconds) {
      diagnostic.note(
          proof_context.mission[c.guard].range,
          fmt::format("this may leave `{}` after {}{}, but the climb from {:.4g} m may take {}: "
                      "stay that long{}",
                      state.name, durationOf(*after), asReadingsErr(proof_context, c.guard),
                      climb.from, durationOf(climb.seconds), orAt(climb.to, proof_context)));
      return;
    }
  }
}

}  // namespace

void noteEarlyLeaves(support::DiagnosticBuilder& diagnostic, const ProofContext& proof_context) {
  const Mission& m = proof_context.mission;
  const std::vector<double> climbs = climbTimes(proof_context);
  const std::vector<double> depths = deepestByState(proof_context);
  for (size_t i = 0; i < m.states.size(); ++i) {
    if (std::isfinite(climbs[i])) {
      noteEarlyLeave(diagnostic, m.states[i],
                     {depths[i], proof_context.platform.world.surface_depth_m, climbs[i]},
                     proof_context);
    }
  }
}

namespace {

/// Whether a case of the profile commands the surface some time after another.
bool surfacesByTime(const Mission& m, const Activity& profile) {
  return std::ranges::any_of(profile.cases, [&](const Case& c) {
    bool surfaces = false;
    forEachStatement(m, c.action, [&](const Statement& s) {
      surfaces = surfaces || (s.kind == StatementKind::Command && s.command == Command::Surface);
    });
    return surfaces && anyIn(m, c.guard, [](const Expr& e) { return e.op == Op::MissionTime; });
  });
}

}  // namespace

void noteOwnSurfacings(support::DiagnosticBuilder& warning, const ProofContext& proof_context) {
  const Mission& m = proof_context.mission;
  const platforms::EnvironmentModel& world = proof_context.platform.world;
  const std::vector<double> climbs = climbTimes(proof_context);
  const std::vector<double> depths = deepestByState(proof_context);
  for (size_t i = 0; i < m.states.size(); ++i) {
    const State& state = m.states[i];
    if (surfacesByTime(m, state.profile) && !std::isfinite(climbs[i]) && std::isfinite(depths[i])) {
      const double climb =
          world.command_delay_s + world.turn_s +
          std::max(0.0, depths[i] - world.surface_depth_m) / world.slowest_climb_m_s;
      warning.note(state.profile.range,
                   fmt::format("`{}` comes to the surface by itself, and a proof follows that only "
                               "if it stays there for as long as the climb from {:.4g} m may take, "
                               "{} (`pause` of `yo_and_surface`); or surface in a state of its own",
                               m[state.profile.behaviour].name, depths[i], durationOf(climb)));
      return;
    }
  }
}

namespace {

/// Whether a guard compares the mission time with a time that the mission keeps.
bool asksTimer(const Mission& m, ExprId guard) {
  const auto has = [&](auto wanted) { return anyIn(m, guard, wanted); };
  return has([](const Expr& e) { return e.op == Op::MissionTime; }) && has([&](const Expr& e) {
           return e.op == Op::Variable && m[e.variable].kind == VariableKind::Mission;
         });
}

bool surfacesInTime(const Mission& changed, double seconds, const ProofContext& proof_context) {
  const ProofContext context = proof_context.ofVersion(changed);
  const EndBound end = boundOf(context, kLongestMission, Goal::Exit);
  const auto longest = longestSubmersion(context, end, kLongestMission);
  return longest && *longest <= seconds;
}

}  // namespace

void noteTimerBelow(support::DiagnosticBuilder& warning, const Requirement& requirement,
                    const ProofContext& proof_context) {
  const Mission& m = proof_context.mission;
  const auto leads = [](const Case& c) { return c.target.valid(); };
  const auto first = std::ranges::find_if(m.always, leads) - m.always.begin();
  for (auto at = first + 1; at < std::ssize(m.always); ++at) {
    const Case& c = m.always[static_cast<size_t>(at)];
    if (!leads(c) || !asksTimer(m, c.guard)) {
      continue;
    }
    Mission changed = m;
    const auto begin = changed.always.begin();
    std::rotate(begin + first, begin + at, begin + at + 1);
    if (surfacesInTime(changed, requirement.seconds, proof_context)) {
      warning.note(m[c.guard].range,
                   fmt::format("a case above this one may lead away from `{}` before the vehicle "
                               "is up: put this case above all that lead to another state, and the "
                               "requirement is proved",
                               m[c.target].name));
      return;
    }
  }
}

void noteSlowClimb(support::DiagnosticBuilder& warning, const Requirement& requirement,
                   const ProofContext& proof_context) {
  const std::vector<double> awaited = awaitedDepths(requirement, proof_context);
  if (awaited.empty() || !(requirement.monitor.horizon_s > 0)) {
    return;
  }
  const Mission& m = proof_context.mission;
  const std::vector<double> climbs = climbTimes(proof_context);
  const std::vector<double> depths = deepestByState(proof_context);
  for (uint32_t i = 0; i < m.states.size(); ++i) {
    if (!std::isfinite(climbs[i]) || !observes(requirement.monitor, {i})) {
      continue;
    }
    const double to = awaited.front();
    const double climb = longestClimb(proof_context.platform.world, depths[i], to);
    const double seen = climb + proof_context.tick_gap_s;
    if (requirement.monitor.horizon_s < seen) {
      warning.note(m.states[i].range,
                   fmt::format("in `{}` the climb from {:.4g} m to {:.4g} m may take {}, and the "
                               "tick that sees it may come {} later: give it {}",
                               m.states[i].name, depths[i], to, durationOf(climb),
                               durationOf(proof_context.tick_gap_s), durationOf(std::ceil(seen))));
    } else {
      noteEarlyLeave(warning, m.states[i], {depths[i], to, climb}, proof_context);
    }
  }
}

void noteShortSurfacings(support::DiagnosticBuilder& error, const Counterexample& run,
                         const ProofContext& proof_context) {
  const Mission& m = proof_context.mission;
  const platforms::EnvironmentModel& world = proof_context.platform.world;
  const std::vector<double> climbs = climbTimes(proof_context);
  const std::vector<double> depths = deepestByState(proof_context);
  std::vector<bool> noted(m.states.size(), false);
  const auto left = [&](StateId state, double stay, double depth, double time) {
    const double climb = climbs[state.index];
    if (noted[state.index] || !std::isfinite(climb) || stay >= climb ||
        !(depth > world.surface_depth_m)) {
      return;
    }
    noted[state.index] = true;
    const auto by = std::ranges::find_if(m.always, [&](const Case& c) {
      return std::ranges::any_of(run.story, [&](const Counterexample::Event& event) {
        return event.mission_time == time && event.range == c.range;
      });
    });
    if (by != m.always.end()) {
      error.note(
          by->range,
          fmt::format("this leaves `{}` after {}, but the climb from {:.4g} m may "
                      "take {}: let it wait until the vehicle is up",
                      m[state].name, durationOf(stay), depths[state.index], durationOf(climb)));
      return;
    }
    error.note(m[state].range,
               fmt::format("`{}` is left after {}, but the climb from {:.4g} m may take {}: stay "
                           "that long{}",
                           m[state].name, durationOf(stay), depths[state.index], durationOf(climb),
                           orAt(world.surface_depth_m, proof_context)));
  };
  double since = 0;
  for (size_t i = 1; i < run.ticks.size(); ++i) {
    const ConcreteTick& before = run.ticks[i - 1];
    const ConcreteTick& now = run.ticks[i];
    if (now.state != before.state) {
      left(before.state, now.mission_time - since, now.depth, now.mission_time);
      since = now.mission_time;
    }
  }
}

}  // namespace glider::ir::prove
