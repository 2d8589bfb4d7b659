// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `avoidances`: cases that fire near the bottom and then command a dive (GL3117), usually
// an avoidance with the wrong state or depth. In: the cases that may fire (not Proof::dead) and the
// values that variables are ever set to. A hint: a case counts as "near the bottom" if it may be
// true at the lowest reading of `altitude` or `waterdepth` and not at the highest. No sensor of
// either kind, or a command without a range before it: nothing is reported.

#include "ir/core/walk.h"
#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/held_ranges.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/passes.h"
#include "ir/verify/intervals.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

using Commands = std::vector<const Statement*>;

/// A command to climb is not counted, although it may end in sinking to its depth.
bool leadsDown(const Statement& command) {
  return isDescent(command.command) || command.command == Command::Hover;
}

/// Looks for cases that fire near the bottom, or in shallow water, and then dive deeper than what
/// was commanded before.
class AvoidanceCheck {
 public:
  explicit AvoidanceCheck(Proof& proof)
      : proof_(proof), proof_context_(proof.proof_context), m_(proof_context_.mission) {
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      const platforms::PlatformSensor* row = proof_context_.platformSensor({i});
      if (row != nullptr && (row->alias == "altitude" || row->alias == "waterdepth")) {
        soundings_.push_back({i});
      }
    }
  }

  void run() {
    if (soundings_.empty()) {
      return;
    }
    held_ = heldIntervals(m_);
    values_ = anyValues(m_);
    checkAlways();
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      const State& state = m_.states[i];
      for (uint32_t k = 0; k < state.cases.size(); ++k) {
        if (isNearBottom({StateId{i}, k}, state.cases[k])) {
          check(state.cases[k], deepest(commandsOfActivities(state)));
        }
      }
    }
  }

 private:
  void checkAlways() {
    for (uint32_t k = 0; k < m_.always.size(); ++k) {
      const Case& c = m_.always[k];
      if (!isNearBottom({StateId(), k}, c)) {
        continue;
      }
      double before = 0;
      for (uint32_t i = 0; i < m_.states.size(); ++i) {
        if (c.target != StateId{i}) {
          before = std::max(before, deepest(commandsOfActivities(m_.states[i])));
        }
      }
      check(c, before);
    }
  }

  /// Without those of its cases, which are given on the way to another depth.
  [[nodiscard]] Commands commandsOfActivities(const State& state) const {
    Commands all = commandsOf(m_, state.profile);
    const Commands more = commandsOf(m_, state.route);
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  /// Whether the case fires for a low reading of one of the sensors and not for the highest.
  [[nodiscard]] bool isNearBottom(const CasePlace& place, const Case& c) const {
    return !proof_.dead.contains(place) && std::ranges::any_of(soundings_, [&](SensorId sensor) {
      const Interval& all = proof_context_.sensors[sensor.index];
      return !all.empty && mayBeTrue(c.guard, sensor, all.lowest) &&
             !mayBeTrue(c.guard, sensor, all.highest);
    });
  }

  [[nodiscard]] bool mayBeTrue(ExprId guard, SensorId sensor, double reading) const {
    constexpr Interval kEver{0, kGreatestNumber, false};
    const AssumedReading sight{sensor, {reading, reading, false}};
    return AbstractEvaluator(proof_context_, values_, {kEver, kEver, kEver}, sight)
        .truth(guard)
        .is_true;
  }

  /// An upper bound of the depths that the commands lead to, m; infinite: there is none.
  [[nodiscard]] double deepest(const Commands& commands) const {
    double depth = 0;
    for (const Statement* command : commands) {
      if (movesActuators(command->command)) {
        return kNoEnd;
      }
      if (leadsDown(*command)) {
        const Interval& target = held_[command->values.at(0).index];
        depth = target.empty ? depth : std::max(depth, target.highest);
      }
    }
    return depth;
  }

  /// A depth to which some of the commands certainly lead, for any values of the variables.
  [[nodiscard]] double certainDepth(const Commands& commands) const {
    double depth = 0;
    for (const Statement* command : commands) {
      const Interval& target =
          leadsDown(*command) ? held_[command->values.at(0).index] : Interval{0, 0, true};
      depth = target.empty ? depth : std::max(depth, target.lowest);
    }
    return depth;
  }

  /// `before`: the depth that was commanded before, m.
  void check(const Case& c, double before) {
    Commands given;
    forEachCommand(c.action, given);
    const double own = certainDepth(given);
    const double then = c.target.valid() ? certainDepth(commandsOfActivities(m_[c.target])) : 0;
    const double deep = std::max(own, then);
    if (deep <= before || before >= kNoEnd) {
      return;
    }
    const std::string who = own >= then ? "its `do` commands a dive"
                                        : fmt::format("state `{}` dives", m_[c.target].name);
    proof_.diagnostics.report(support::diagnostics::divesNearBottom, m_[c.guard].range, who,
                              fmt::format("{:.4g} m", deep), fmt::format("{:.4g} m", before));
  }

  void forEachCommand(BlockId block, Commands& given) const {
    forEachStatement(m_, block, [&](const Statement& statement) {
      if (statement.kind == StatementKind::Command) {
        given.push_back(&statement);
      }
    });
  }

  Proof& proof_;
  const ProofContext& proof_context_;
  const Mission& m_;
  std::vector<SensorId> soundings_;  ///< sensors that tell how near the bottom is
  std::vector<Interval> held_;       ///< of every expression
  Valuation values_;
};

}  // namespace

void passes::avoidances(Proof& proof) {
  AvoidanceCheck(proof).run();
}

}  // namespace glider::ir::prove
