// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/state_depths.h"

#include "ir/core/walk.h"
#include "ir/prove/abstract/held_ranges.h"
#include "ir/prove/abstract/sum_at_most.h"
#include "ir/prove/context/commands.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace glider::ir::prove {
namespace {

constexpr double kWhateverDepth = std::numeric_limits<double>::infinity();
/// A greater bound means that the number has no range.
constexpr double kUnbounded = 1e300;

/// Also under a command to climb, which ends in hovering at its target.
bool leadsDown(const Statement& statement) {
  return statement.kind == StatementKind::Command &&
         (isDescent(statement.command) || statement.command == Command::Hover ||
          isAscent(statement.command));
}

class Depths {
 public:
  explicit Depths(const ProofContext& proof_context)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        held_(heldIntervals(proof_context.mission)),
        deepest_(m_.states.size()) {
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      if (anyOf(m_.states[i].cases, Transition::Call) || anyOf(m_.always, Transition::Call)) {
        callers_.push_back(i);
      }
    }
  }

  /// The depth that a state commands is one at which every later state may begin: the deepest
  /// commands first.
  std::vector<double> run() {
    std::vector<double> own;
    for (const State& state : m_.states) {
      own.push_back(greatestDepth(state));
    }
    std::vector<uint32_t> order(own.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, [&](uint32_t a, uint32_t b) { return own[a] > own[b]; });
    seen_.assign(own.size(), false);
    for (const uint32_t state : order) {
      spread(state, own[state]);
    }
    return deepest_;
  }

 private:
  static bool anyOf(const std::vector<Case>& cases, Transition transition) {
    return std::ranges::find(cases, transition, &Case::transition) != cases.end();
  }

  /// By the state's own commands, or from the depth at which control may be given; m.
  double greatestDepth(const State& state) const {
    if (!m_[state.profile.behaviour].symbol.empty() || !m_[state.route.behaviour].symbol.empty()) {
      return kWhateverDepth;
    }
    const platforms::Envelope& envelope = proof_context_.platform.envelope;
    const platforms::EnvironmentModel& world = proof_context_.platform.world;
    const double overshoot = envelope.inflection_overshoot_m;
    double deepest = sumAtMost(world.start_depth_m, overshoot);
    const auto look = [&](const Statement& statement) {
      if (statement.kind == StatementKind::Command && movesActuators(statement.command)) {
        deepest = std::max(deepest, sumAtMost(envelope.greatest_depth_m, overshoot));  // V8
      } else if (leadsDown(statement)) {
        const Interval& target = held_[statement.values.at(0).index];
        const double below =
            isAscent(statement.command) ? world.climb_hold_m + overshoot : overshoot;
        const double depth =
            target.highest < kUnbounded ? sumAtMost(target.highest, below) : kWhateverDepth;
        deepest = std::max(deepest, target.empty ? deepest : depth);
      }
    };
    forEachStatement(m_, state.entry, look);
    forEachStatement(m_, state.profile.entry, look);
    forEachStatement(m_, state.route.entry, look);
    for (const auto* cases : {&m_.always, &state.cases, &state.profile.cases, &state.route.cases}) {
      for (const Case& c : *cases) {
        forEachStatement(m_, c.action, look);
      }
    }
    return deepest;
  }

  void spread(uint32_t from, double depth) {
    reach(from, depth);
    while (!open_.empty()) {
      const State& state = m_.states[open_.back()];
      open_.pop_back();
      for (const auto* cases : {&m_.always, &state.cases}) {
        for (const Case& c : *cases) {
          if (c.target.valid()) {
            reach(c.target.index, depth);
          }
        }
        if (anyOf(*cases, Transition::Return)) {
          std::ranges::for_each(callers_, [&](uint32_t caller) { reach(caller, depth); });
        }
      }
    }
  }

  void reach(uint32_t state, double depth) {
    if (!seen_[state]) {
      seen_[state] = true;
      deepest_[state] = depth;
      open_.push_back(state);
    }
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  std::vector<Interval> held_;  ///< of every expression
  std::vector<double> deepest_;
  std::vector<uint32_t> callers_;  ///< states that a `return` may resume
  std::vector<bool> seen_;
  std::vector<uint32_t> open_;
};

}  // namespace

std::vector<double> deepestByState(const ProofContext& proof_context) {
  return Depths(proof_context).run();
}

}  // namespace glider::ir::prove
