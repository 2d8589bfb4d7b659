// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/known_flight.h"

#include "ir/core/walk.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/context/requirement_monitor.h"
#include "ir/worlds/depth_sensor.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace glider::flights {
namespace {

/// The true depth (m) at vehicle times that do not fall; NaN beyond the trace.
class TrueDepth {
 public:
  explicit TrueDepth(const support::Trace& trace)
      : trace_(trace), column_(trace.column("true_depth")) {}

  double at(double time) {
    while (row_ < trace_.rowCount() && trace_.at(row_, 0) < time) {
      ++row_;
    }
    const bool there = column_ >= 0 && row_ < trace_.rowCount();
    return there ? trace_.at(row_, column_) : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  const support::Trace& trace_;
  int column_;
  size_t row_ = 0;
};

/// What a mission, and who watches it, know at a tick.
struct Knowledge {
  ir::Interpreter interpreter;
  ir::RequirementMonitor monitor;
};

/// The ticks from which the mission has continued without those that followed them.
std::set<size_t> returnedTo(const HeardMission& heard) {
  std::set<size_t> all;
  for (size_t i = 0; i < heard.ticks.size(); ++i) {
    const auto before = heard.ticks[i].before;
    if (before && *before + 1 != i) {
      all.insert(*before);
    }
  }
  return all;
}

/// Whether an expression depends on more than the mission's states, variables and time.
bool readsTheWorld(const ir::Mission& m, ir::ExprId id) {
  return id.valid() && ir::anyIn(m, id, [](const ir::Expr& e) {
           return e.op == ir::Op::Sensor || e.op == ir::Op::Age || e.op == ir::Op::Temporal ||
                  e.op == ir::Op::StateTime || e.op == ir::Op::ResumeTime || e.op == ir::Op::Call;
         });
}

/// Whether it is known what a requirement says of a time without ticks: of the readings that came
/// then the mission has received none.
bool speaksOfStillness(const ir::Mission& m, const ir::Requirement& required) {
  if (required.kind == ir::RequirementKind::ExitWithin ||
      required.kind == ir::RequirementKind::SurfacesEvery) {
    return true;
  }
  bool world = readsTheWorld(m, required.condition);
  ir::forEachStatement(m, required.monitor.step, [&](const ir::Statement& statement) {
    world = world || readsTheWorld(m, statement.value);
  });
  return required.monitor.step.valid() && !required.monitor.every_tick && !world;
}

/// Whether the SBC failed at or after the tick at this vehicle time, s.
bool failedAfter(const support::Trace& trace, double time) {
  return std::ranges::any_of(trace.events, [&](const support::TraceEvent& event) {
    return event.id == support::EventId::SbcGone && event.time_s >= time;
  });
}

/// The flight of one mission under the monitor of one requirement.
class KnownReplay {
 public:
  KnownReplay(const ir::Requirement& required, const KnownFlight& flight)
      : m_(flight.mission.checked->mission()),
        required_(required),
        flight_(flight),
        nothing_{
            ir::Interpreter(m_, flight.mission.checked->facts.stack_depth),
            ir::RequirementMonitor(m_, required, flight.mission.platform().world.surface_depth_m,
                                   ir::depthSensor(m_, flight.mission.platform()))},
        needed_(returnedTo(flight.heard)),
        depth_(flight.trace) {}

  KnownOutcome run(bool to_end) {
    for (size_t i = 0; i < flight_.heard.ticks.size() && !outcome_.violation; ++i) {
      tick(i);
    }
    if (!outcome_.violation && to_end && known_ && !result_.finished) {
      standStill();
    }
    return std::move(outcome_);
  }

 private:
  void tick(size_t i) {
    const KnownTick& tick = flight_.heard.ticks[i];
    if (!tick.before) {
      known_.emplace(nothing_);
    } else if (*tick.before + 1 != i) {
      known_.emplace(kept_.at(*tick.before));
    }
    result_ = tick.before ? known_->interpreter.tick(tick.heard.mission_time, tick.heard.frame)
                          : known_->interpreter.start(tick.heard.frame, flight_.parameters);
    last_depth_ = depth_.at(tick.heard.vehicle_time);
    known_->monitor.tick(known_->interpreter, tick.heard.mission_time, result_, last_depth_);
    note(tick.heard.mission_time, tick.heard.vehicle_time);
    if (needed_.contains(i)) {
      kept_.emplace(i, *known_);
    }
  }

  void note(double mission_time, double vehicle_time) {
    if (known_->monitor.when()) {
      outcome_.violation = FlownViolation{0, mission_time, vehicle_time, m_[result_.state].name,
                                          known_->monitor.words()};
    }
  }

  void standStill() {
    const HeardTick& last = flight_.heard.ticks.back().heard;
    const bool failed = failedAfter(flight_.trace, last.vehicle_time);
    if (!failed && speaksOfStillness(m_, required_)) {
      followTrace(last);
    }
    if (!outcome_.violation &&
        known_->monitor.owes(known_->interpreter, last.mission_time, result_, last_depth_)) {
      outcome_.undecided = failed ? "the SBC failed before" : "the flight ended before";
    }
  }

  /// The rows of the trace after the last tick.
  void followTrace(const HeardTick& last) {
    for (size_t row = 0; row < flight_.trace.rowCount() && !outcome_.violation; ++row) {
      const double now = flight_.trace.at(row, 0);
      if (now <= last.vehicle_time) {
        continue;
      }
      const double mission_time = last.mission_time + now - last.vehicle_time;
      last_depth_ = depth_.at(now);
      known_->monitor.still(known_->interpreter, mission_time, result_, last_depth_);
      note(mission_time, now);
      if (outcome_.violation) {
        outcome_.violation->words +=
            fmt::format("{}the mission made its last tick at mission time {:.6g} s",
                        outcome_.violation->words.empty() ? "" : "; ", last.mission_time);
      }
    }
  }

  const ir::Mission& m_;
  const ir::Requirement& required_;
  const KnownFlight& flight_;
  const Knowledge nothing_;
  const std::set<size_t> needed_;
  std::map<size_t, Knowledge> kept_;
  TrueDepth depth_;
  double last_depth_ = std::numeric_limits<double>::quiet_NaN();
  std::optional<Knowledge> known_;
  ir::TickResult result_;
  KnownOutcome outcome_;
};

}  // namespace

KnownOutcome outcomeOf(const ir::Requirement& required, const KnownFlight& flight, bool to_end) {
  return KnownReplay(required, flight).run(to_end);
}

std::string outagesBefore(const HeardMission& heard, double vehicle_time) {
  size_t count = 0;
  std::string last;
  for (size_t i = 1; i < heard.ticks.size(); ++i) {
    const HeardTick& tick = heard.ticks[i].heard;
    if (heard.ticks[i].resumed && tick.vehicle_time <= vehicle_time) {
      ++count;
      last = fmt::format("mission time {:.6g} s to {:.6g} s",
                         heard.ticks[*heard.ticks[i].before].heard.mission_time, tick.mission_time);
    }
  }
  return count == 0   ? ""
         : count == 1 ? fmt::format("after an outage of the SBC from {}", last)
                      : fmt::format("after {} outages of the SBC, the last from {}", count, last);
}

}  // namespace glider::flights
