// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How a refuted requirement is reported (GL3110). In: the requirement and its counterexample; out:
// an error with the moment of the violation, the transitions on the way there, each power cut, and
// for `surfaces every` and `exit within` what would help (advice.h). It decides nothing: the trace
// has been replayed before.

#include "ir/prove/requirements/violation_report.h"

#include "ir/eval/interpreter.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/encoding/safety_properties.h"
#include "ir/prove/requirements/advice.h"
#include "ir/verify/value_text.h"
#include "support/check.h"
#include "support/diagnostics/ids/verification.h"
#include "support/utc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace glider::ir::prove {
namespace {

/// Of a longer story only the transitions at both ends are reported.
constexpr size_t kStoryEnds = 6;

/// When what is missing became due. The start tries no case, so what is true there alone can be
/// answered by none.
void noteDue(support::DiagnosticBuilder& error, const Requirement& requirement,
             const Counterexample& run) {
  if (run.due.empty()) {
    return;
  }
  error.note(requirement.range,
             run.due + (run.due_at_start
                            ? ", as the mission starts: no case is tried before the next tick; "
                              "`require after missiontime > 0 s: …` leaves that tick out, as does "
                              "`&& missiontime > 0 s` in its condition"
                            : ""));
}

/// Whether a case below the one at `range`, in its list, would do something.
bool hasActionBelow(const Mission& mission, const support::SourceRange& range) {
  const auto below = [&](const std::vector<Case>& cases) {
    const auto found = std::ranges::find(cases, range, &Case::range);
    return found != cases.end() && std::any_of(found + 1, cases.end(), [](const Case& c) {
             return c.action.valid() && !c.implied;
           });
  };
  return below(mission.always) || std::ranges::any_of(mission.states, [&](const State& state) {
           return below(state.cases);
         });
}

void noteStory(support::DiagnosticBuilder& error, const Counterexample& run,
               const Mission& mission) {
  const auto& story = run.story;
  for (size_t i = 0; i < story.size(); ++i) {
    if (story.size() > 2 * kStoryEnds && i == kStoryEnds) {
      i = story.size() - kStoryEnds;
      error.note(story[i].range, fmt::format("(after {} more transitions) {}",
                                             story.size() - 2 * kStoryEnds, story[i].text));
      continue;
    }
    error.note(story[i].range, story[i].text);
  }
  if (!story.empty() && run.ticks.back().finished && story.back().mission_time == run.when &&
      hasActionBelow(mission, story.back().range)) {
    error.note(story.back().range,
               "on that tick no case below it is tried: what must come first stands above it");
  }
}

/// What would have led on, had it been tried. A case whose own target is in use has led there.
void noteHeldBack(support::DiagnosticBuilder& error, const Counterexample& run,
                  const Mission& mission) {
  for (const uint32_t number : run.held_back) {
    const Case& c = mission.always[number];
    const bool led_here = c.target.valid() && mission[c.target].name == run.state;
    if (!led_here && !staysIn(c.transition)) {
      error.note(c.range,
                 fmt::format("this case is true then, but not tried in `{}`: a case above it "
                             "in `always` led there, or its target waits",
                             run.state));
      return;
    }
  }
}

/// As it would be set: a time of the calendar if the usual value is one.
std::string parameterText(double value, double usual, const Variable& parameter) {
  constexpr double kYear_s = 365 * 86400.0;
  const Type& type = parameter.type;
  const bool date = type.kind == TypeKind::Quantity && type.dimension == support::dimension::time &&
                    usual > kYear_s;
  return date ? support::instantText(value) : withUnit(value, parameter);
}

/// The parameters with which it is violated, if one has another value than its default.
void noteParameters(support::DiagnosticBuilder& error, const Requirement& requirement,
                    const Counterexample& run, const Mission& mission) {
  const std::vector<double> usual = defaultParameters(mission);
  std::string list;
  size_t number = 0;
  bool several = false, endless = false, conditions = true;
  for (const Variable& variable : mission.variables) {
    if (variable.kind != VariableKind::Parameter || number >= run.parameters.size()) {
      continue;
    }
    if (run.parameters[number] != usual[number]) {
      several = !list.empty();
      conditions = conditions && variable.type.kind == TypeKind::Bool;
      endless = endless || (variable.type.kind != TypeKind::Bool &&
                            std::max(std::fabs(variable.lowest), std::fabs(variable.highest)) ==
                                Variable::kEndless);
      list += fmt::format("{}`{}` at {}", list.empty() ? "" : ", ", variable.name,
                          parameterText(run.parameters[number], usual[number], variable));
    }
    ++number;
  }
  if (!list.empty()) {
    error.note(requirement.range,
               fmt::format("with {}: {}", list,
                           endless      ? "give a parameter a range, as in `param bottom: length = "
                                          "50 m in 10 m .. 80 m`"
                           : conditions ? "it may be set before a flight, and must hold then too"
                           : several    ? "their ranges allow that"
                                        : "its range allows that"));
  }
}

void notePowerCuts(support::DiagnosticBuilder& error, const Requirement& requirement,
                   const Counterexample& run, const ProofContext& proof_context) {
  constexpr size_t kMostNotes = 3;
  size_t noted = 0;
  for (size_t i = 1; i < run.ticks.size() && noted < kMostNotes; ++i) {
    const double from = run.ticks[i - 1].mission_time;
    const double to = run.ticks[i].mission_time;
    if (to - from > proof_context.platform.world.tick_gap_s) {
      ++noted;
      error.note(requirement.range,
                 fmt::format("from {:.6g} s to {:.6g} s the SBC has no power; the mission resumes "
                             "after a power cut of up to {} (`resume within`)",
                             from, to, durationOf(proof_context.mission.resume_within_s)));
    }
  }
}

/// Where a vehicle gets by the drift alone: of a promise about places.
void noteDrift(support::DiagnosticBuilder& error, const Requirement& requirement,
               const Counterexample& run, const ProofContext& proof_context) {
  constexpr double kWorthSaying_s = 600;
  const platforms::EnvironmentModel& world = proof_context.platform.world;
  size_t first = run.ticks.size();
  bool read = false;
  while (first > 0 && run.ticks[first - 1].depth <= world.surface_depth_m) {
    --first;
    read = read || std::ranges::any_of(run.ticks[first].frame, [&](const SensorUpdate& update) {
             return proof_context.depth && update.sensor == *proof_context.depth &&
                    update.raw == update.raw;
           });
  }
  if (first == run.ticks.size() || run.when - run.ticks[first].mission_time < kWorthSaying_s) {
    return;
  }
  error.note(requirement.range,
             fmt::format("from {:.6g} s on the vehicle is at the surface{}, and drifts there at up "
                         "to {:.3g} m/s",
                         run.ticks[first].mission_time,
                         proof_context.depth && !read ? ", without a reading of the depth" : "",
                         world.surface_drift_m_s));
}

std::string endedLate(const Counterexample& run) {
  return fmt::format("the mission may {} {:.6g} s, in state `{}`",
                     run.ticks.back().finished ? "end only at" : "still be flying at", run.when,
                     run.state);
}

std::string howBroken(const Requirement& requirement, const Counterexample& run,
                      const Mission& mission) {
  switch (requirement.kind) {
    case RequirementKind::Always:
      if (requirement.seconds > 0) {  // `exit within`, under assumptions
        return endedLate(run);
      }
      if (!run.words.empty()) {
        return fmt::format("at {:.6g} s, in state `{}`, {}", run.when, run.state, run.words);
      }
      return fmt::format("at {:.6g} s, in state `{}`{}{}", run.when, run.state,
                         run.values.empty() ? "" : ", ", run.values);
    case RequirementKind::ExitWithin:
      return endedLate(run);
    case RequirementKind::NeverAfter:
      return fmt::format("state `{}` may be entered after `{}`, at {:.6g} s",
                         mission[requirement.state].name, mission[requirement.after].name,
                         run.when);
    case RequirementKind::SurfacesEvery:
      return fmt::format("the vehicle may still be under water at {:.6g} s, in state `{}`",
                         run.when, run.state);
    case RequirementKind::StackAtMost:
    case RequirementKind::Reach:
      break;
  }
  CHECK(false, "no run breaks it");
}

}  // namespace

void reportViolation(const Requirement& requirement, const Counterexample& run,
                     const ProofContext& proof_context, support::DiagnosticEngine& diagnostics) {
  auto error = diagnostics.report(support::diagnostics::requirementBroken, requirement.range,
                                  howBroken(requirement, run, proof_context.mission));
  noteDue(error, requirement, run);
  noteStory(error, run, proof_context.mission);
  noteHeldBack(error, run, proof_context.mission);
  noteParameters(error, requirement, run, proof_context.mission);
  notePowerCuts(error, requirement, run, proof_context);
  if (!requirement.geofences.empty()) {
    noteDrift(error, requirement, run, proof_context);
  }
  noteWhatTheSeaDecides(error, requirement, proof_context);
  noteAwaitedReading(error, requirement, run, proof_context);
  if (requirement.kind == RequirementKind::SurfacesEvery ||
      !awaitedDepths(requirement, proof_context).empty()) {
    noteShortSurfacings(error, run, proof_context);
  } else if (requirement.seconds > 0) {
    noteLateEnd(error, requirement, proof_context);
  }
}

}  // namespace glider::ir::prove
