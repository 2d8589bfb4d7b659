// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Notes on a requirement that is undecided. In: the warning that is being reported, and the
// mission; out: notes on that warning. Used by requirement_check.cpp (GL3111).

#include "ir/core/walk.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/puts_off.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/context/sensors_read.h"
#include "ir/prove/context/vehicle_clock.h"
#include "ir/prove/evidence/configurations.h"
#include "ir/prove/requirements/advice.h"
#include "ir/verify/value_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace glider::ir::prove {
namespace {

/// The variables of the mission that are counted up or down without a limit: set from themselves,
/// with a range that has no end.
std::vector<VariableId> unlimitedCounts(const Mission& m) {
  std::vector<VariableId> found;
  for (const Block& block : m.blocks) {
    for (const Statement& statement : block.statements) {
      if (statement.kind != StatementKind::Set) {
        continue;
      }
      const Variable& variable = m[statement.variable];
      const bool unlimited = std::isinf(variable.lowest) || std::isinf(variable.highest);
      const bool counts = anyIn(m, statement.value, [&](const Expr& e) {
        return e.op == Op::Variable && e.variable == statement.variable;
      });
      if (variable.kind == VariableKind::Mission && variable.type.kind == TypeKind::Quantity &&
          unlimited && counts && std::ranges::find(found, statement.variable) == found.end()) {
        found.push_back(statement.variable);
      }
    }
  }
  return found;
}

/// Whether a case's guard reads a variable.
bool isAsked(const Mission& m, VariableId variable) {
  const auto asks = [&](const Case& c) {
    return anyIn(m, c.guard,
                 [&](const Expr& e) { return e.op == Op::Variable && e.variable == variable; });
  };
  return std::ranges::any_of(m.always, asks) || std::ranges::any_of(m.states, [&](const State& s) {
           return std::ranges::any_of(s.cases, asks);
         });
}

/// The sensors that an expression reads; of an invalid one none.
std::set<uint32_t> sensorsOf(const Mission& m, ExprId root) {
  std::set<uint32_t> found;
  if (root.valid()) {
    forEachSensorRead(m, root, [&](SensorId sensor) { found.insert(sensor.index); });
  }
  return found;
}

/// The cases of `always` that act on a reading which the requirement is about.
std::vector<const Case*> actingOn(const Mission& m, const Requirement& requirement) {
  std::set<uint32_t> asked = sensorsOf(m, requirement.condition);
  if (requirement.monitor.step.valid()) {
    forEachStatement(m, requirement.monitor.step,
                     [&](const Statement& s) { asked.merge(sensorsOf(m, s.value)); });
  }
  std::vector<const Case*> acting;
  for (const Case& c : m.always) {
    if (c.transition != Transition::Stay &&
        std::ranges::any_of(sensorsOf(m, c.guard),
                            [&](uint32_t sensor) { return asked.contains(sensor); })) {
      acting.push_back(&c);
    }
  }
  return acting;
}

/// Whether both lead to the same state, for good.
bool leadToTheSame(const Case& a, const Case& b) {
  return a.transition == Transition::Goto && b.transition == Transition::Goto &&
         a.target == b.target;
}

/// Whether it is about more than one tick.
bool lasts(const Requirement& requirement) {
  return requirement.seconds > 0 || requirement.monitor.horizon_s > 0;
}

/// A promise about one tick that the cases of a state keep.
void noteAlwaysComesFirst(support::DiagnosticBuilder& warning, const Mission& m) {
  const auto leaves = [](const Case& c) { return c.transition != Transition::Stay; };
  if (const auto found = std::ranges::find_if(m.always, leaves); found != m.always.end()) {
    warning.note(found->range,
                 "on the tick on which this case fires, the cases of the state are not tried: if "
                 "they keep the promise, it does not hold on that tick; leave it out with `&&` and "
                 "the opposite of this condition");
  }
}

}  // namespace

void notePutOff(support::DiagnosticBuilder& warning, const Requirement& requirement,
                const ProofContext& proof_context) {
  const Mission& m = proof_context.mission;
  const std::vector<const Case*> acting = actingOn(m, requirement);
  const auto all = acting.empty() ? std::nullopt : configurations(m);
  if (!all) {
    return;
  }
  const PutsOff puts_off(proof_context);
  for (const Reached& reached : *all) {
    if (puts_off.at(reached.control)) {
      const Case& first = *puts_off.by(reached.control.state);
      if (std::ranges::all_of(acting, [&](const Case* c) { return leadToTheSame(first, *c); })) {
        continue;
      }
      warning.note(first.range,
                   fmt::format("on the first tick after a return to `{}` its own cases come before "
                               "those of `always`: if this one fires then, a reading on which "
                               "`always` would act may be missed",
                               m[reached.control.state].name));
      return;
    }
  }
}

void notePowerCutsCount(support::DiagnosticBuilder& warning, const Requirement& requirement,
                        const ProofContext& proof_context, Ending& ending) {
  const EndBound& always_powered = ending.boundWithoutPowerCuts();
  if (!always_powered.by) {
    return;
  }
  if (*always_powered.by > requirement.seconds) {
    const EndBound& end = ending.bound();
    if (!end.by) {
      return;
    }
    warning.note(requirement.range,
                 fmt::format("it is proved that the mission ends after at most {}; require that, "
                             "or end it earlier",
                             durationOf(*end.by)));
    return;
  }
  const EndBound& end = ending.bound();
  if (end.by && *end.by > requirement.seconds) {
    warning.note(
        requirement.range,
        fmt::format("power cuts of the SBC of up to {} count, too: by its clocks, the "
                    "mission ends after at most {}; require that, or `assume no outage`",
                    durationOf(proof_context.mission.resume_within_s), durationOf(*end.by)));
  }
}

void noteFences(support::DiagnosticBuilder& warning, const Requirement& requirement,
                const ProofContext& proof_context) {
  const std::vector<Assumption>& assumed = proof_context.mission.assumptions;
  const bool current =
      std::ranges::find(assumed, AssumptionKind::Current, &Assumption::kind) != assumed.end();
  if (!requirement.geofences.empty()) {
    warning.note(requirement.range,
                 fmt::format("how far the vehicle gets follows from the current, from how long the "
                             "mission lasts, and from where it may steer to: {}an earlier exit, a "
                             "`const` instead of a `param` and a wider area are easier to prove",
                             current ? "" : "`assume current <= 0.2 m/s`, "));
  }
}

/// How a variable that is counted on and on stays in a range, as the mission would write it.
std::string limitFor(const Variable& variable) {
  if (variable.type.dimension == support::dimension::angle) {
    return "such as `in 0 deg .. 360 deg`, and keep it there with `remainder(…, 360 deg)`";
  }
  const auto text = [&](double value) { return withUnit(value, variable.type); };
  return fmt::format("such as `in {} .. {}`, and keep it there with `min` or `clamp`", text(0),
                     text(100));
}

void noteUnlimitedCounts(support::DiagnosticBuilder& warning, const ProofContext& proof_context) {
  constexpr size_t kMostNotes = 3;
  const Mission& m = proof_context.mission;
  const std::vector<VariableId> counts = unlimitedCounts(m);
  for (size_t i = 0; i < std::min(counts.size(), kMostNotes); ++i) {
    warning.note(
        m[counts[i]].range,
        fmt::format("`{}` is counted without a limit, and few proofs succeed then: give it "
                    "a range {}",
                    m[counts[i]].name, limitFor(m[counts[i]])));
  }
}

/// A promise about what follows in time, where the time of day decides.
void noteCalendar(support::DiagnosticBuilder& warning, const Requirement& requirement,
                  const ProofContext& proof_context) {
  const Mission& m = proof_context.mission;
  const auto readsIt = [&](ExprId root) {
    return std::ranges::any_of(sensorsOf(m, root), [&](uint32_t sensor) {
      return isCalendarClock(proof_context.platformSensor({sensor}));
    });
  };
  if (!requirement.monitor.step.valid()) {
    return;
  }
  const auto waits = [&](const Case& c) { return readsIt(c.guard); };
  bool reads = std::ranges::any_of(m.always, waits) ||
               std::ranges::any_of(m.states, [&](const State& state) {
                 return std::ranges::any_of(state.cases, waits);
               });
  forEachStatement(m, requirement.monitor.step,
                   [&](const Statement& s) { reads = reads || readsIt(s.value); });
  if (reads && lasts(requirement)) {
    warning.note(
        requirement.range,
        "a proof lets the vehicle's clock of the calendar show any time on any tick, so it "
        "does not know that a time of day comes: require what holds on one tick, as in "
        "`require never STATE && timeofday < 11 h && statetime > 0 s`, or let the cases wait "
        "by `missiontime` or `statetime` too");
  } else if (reads) {
    noteAlwaysComesFirst(warning, m);
  }
}

void noteTimersOfEntries(support::DiagnosticBuilder& warning, const ProofContext& proof_context) {
  const Mission& m = proof_context.mission;
  for (const State& state : m.states) {
    forEachStatement(m, state.entry, [&](const Statement& s) {
      if (s.kind == StatementKind::Set && m[s.variable].kind == VariableKind::Mission &&
          m[s.value].op == Op::MissionTime && isAsked(m, s.variable)) {
        warning.note(s.range,
                     fmt::format("`{}` is set as `{}` begins; a proof follows a time of the "
                                 "mission's own only if cases set it: set it in the `do` of each "
                                 "case that leads to `{}`",
                                 m[s.variable].name, state.name, state.name));
      }
    });
  }
}

}  // namespace glider::ir::prove
