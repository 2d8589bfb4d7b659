// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `chattering`: pairs of states between which a mission can alternate on every tick while
// the readings do not change, or change by no more than their noise. Out: lines of the report only
// (`check --report`), never a diagnostic, because it may be intended. Each pair is three symbolic
// ticks and one question to Z3 for each way through them, so large missions are left out
// (kMostChatteringStates). Results that Z3 takes for free must be those of the readings. A line
// may be wrong: the first tick is at any moment, also at one that no flight reaches.

#include "ir/prove/encoding/cone_of_influence.h"
#include "ir/prove/encoding/confirmation.h"
#include "ir/prove/encoding/kept_assumptions.h"
#include "ir/prove/encoding/layout.h"
#include "ir/prove/encoding/question.h"
#include "ir/prove/passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// For larger missions the lines would be too many to read.
constexpr size_t kMostChatteringStates = 200;

/// Looks for states between which a mission goes back and forth on each tick while the readings
/// stay the same, or differ only by their noise. Each pair is a line of the report, as it may be
/// intended.
class ChatteringCheck {
 public:
  explicit ChatteringCheck(Proof& proof)
      : proof_(proof),
        proof_context_(proof.proof_context),
        m_(proof.proof_context.mission),
        relevance_(relevanceFor(m_, {}, false)),
        layout_(proof_context_, relevance_, memory_) {}

  void run() {
    if (m_.states.size() > kMostChatteringStates) {
      return;
    }
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      if (!hasReturn(m_.states[i].cases)) {  // it is checked with an empty stack
        check({i}, false);
        check({i}, true);
      }
    }
  }

 private:
  static bool hasReturn(const std::vector<Case>& cases) {
    return std::ranges::any_of(cases,
                               [](const Case& c) { return c.transition == Transition::Return; });
  }

  /// False for an impossible configuration: a return without a caller.
  bool isSound(const Configuration& configuration) const {
    const Control& control = configuration.control;
    return !control.stack.empty() || !hasReturn(m_[control.state].cases);
  }

  static bool returns(const std::vector<Case>& cases, StateId to) {
    return std::ranges::any_of(
        cases, [&](const Case& c) { return c.transition == Transition::Return || c.target == to; });
  }

  std::vector<Outcome> ticksAt(const Configuration& before, int cycles) {
    const double later = proof_context_.platform.envelope.cycle_s * cycles;
    const z3::expr now = *begin_ + realOf(proof_.context, later);
    SymbolicState& readings = cycles == 2 ? *other_readings_ : *readings_;
    return SymbolicTick(proof_context_, relevance_, *unknowns_)
        .run(before, now, readings, Pace::Single);
  }

  /// With `noisy`, only for what does not go back and forth while nothing changes at all.
  void check(StateId from, bool noisy) {
    noisy_ = noisy;
    Unknowns unknowns(proof_.context, "b:");
    unknowns_ = &unknowns;
    Control control;
    control.state = from;
    Configuration start = layout_.make(control, unknowns);
    if (isNeverResumed(m_, from)) {
      start.resumed = start.entered.back();
    }
    keepRanges(start);
    const z3::expr begin = unknowns.real("begin");
    begin_ = &begin;
    const z3::expr& entered = start.entered.back();
    for (const z3::expr& since : {entered, start.resumed}) {
      unknowns.require(since >= 0 && since <= begin);
    }
    SymbolicState readings(unknowns, proof_context_);
    readings.relateRemainders();
    readings.setClocks(begin, begin - entered, begin - start.resumed);
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      (void)readings.reading({i});
    }
    SymbolicState others = readings;
    if (noisy) {
      addNoise(readings, others);
    }
    readings_ = &readings;
    other_readings_ = &others;
    for (const Outcome& there : ticksAt(start, 1)) {
      const bool leaves =
          there.fired && there.after && isSound(*there.after) && there.after->control.state != from;
      const StateId to = leaves ? there.after->control.state : from;
      if (leaves && !told(from, to) && (returns(m_[to].cases, from) || returns(m_.always, from)) &&
          checkBack(there, from)) {
        tell(from, to);
      }
    }
  }

  /// What a variable holds lies in its range.
  void keepRanges(const Configuration& configuration) {
    for (const auto& [index, term] : configuration.store.numbers) {
      const Variable& variable = m_.variables[index];
      const bool kept = !term.value.is_numeral();
      if (kept && std::isfinite(variable.lowest)) {
        unknowns_->require(term.value >= realOf(proof_.context, variable.lowest));
      }
      if (kept && std::isfinite(variable.highest)) {
        unknowns_->require(term.value <= realOf(proof_.context, variable.highest));
      }
    }
  }

  /// On the tick between, each known value differs by at most the noise of its sensor.
  void addNoise(SymbolicState& readings, SymbolicState& others) const {
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      const platforms::PlatformSensor* row = proof_context_.platformSensor({i});
      const bool noisy =
          row != nullptr && row->noise > 0 && m_.sensors[i].encoding != Encoding::DegreesMinutes;
      if (!noisy) {
        continue;
      }
      const NumberTerm one = readings.reading({i});
      NumberTerm other = one;
      other.value = others.unknowns().real("noisy");
      const z3::expr noise = realOf(proof_.context, row->noise * m_.sensors[i].to_si);
      others.unknowns().require(other.value <= one.value + noise &&
                                other.value >= one.value - noise);
      const Interval& range = proof_context_.sensors[i];
      others.unknowns().require(other.value >= realOf(proof_.context, range.lowest) &&
                                other.value <= realOf(proof_.context, range.highest));
      others.setReading({i}, other);
    }
  }

  /// Whether the mission goes back on the next tick, and there again on the one after.
  bool checkBack(const Outcome& there, StateId from) {
    for (const Outcome& back : ticksAt(*there.after, 2)) {
      if (back.fired && back.after && back.after->control.state == from && again(there, back)) {
        return true;
      }
    }
    return false;
  }

  bool again(const Outcome& there, const Outcome& back) {
    for (const Outcome& once_more : ticksAt(*back.after, 3)) {
      if (once_more.fired != there.fired || once_more.list != there.list) {
        continue;
      }
      keepAssumptions(*readings_);
      keepAssumptions(*other_readings_);
      Question question(proof_.context, proof_.checks, proof_.options.effort);
      question.add(*unknowns_);
      question.add(there.condition && back.condition && once_more.condition);
      if (question.ask() != Answer::Yes) {
        continue;
      }
      const z3::model model = question.model();
      SymbolicState* const moments[] = {readings_, other_readings_};
      if (fitReadings(model, *unknowns_, moments)) {
        witness_ = describe(model, *readings_);
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool told(StateId from, StateId to) const {
    return std::ranges::find(told_, std::pair(to, from)) != told_.end() ||
           std::ranges::find(told_, std::pair(from, to)) != told_.end();
  }

  void tell(StateId from, StateId to) {
    told_.emplace_back(from, to);
    proof_.findings.lines.push_back(
        {m_[from].range,
         fmt::format("possible livelock: `{}` and `{}` can alternate on every tick{}: {}",
                     m_[from].name, m_[to].name, noisy_ ? ", within the noise of the sensors" : "",
                     witness_)});
  }

  Proof& proof_;
  const ProofContext& proof_context_;
  const Mission& m_;
  ConeOfInfluence relevance_;
  std::vector<MemoryTerm> memory_;
  Layout layout_;
  Unknowns* unknowns_ = nullptr;
  const z3::expr* begin_ = nullptr;
  SymbolicState* readings_ = nullptr;        ///< of the first tick and the third
  SymbolicState* other_readings_ = nullptr;  ///< of the second
  bool noisy_ = false;
  std::string witness_;
  std::vector<std::pair<StateId, StateId>> told_;
};

}  // namespace

void passes::chattering(Proof& proof) {
  if (proof.options.report) {
    ChatteringCheck(proof).run();
  }
}

}  // namespace glider::ir::prove
