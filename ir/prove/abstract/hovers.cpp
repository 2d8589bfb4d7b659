// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/hovers.h"

#include "ir/core/walk.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/earliest_entry.h"
#include "ir/prove/abstract/held_ranges.h"
#include "ir/prove/abstract/leaving.h"
#include "ir/prove/context/commands.h"
#include "ir/verify/intervals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace glider::ir::prove {
namespace {

constexpr double kForEver = std::numeric_limits<double>::infinity();
/// Depths that differ by less are one depth, for the vehicle's abend too, m.
constexpr double kSameDepth = 1;
/// A vehicle that arrives reads a little more, or less, than the depth that is commanded, m.
constexpr double kPast = 0.01;

/// Of a mission with more such states nothing is said: each pair of them is compared.
constexpr size_t kMostHovers = 200;

/// The mission as it is where its vehicle has arrived at `depth` and its profiles are done.
class Arrived {
 public:
  Arrived(const ProofContext& proof_context, double depth)
      : mission_(at(proof_context, depth)),
        context_(ProofContext(mission_, proof_context.platform).withoutPowerCuts()),
        values_(anyValues(mission_)) {
    for (const State& state : mission_.states) {
      if (state.profile.done.valid()) {
        values_[state.profile.done.index].truths = {true, false, false};
      }
    }
  }

  [[nodiscard]] double stays(StateId id) const {
    return stayOf(context_, mission_[id], {neverPrevented(mission_), false}, values_).by;
  }
  /// Whether a command that `given` says may be given there.
  template <typename Given>
  [[nodiscard]] bool mayCommand(StateId id, const Given& given) const {
    constexpr Interval kEver{0, kGreatestNumber, false};
    const AbstractEvaluator evaluator(context_, values_, {kEver, kEver, kEver});
    const State& state = mission_[id];
    for (const BlockId entry : {state.entry, state.profile.entry, state.route.entry}) {
      if (inBlock(evaluator, entry, given)) {
        return true;
      }
    }
    for (const auto* cases : {&state.cases, &state.profile.cases, &state.route.cases}) {
      for (const Case& c : *cases) {
        if (evaluator.truth(c.guard).is_true && inBlock(evaluator, c.action, given)) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  static Mission at(const ProofContext& proof_context, double depth) {
    Mission mission = proof_context.mission;
    for (Expr& e : mission.exprs) {
      if (e.op == Op::Sensor && e.sensor == proof_context.depth) {
        e.op = Op::Constant;
        e.number = depth;
      }
    }
    return mission;
  }
  template <typename Given>
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  bool inBlock(const AbstractEvaluator& evaluator, BlockId block, const Given& given) const {
    if (!block.valid()) {
      return false;
    }
    return std::ranges::any_of(mission_[block].statements, [&](const Statement& statement) {
      if (statement.kind == StatementKind::If) {
        const Truths& condition = evaluator.truth(statement.value);
        return (condition.is_true && inBlock(evaluator, statement.then, given)) ||
               (condition.is_false && inBlock(evaluator, statement.otherwise, given));
      }
      return statement.kind == StatementKind::Command && given(statement);
    });
  }

  Mission mission_;
  ProofContext context_;
  Valuation values_;
};

/// What a state does that stays at one depth.
struct HoverInState {
  double shallow = 0, deep = 0;  ///< the same unless it is a variable
  double for_s = 0;
};

class HoverSearch {
 public:
  HoverSearch(const ProofContext& proof_context, const EndBound& end)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        end_(end),
        held_(heldIntervals(m_)),
        entries_(earliestEntries(proof_context)) {
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      target_.push_back(oneDepth({i}));
      if (target_.back()) {
        hovers_.push_back({i});
      }
    }
  }

  std::vector<LongHover> run() {
    std::vector<LongHover> found;
    if (hovers_.size() > kMostHovers) {
      return found;
    }
    stays_.resize(m_.states.size());
    for (const StateId id : hovers_) {
      stays_[id.index] = staysAt(id, *target_[id.index]);
    }
    for (const StateId id : hovers_) {
      if (stays_[id.index] && !continues(id, found)) {
        found.push_back(hover(id));
      }
    }
    return found;
  }

 private:
  [[nodiscard]] LongHover hover(StateId id) {
    const double there = longest(id);
    const double most = end_.by ? std::max(0.0, *end_.by - entries_[id.index]) : kForEver;
    const HoverInState& one = *stays_[id.index];
    return {id, one.deep, std::min(there, most) - arrives(id)};
  }

  /// It takes at least that long to get there if the mission begins with it, s.
  [[nodiscard]] double arrives(StateId id) const {
    const auto& platform = proof_context_.platform;
    const double way = stays_[id.index]->shallow - platform.world.start_depth_m;
    return id.index == 0 ? std::max(0.0, way) / platform.envelope.vertical_rate_m_s : 0;
  }

  /// From `id` on at one depth; infinite if it may come back to a state that it has left.
  // NOLINTNEXTLINE(misc-no-recursion): as long as a path of states at one depth
  double longest(StateId id) {
    const auto [at, is_new] = longest_.emplace(id.index, kForEver);
    if (!is_new) {
      return at->second;
    }
    double then = 0;
    for (const StateId next : hovers_) {
      if (follows(next, id)) {
        then = std::max(then, longest(next));
      }
    }
    return longest_[id.index] = stays_[id.index]->for_s + then;
  }

  /// Whether `next` may follow `id` at the same depth.
  [[nodiscard]] bool follows(StateId next, StateId id) const {
    const auto& a = stays_[id.index];
    const auto& b = stays_[next.index];
    if (!a || !b || b->shallow - a->deep >= kSameDepth || a->shallow - b->deep >= kSameDepth) {
      return false;
    }
    const auto enters = [&](const Case& c) { return c.target == next; };
    const bool returns = std::ranges::find(m_[id].cases, Transition::Return, &Case::transition) !=
                         m_[id].cases.end();
    const auto calls = [&](const Case& c) {
      return c.transition == Transition::Call && c.target == id;
    };
    return std::ranges::any_of(m_[id].cases, enters) || std::ranges::any_of(m_.always, enters) ||
           (returns &&
            (std::ranges::any_of(m_[next].cases, calls) || std::ranges::any_of(m_.always, calls)));
  }

  /// Whether it is part of one that was found.
  [[nodiscard]] bool continues(StateId id, const std::vector<LongHover>& found) const {
    return std::ranges::any_of(found, [&](const LongHover& one) { return follows(id, one.state); });
  }

  /// None if it may be at several depths, at the surface, or anywhere.
  [[nodiscard]] std::optional<Interval> oneDepth(StateId id) const {
    const State& state = m_[id];
    if (!m_[state.profile.behaviour].symbol.empty() || !m_[state.route.behaviour].symbol.empty()) {
      return std::nullopt;
    }
    std::optional<Interval> depth;
    std::optional<ExprId> target;
    for (const Statement* command : commandsOf(m_, state)) {
      if (movesActuators(command->command)) {
        return std::nullopt;
      }
      if (!isDescent(command->command) && !isAscent(command->command) &&
          command->command != Command::Hover) {
        continue;
      }
      const ExprId to = command->values.at(0);
      const Interval& here = held_[to.index];
      const bool same = !depth || (depth->lowest == here.lowest && depth->highest == here.highest);
      if (here.empty || !same || (target && !isOneTarget(*target, to, here))) {
        return std::nullopt;
      }
      depth = here;
      target = to;
    }
    const bool fixed = depth && (depth->lowest == depth->highest || isKept(state, *target));
    if (!fixed || depth->lowest < kSurfaceCommand_m || !std::isfinite(depth->highest)) {
      return std::nullopt;
    }
    return depth;
  }

  [[nodiscard]] bool isOneTarget(ExprId a, ExprId b, const Interval& here) const {
    const bool same =
        m_[a].op == Op::Variable && m_[b].op == Op::Variable && m_[a].variable == m_[b].variable;
    return here.lowest == here.highest || same;
  }
  /// Whether the target is a variable that nothing in the state sets.
  [[nodiscard]] bool isKept(const State& state, ExprId target) const {
    if (m_[target].op != Op::Variable) {
      return false;
    }
    bool kept = true;
    const auto look = [&](BlockId block) {
      forEachStatement(m_, block, [&](const Statement& statement) {
        kept = kept &&
               !(statement.kind == StatementKind::Set && statement.variable == m_[target].variable);
      });
    };
    for (const auto* cases : {&m_.always, &state.cases, &state.profile.cases, &state.route.cases}) {
      for (const Case& c : *cases) {
        if (staysIn(c.transition)) {
          look(c.action);
        }
      }
    }
    return kept;
  }

  const Arrived& arrived(double depth) {
    auto& made = arrived_[depth];
    if (!made) {
      made = std::make_unique<Arrived>(proof_context_, depth);
    }
    return *made;
  }

  std::optional<HoverInState> staysAt(StateId id, const Interval& depth) {
    HoverInState found{depth.lowest, depth.highest, kForEver};
    const auto surfaces = [](const Statement& command) {
      return command.command == Command::Surface;
    };
    for (const double at : {depth.lowest - kPast, depth.lowest + kPast, depth.highest - kPast,
                            depth.highest + kPast}) {
      if (arrived(at).mayCommand(id, surfaces)) {
        return std::nullopt;
      }
      found.for_s = std::min(found.for_s, arrived(at).stays(id));
    }
    // With a tick in each cycle it is not late.
    found.for_s = std::max(0.0, found.for_s - proof_context_.platform.world.tick_gap_s);
    return found;
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  const EndBound& end_;
  std::vector<Interval> held_;
  std::vector<double> entries_;
  // Of each state, none if it does not stay at one depth:
  std::vector<std::optional<Interval>> target_;
  std::vector<std::optional<HoverInState>> stays_;
  std::vector<StateId> hovers_;
  std::map<uint32_t, double> longest_;
  std::map<double, std::unique_ptr<Arrived>> arrived_;
};

}  // namespace

std::vector<LongHover> longHovers(const ProofContext& proof_context, const EndBound& end) {
  const bool any = std::ranges::any_of(proof_context.mission.states, [&](const State& state) {
    const auto commands = commandsOf(proof_context.mission, state);
    return std::ranges::find(commands, Command::Hover, &Statement::command) != commands.end();
  });
  return any ? HoverSearch(proof_context, end).run() : std::vector<LongHover>();
}

}  // namespace glider::ir::prove
