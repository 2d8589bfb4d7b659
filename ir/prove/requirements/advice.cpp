// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Notes that say what to change where a requirement is not proved. In: the diagnostic that is being
// reported, and the mission or the counterexample; out: notes on that diagnostic. A note about an
// `exit` is added only if the end bound of the mission, with that case moved to the top, is proved;
// so following it helps; that of a state that waits only if no such bound on the time in it is
// found. Used by `requirements` (GL3111) and violation_report.cpp (GL3110).

#include "ir/prove/requirements/advice.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/sensors_awaited.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// More notes would not be read.
constexpr size_t kMostLateExits = 3;

/// A case of `always` or, if it is valid, of a state.
struct LateExit {
  StateId state;
  size_t number = 0;
};

const std::vector<Case>& listOf(const Mission& m, StateId state) {
  return state.valid() ? m[state].cases : m.always;
}

/// It fires from some mission time on, unless a case before it fires.
bool isTimedExit(const Mission& m, const Case& c) {
  const Expr& e = m[c.guard];
  const bool later = e.op == Op::GreaterEqual || e.op == Op::Greater;
  return c.transition == Transition::Exit && later && m[e.operands[0]].op == Op::MissionTime;
}

/// Those that are not the first of their list.
std::vector<LateExit> lateExits(const Mission& m) {
  std::vector<LateExit> found;
  const auto look = [&](StateId state) {
    const std::vector<Case>& cases = listOf(m, state);
    for (size_t i = 1; i < cases.size(); ++i) {
      if (isTimedExit(m, cases[i])) {
        found.push_back({state, i});
      }
    }
  };
  look({});
  for (uint32_t i = 0; i < m.states.size(); ++i) {
    look({i});
  }
  return found;
}

/// What a case does in the end: "goto home".
std::string wordsOf(const Mission& m, const Case& c) {
  switch (c.transition) {
    case Transition::Goto:
      return fmt::format("goto {}", m[c.target].name);
    case Transition::Call:
      return fmt::format("call {}", m[c.target].name);
    case Transition::Return:
      return "return";
    case Transition::Stay:
    case Transition::Done:
    case Transition::Exit:
      break;
  }
  return "exit";
}

bool endsInTime(const Mission& changed, double seconds, const ProofContext& proof_context) {
  const ProofContext context = proof_context.ofVersion(changed);
  const EndBound end = boundOf(context, kLongestMission, Goal::Exit);
  return end.by && std::ranges::max(end.left_by) <= seconds;
}

/// Whether the mission ends in time if each of these cases comes first.
bool endsWith(const std::vector<LateExit>& first, double seconds,
              const ProofContext& proof_context) {
  Mission changed = proof_context.mission;
  for (const LateExit& place : first) {
    std::vector<Case>& cases =
        place.state.valid() ? changed.states[place.state.index].cases : changed.always;
    const auto at = cases.begin() + static_cast<std::ptrdiff_t>(place.number);
    std::rotate(cases.begin(), at, at + 1);
  }
  return endsInTime(changed, seconds, proof_context);
}

/// The fewest of the late exits without which, at the top, there is no bound; none if all do not
/// suffice.
std::vector<LateExit> neededAtTheTop(double seconds, const ProofContext& proof_context) {
  std::vector<LateExit> late = lateExits(proof_context.mission);
  if (late.empty() || !endsWith(late, seconds, proof_context)) {
    return {};
  }
  for (size_t i = late.size(); i-- > 0 && late.size() > 1;) {
    std::vector<LateExit> fewer = late;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (endsWith(fewer, seconds, proof_context)) {
      late = std::move(fewer);
    }
  }
  return late;
}

/// An exit of a state by mission time that would end the mission in time as the first case of
/// `always`; of a state that is not valid: none.
LateExit neededInAlways(double seconds, const ProofContext& proof_context) {
  const Mission& m = proof_context.mission;
  size_t tried = 0;
  for (uint32_t s = 0; s < m.states.size(); ++s) {
    for (size_t i = 0; i < m.states[s].cases.size(); ++i) {
      const Case& c = m.states[s].cases[i];
      const bool of_the_state =
          anyIn(m, c.guard, [](const Expr& e) { return e.op == Op::Variable; });
      if (!isTimedExit(m, c) || of_the_state || tried == kMostLateExits) {
        continue;
      }
      ++tried;
      Mission changed = m;
      Case exit = c;
      exit.action = {};
      changed.always.insert(changed.always.begin(), exit);
      if (endsInTime(changed, seconds, proof_context)) {
        return {{s}, i};
      }
    }
  }
  return {};
}

/// Where no bound is found because a state may last for ever: names a case of it that waits for a
/// reading, and returns whether there is one.
bool noteEndlessStay(support::DiagnosticBuilder& diagnostic, const ProofContext& proof_context) {
  const Mission& m = proof_context.mission;
  const EndBound end = boundOf(proof_context.withoutPowerCuts(), kLongestMission, Goal::Exit);
  if (end.by || !end.stays.valid()) {
    return false;
  }
  for (const Case& c : m[end.stays].cases) {
    std::vector<std::string> names;
    forEachSensorAwaited(m, c.guard, [&](SensorId id) {
      const std::string name = fmt::format("`{}`", m[id].name);
      if (std::ranges::find(names, name) == names.end()) {
        names.push_back(name);
      }
    });
    if (c.transition != Transition::Stay && !names.empty()) {
      diagnostic.note(m[c.guard].range,
                      fmt::format("this case waits for a reading of {}, perhaps for ever: no clock "
                                  "is sure to end `{}`; add a case such as `case statetime >= 1 h "
                                  "{}`",
                                  fmt::join(names, ", "), m[end.stays].name, wordsOf(m, c)));
      return true;
    }
  }
  return false;
}

/// A time as a pilot would write it, no longer than `seconds`: "72.9 h".
std::string roundedDown(double seconds) {
  constexpr double kMinute_s = 60, kHour_s = 3600, kHours = 2;
  return seconds >= kHours * kHour_s
             ? fmt::format("{:.6g} h", std::floor(seconds / kHour_s * 10) / 10)
             : fmt::format("{:.6g} min", std::floor(seconds / kMinute_s));
}

/// Where no clock is sure to end the mission: the exit that would.
void noteMissingExit(support::DiagnosticBuilder& diagnostic, const Requirement& requirement,
                     const ProofContext& proof_context) {
  constexpr double kShortest_s = 60;
  const double latest = requirement.seconds - proof_context.tick_gap_s;
  if (latest >= kShortest_s && !boundOf(proof_context, kLongestMission, Goal::Exit).by) {
    diagnostic.note(requirement.range,
                    fmt::format("no clock is sure to end the mission by then: as the first case of "
                                "`always`, `case missiontime > {} exit` would",
                                roundedDown(latest)));
  }
}

}  // namespace

void noteLateEnd(support::DiagnosticBuilder& diagnostic, const Requirement& requirement,
                 const ProofContext& proof_context) {
  const double seconds = requirement.seconds;
  const Mission& m = proof_context.mission;
  const std::vector<LateExit> late = neededAtTheTop(seconds, proof_context);
  for (size_t i = 0; i < std::min(late.size(), kMostLateExits); ++i) {
    diagnostic.note(m[listOf(m, late[i].state)[late[i].number].guard].range,
                    "this `exit` is not tried while a case above it fires; move it to the top");
  }
  if (!late.empty()) {
    return;
  }
  const bool noted = noteEndlessStay(diagnostic, proof_context);
  const LateExit elsewhere = neededInAlways(seconds, proof_context);
  if (!elsewhere.state.valid() && !noted) {
    noteMissingExit(diagnostic, requirement, proof_context);
  } else if (elsewhere.state.valid()) {
    const State& state = m[elsewhere.state];
    diagnostic.note(m[state.cases[elsewhere.number].guard].range,
                    fmt::format("this `exit` is tried only while `{}` is current; make it the "
                                "first case of `always`",
                                state.name));
  }
}

}  // namespace glider::ir::prove
