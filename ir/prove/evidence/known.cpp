// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/evidence/known.h"

#include "ir/certify/names.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/held_ranges.h"
#include "ir/prove/evidence/command_variables.h"
#include "ir/prove/evidence/formula.h"
#include "ir/prove/evidence/in_profile.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace glider::ir::prove {
namespace {

/// More stays than these are not worth their questions.
constexpr size_t kMostStays = 2000;

/// `time` + gap <= by, in exact numbers: the tick after the next gap may be the last.
std::string leftBy(const std::string& time, double gap, double by) {
  return fmt::format("(<= (+ {} {}) {})", time, realText(gap), realText(by));
}

}  // namespace

Known::Known(const ProofContext& proof_context, const EndBound& end)
    : proof_context_(proof_context),
      m_(proof_context.mission),
      bounds_(boundsOfStates(proof_context, end)),
      held_(heldVariables(m_)),
      commanded_(commandVariables(m_)),
      submersions_(submersionsOf(proof_context, end)),
      climbs_(climbTimes(proof_context)) {
  stays_ = staysOf(proof_context);
  if (stays_.size() > kMostStays) {
    stays_.clear();
  }
  for (size_t i = 0; i < stays_.size(); ++i) {
    certify::Configuration at = configurationOf(stays_[i].control);
    here_[at].push_back(i);
    if (at.just_returned) {  // until the next tick
      at.just_returned = false;
      here_[at].push_back(i);
    }
  }
}

std::string Known::ofStay(const Stay& stay, bool just_returned) const {
  FormulaParts parts;
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    const Variable& variable = m_.variables[i];
    if (isOfMonitor(variable.kind)) {
      continue;  // nothing is known of it there
    }
    if (!variable.owner.valid() || stay.control.holds(variable.owner)) {
      parts.holding(variable, stay.values[i]);
    }
  }
  parts.add(ofTimes(stay, just_returned));
  return parts.all();
}

std::string Known::ofTimes(const Stay& stay, bool just_returned) const {
  std::vector<std::string> times;
  for (const LeavingPart& stays : stay.parts) {
    if (stay.control.just_returned && stays.at_once && !just_returned) {
      continue;  // its own cases come first, and lead away
    }
    FormulaParts part;
    part.atLeast("|resumed|", stays.arriving.earliest);
    part.atMost("|resumed|", stays.arriving.latest);
    part.add(leftBy("|time|", proof_context_.tick_gap_s, stays.by));
    times.push_back(part.all());
  }
  return anyOf(times);
}

std::string Known::ofStays(const certify::Configuration& at) const {
  if (stays_.empty()) {
    return "true";
  }
  std::vector<std::string> all;
  if (const auto found = here_.find(at); found != here_.end()) {
    for (const size_t number : found->second) {
      all.push_back(ofStay(stays_[number], at.just_returned));
    }
  }
  return anyOf(all);
}

std::string Known::timerName() const {
  return certify::variableName(m_[submersions_.timer], "");
}

/// How long after the last tick at the surface a state became current, and the timer was set.
std::string Known::grown(const Submerged& from, bool climbs) const {
  FormulaParts parts;
  parts.add(fmt::format("(<= (- |resumed| |surfaced|) {})", realText(from.longest)));
  if (climbs) {
    parts.add(fmt::format("(<= (- |climbing since| |surfaced|) {})", realText(from.begun)));
  }
  if (submersions_.timer.valid()) {
    parts.add(fmt::format("(<= (- {} |surfaced|) {})", timerName(), realText(from.ahead)));
  }
  return parts.all();
}

std::string Known::timed(const Submersion& state) const {
  FormulaParts parts;
  parts.add(certify::variableName(m_[submersions_.timer], " known"));
  parts.add(fmt::format("(<= {} |time|)", timerName()));
  if (std::isfinite(state.timed)) {
    parts.add(anyOf({"(= |time| |resumed|)", "(= |time| |surfaced|)",
                     fmt::format("(<= (- |time| {}) {})", timerName(), realText(state.timed))}));
  }
  return parts.all();
}

std::string Known::climbIn(const certify::Configuration& at) const {
  FormulaParts parts;
  parts.add("(=> |climbing| (<= |climbing since| |time|))");
  if (std::isfinite(climbs_[at.state.index])) {
    parts.add("|climbing|");
    parts.add("(<= |climbing since| |resumed|)");
    parts.add("(<= |top| 0.0)");
  }
  return parts.all();
}

std::string Known::surfacedIn(const certify::Configuration& at) const {
  FormulaParts parts;
  parts.add("(<= 0.0 |surfaced| |time|)");
  if (submersions_.states.empty()) {
    return parts.all();
  }
  parts.add(climbIn(at));
  const Submersion state = submersions_.of(at);
  const bool climbs = std::isfinite(state.climb);
  std::vector<std::string> ways;
  if (state.entered.longest >= 0 && !at.just_returned) {
    ways.push_back(fmt::format("(and (= {} |resumed|) {})", certify::enteredName(at.stack.size()),
                               grown(state.entered, climbs)));
  }
  if (state.resumed.longest >= 0) {
    ways.push_back(grown(state.resumed, climbs));
  }
  parts.add(anyOf(ways));
  if (submersions_.timer.valid()) {
    parts.add(timed(state));
  }
  for (const certify::Waiting& waiting : at.stack) {
    parts.add(timesOfProfile(m_, submersions_.states[waiting.state.index].profile));
  }
  parts.add(timesOfProfile(m_, state.profile));
  parts.add(inProfile(m_, state.profile));
  if (climbs) {
    parts.add(fmt::format("(=> (>= (- |time| |climbing since|) {}) (= |surfaced| |time|))",
                          realText(state.climb)));
  }
  return parts.all();
}

std::string Known::in(const certify::Configuration& at) const {
  FormulaParts parts;
  const StateBounds& bounds = bounds_[at.state.index];
  parts.add(ofStays(at));
  for (size_t k = 0; k <= at.stack.size(); ++k) {
    const StateId state = k < at.stack.size() ? at.stack[k].state : at.state;
    parts.atLeast(certify::enteredName(k), bounds_[state.index].earliest);
  }
  parts.atMost("|deepest|", bounds.depth);
  if (bounds.resume_time < kLongestMission) {
    parts.add(leftBy("(- |time| |resumed|)", proof_context_.tick_gap_s, bounds.resume_time));
  }
  if (!mayWait(m_, at.state)) {
    parts.add(fmt::format("(= {} |resumed|)", certify::enteredName(at.stack.size())));
  }
  if (at.just_returned) {
    parts.add("(= |time| |resumed|)");
  }
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    const Variable& variable = m_.variables[i];
    if (!certify::hasStarted(variable, at)) {
      continue;
    }
    if (proof_context_.known.variables[i]) {
      parts.isKnown(variable);
    }
    if (commanded_[i] && variable.type.kind != TypeKind::Bool) {
      parts.knownWithin(variable, held_[i]);
    }
  }
  return parts.all();
}

}  // namespace glider::ir::prove
