// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/energy/profile_legs.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/held_ranges.h"
#include "ir/prove/abstract/mode_ways.h"
#include "ir/prove/abstract/timer_guards.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/context/same_expression.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace glider::ir::prove {
namespace {

constexpr Interval kAnyTime{0, kGreatestNumber, false};

/// The command of one kind that a profile may give.
struct Commanded {
  const Statement* statement = nullptr;
  bool followed = true;  ///< it is one command, the same whenever it is given
  DepthSpan to{std::numeric_limits<double>::infinity(), 0};
};

Drive driveOf(Command command, const Commanded& of) {
  switch (command) {
    case Command::Descend:
    case Command::DescendAt:
      // Where it is shallower than that, it may be the surface.
      return of.to.shallowest < kUnderWater_m ? Drive::Anywhere : Drive::Down;
    case Command::Ascend:
    case Command::AscendAt:
    case Command::Surface:
      return Drive::Up;
    case Command::Hover:
      return Drive::Hover;
    case Command::Steer:
    case Command::SteerTo:
    case Command::Drift:
    case Command::Fin:
    case Command::Pump:
    case Command::Battery:
      return Drive::Anywhere;
  }
  return Drive::Anywhere;
}

class LegSearch {
 public:
  LegSearch(const LegContext& context, StateId id)
      : context_(context),
        seen_(context.seen),
        m_(seen_.mission),
        id_(id),
        profile_(m_[id].profile),
        values_(context.values),
        guards_(context.guards),
        timers_(timersOfProfile(m_, guards_, id)),
        ways_(seen_, profile_) {}

  ProfileLegs run() {
    gatherSet();
    gatherCommands();
    if (othersInterfere(m_, id_) || !ways_.explore()) {
      return anywhere();
    }
    number();
    for (const auto& [mode, ways] : ways_.all()) {
      for (const ModeWay& way : ways) {
        turn(mode, way);
      }
    }
    for (const auto& [mode, place] : numbers_) {
      found_.legs[place].turns_there = turnsThere(mode, found_.legs[place]);
    }
    if (std::ranges::find(found_.legs, Drive::Anywhere, &ProfileLeg::drive) != found_.legs.end()) {
      found_.steepest_rad = seen_.platform.envelope.steepest_pitch_rad;
    }
    return std::move(found_);
  }

 private:
  ProfileLegs anywhere() {
    found_ = {{ProfileLeg{}}, {0}, {}, seen_.platform.envelope.steepest_pitch_rad};
    return std::move(found_);
  }

  /// Two commands of one kind lead both ways if their targets differ, and so does one whose target
  /// moves; one with an unknown argument changes nothing (S4).
  void gatherCommands() {
    const std::vector<Interval>& held = context_.held;
    for (const Statement* statement : commandsOf(m_, profile_)) {
      if (!isVertical(statement->command)) {
        continue;
      }
      Commanded& of = commanded_[statement->command];
      of.followed = of.followed && isOne(*statement, of.statement);
      of.statement = statement;
      const Interval to =
          statement->values.empty() ? Interval{0, 0, false} : held[statement->values[0].index];
      if (!to.empty) {
        of.to = {std::min(of.to.shallowest, to.lowest), std::max(of.to.deepest, to.highest)};
      }
      const double usual = seen_.platform.envelope.usual_pitch_rad;
      const Interval pitch = statement->values.size() > 1 ? held[statement->values[1].index]
                                                          : Interval{usual, usual, false};
      found_.steepest_rad = std::max(found_.steepest_rad, pitch.empty ? 0 : pitch.highest);
    }
  }

  /// Whether a command is always the same, and the same as `other` if there is one.
  [[nodiscard]] bool isOne(const Statement& statement, const Statement* other) const {
    for (size_t i = 0; i < statement.values.size(); ++i) {
      const ExprId value = statement.values[i];
      if (!isSteady(value) || !seen_.known.expressions[value.index] ||
          (other != nullptr && !isSameExpression(m_, value, other->values[i]))) {
        return false;
      }
    }
    return true;
  }

  /// One leg for each mode.
  void number() {
    for (const auto& [mode, ways] : ways_.all()) {
      numbers_.emplace(mode, found_.legs.size());
      // What was commanded before goes on where the profile commands nothing.
      ProfileLeg leg;
      if (mode.command && commanded_.at(*mode.command).followed) {
        leg.target = commanded_.at(*mode.command).to;
        leg.drive = driveOf(*mode.command, commanded_.at(*mode.command));
        leg.command = mode.command;
      }
      found_.legs.push_back(leg);
    }
    std::set<size_t> first;
    for (const Mode& mode : ways_.modes().begin()) {
      first.insert(numbers_.at(mode));
    }
    for (const auto& [mode, place] : numbers_) {
      for (const Mode& again : ways_.resumed(mode)) {
        first.insert(numbers_.at(again));
      }
    }
    found_.first.assign(first.begin(), first.end());
  }

  /// The values of variables in a mode.
  [[nodiscard]] Valuation valuesIn(const Mode& mode) const {
    Valuation values = values_;
    for (size_t i = 0; i < mode.truths.size(); ++i) {
      const bool is = mode.truths[i] == Truth::True;
      values[ways_.modes().own()[i].index].truths = {is, !is, false};
    }
    return values;
  }

  void turn(const Mode& mode, const ModeWay& way) {
    if (way.to == mode) {
      return;
    }
    const Valuation values = valuesIn(mode);
    if (const auto where = depthsWhere(seen_, values, {kAnyTime, kAnyTime, kAnyTime},
                                       profile_.cases[way.by].guard)) {
      LegTurn turn{
          numbers_.at(mode), numbers_.at(way.to), *where, limitsOf(way.by, values), {}, {}};
      for (const VariableId timer : timers_) {
        const double least = guards_.onlyAfter(profile_.cases[way.by].guard, timer);
        if (least > 0) {
          turn.waits.push_back({timer, least});
        }
        if (setsForSure(m_, profile_.cases[way.by].action, timer)) {
          turn.sets.push_back(timer);
        }
      }
      found_.turns.push_back(std::move(turn));
    }
  }

  /// The conditions of a case on the depth, by limits that nothing changes meanwhile.
  [[nodiscard]] std::vector<DepthCondition> limitsOf(size_t by, const Valuation& values) const {
    if (!seen_.depth) {
      return {};
    }
    const AbstractEvaluator ever(seen_, values, {kAnyTime, kAnyTime, kAnyTime});
    std::vector<DepthCondition> all =
        depthConditions(m_, profile_.cases[by].guard, *seen_.depth,
                        [&](ExprId id) { return !ever.truth(id).is_true; });
    std::erase_if(all, [&](const DepthCondition& one) { return !isSteady(one.limit); });
    return all;
  }

  /// Whether a number stays the same while the state is current.
  [[nodiscard]] bool isSteady(ExprId id) const {
    return !anyIn(m_, id, [&](const Expr& e) {
      const OpGroup group = groupOf(e.op);
      return group == OpGroup::Sensor || group == OpGroup::Clock || group == OpGroup::Temporal ||
             group == OpGroup::Age || group == OpGroup::Call ||
             (e.op == Op::Variable && set_.contains(e.variable.index));
    });
  }

  /// What may be set while the state is current.
  void gatherSet() {
    const auto look = [&](const Statement& statement) {
      if (statement.kind == StatementKind::Set) {
        set_.insert(statement.variable.index);
      }
    };
    forEachStatement(m_, m_.every_tick, look);
    const State& state = m_[id_];
    for (const auto* cases : {&m_.always, &state.cases, &state.profile.cases, &state.route.cases}) {
      for (const Case& c : *cases) {
        if (staysIn(c.transition)) {
          forEachStatement(m_, c.action, look);
        }
      }
    }
  }

  /// Whether a case certainly leads another way as soon as the vehicle reads the target, or has
  /// passed it: by a guard that is certain there, before any that may be true and does not.
  [[nodiscard]] bool turnsThere(const Mode& mode, const ProfileLeg& leg) const {
    if (leg.drive != Drive::Down && leg.drive != Drive::Up) {
      return true;
    }
    if (mode.command == Command::Surface || !seen_.depth) {
      return mode.command == Command::Surface;
    }
    const Interval& all = seen_.sensors[seen_.depth->index];
    const Interval there = leg.drive == Drive::Down
                               ? Interval{leg.target.deepest, all.highest, false}
                               : Interval{all.lowest, leg.target.shallowest, false};
    const bool one = leg.target.shallowest == leg.target.deepest;
    if (!(there.lowest <= there.highest)) {
      return false;
    }
    const Valuation values = valuesIn(mode);
    const AbstractEvaluator at(seen_, values, {kAnyTime, kAnyTime, kAnyTime},
                               AssumedReading{*seen_.depth, there});
    for (size_t i = 0; i < profile_.cases.size(); ++i) {
      const Truths& guard = at.truth(profile_.cases[i].guard);
      if (guard.is_true && !leadsAnotherWay(mode, i)) {
        return false;
      }
      const bool certain = one ? guard.is_true && !guard.is_false && !guard.is_unknown
                               : isTrueAt(profile_.cases[i].guard, mode);
      if (certain) {
        return true;
      }
    }
    return false;
  }

  /// Whether a guard is true wherever the vehicle reads the target of the command, or has passed
  /// it, for any value of that target.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] bool isTrueAt(ExprId guard, const Mode& mode) const {
    const Expr& e = m_[guard];
    if (e.op == Op::Or) {
      return isTrueAt(e.operands[0], mode) || isTrueAt(e.operands[1], mode);
    }
    const bool down = mode.command == Command::Descend;
    const bool plain = e.op == (down ? Op::GreaterEqual : Op::LessEqual);
    return plain && m_[e.operands[0]].op == Op::Sensor && m_[e.operands[0]].sensor == seen_.depth &&
           isSameExpression(m_, e.operands[1], commanded_.at(*mode.command).statement->values[0]);
  }

  /// Whether a case ends the command of this mode.
  [[nodiscard]] bool leadsAnotherWay(const Mode& mode, size_t by) const {
    return std::ranges::all_of(ways_.modes().run(profile_.cases[by].action, {mode}),
                               [&](const Mode& to) { return to.command != mode.command; });
  }

  const LegContext& context_;
  const ProofContext& seen_;
  const Mission& m_;
  StateId id_;
  const Activity& profile_;
  const Valuation& values_;
  const TimerGuards& guards_;
  std::vector<VariableId> timers_;
  ModeWays ways_;
  std::map<Command, Commanded> commanded_;
  std::set<uint32_t> set_;  ///< variables
  std::map<Mode, size_t> numbers_;
  ProfileLegs found_;
};

}  // namespace

LegContext::LegContext(const ProofContext& known)
    : seen(known),
      held(heldIntervals(known.mission)),
      values(anyValues(known.mission)),
      guards(known, values, std::numeric_limits<double>::infinity()) {}

ProfileLegs legsOf(const LegContext& context, StateId state) {
  return LegSearch(context, state).run();
}

}  // namespace glider::ir::prove
