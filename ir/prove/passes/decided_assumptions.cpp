// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `decidedAssumptions`: assumptions about what the mission itself decides, such as its
// duration or depth (GL3136). From them everything could be proved that they are about. In: each
// assumption with a range or a condition. Out: an error, and its number in
// Proof::decided_assumptions; `requirements` then proves without any assumption. The readings of
// the sea are set so that they make the condition true if they can (Projection); if something that
// the mission may do makes it false nevertheless, it is refused. The rules for pilots are in
// docs/verification.md, "What may be assumed".

#include "ir/core/mission_writer.h"
#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/context/decided_by_mission.h"
#include "ir/prove/encoding/any_moment.h"
#include "ir/prove/passes.h"
#include "ir/verify/intervals.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace glider::ir::prove {
namespace {

/// Of the sea, in one comparison; with more of them it is taken to be satisfiable.
constexpr size_t kMostReadings = 3;
constexpr double kMetresPerBar = 10;

/// What a condition says of the mission alone: that the sea can make it true. A part that reads the
/// sea only can be, unless no readings make it so; a comparison that also reads what the mission
/// decides can be if the least, the middle or the greatest reading of each sensor of the sea makes
/// it so.
class Projection {
 public:
  Projection(Mission& mission, const ProofContext& proof_context, unsigned effort, Budget& budget)
      : m_(mission),
        write_(mission),
        proof_context_(proof_context),
        effort_(effort),
        budget_(budget),
        true_(write_.truth(true)),
        false_(write_.truth(false)) {}

  /// A condition that is false only where, for what the mission decides, no reading of the sea
  /// makes `condition` true (or false, if `wanted` is false).
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the condition nests
  ExprId canBe(ExprId condition, bool wanted) {
    const Expr e = m_[condition];
    if (readsSeaOnly(condition)) {
      return mayBeEither(e) || !isNever(condition, wanted) ? true_ : false_;
    }
    if (e.op == Op::Not) {
      return canBe(e.operands[0], !wanted);
    }
    if (groupOf(e.op) == OpGroup::Logic) {
      return join(canBe(e.operands[0], wanted), canBe(e.operands[1], wanted),
                  (e.op == Op::And) == wanted);
    }
    if (e.op == Op::Known) {
      return true_;
    }
    return comparison(condition, wanted);
  }
  [[nodiscard]] bool isTrue(ExprId id) const { return id == true_; }

 private:
  ExprId join(ExprId a, ExprId b, bool both) {
    if (isTrue(a) || isTrue(b)) {
      return !both ? true_ : isTrue(a) ? b : a;
    }
    return both ? write_.both(a, b) : write_.either(a, b);
  }

  /// Whether a sensor works depends on the vehicle, for any quantity that it measures.
  [[nodiscard]] bool readsSeaOnly(ExprId condition) const {
    bool reads = false, decided = false;
    forEachIn(m_, condition, [&](const Expr& e) {
      const Decider decider = deciderOf(m_, proof_context_.platform, e);
      reads = reads || decider == Decider::Sea || e.op == Op::Known;
      decided = decided || isDecided(decider);
    });
    return reads && !decided;
  }

  /// Whether it compares one reading with a limit within its range: that needs no solver.
  [[nodiscard]] bool mayBeEither(const Expr& e) const {
    if (groupOf(e.op) != OpGroup::Comparison) {
      return false;
    }
    const auto at = [&](size_t operand) -> const Expr& { return m_[e.operands[operand]]; };
    const size_t reading = at(0).op == Op::Sensor ? 0 : 1, limit = 1 - reading;
    if (at(reading).op != Op::Sensor || at(limit).op != Op::Constant) {
      return false;
    }
    const Interval& range = proof_context_.sensors[at(reading).sensor.index];
    return range.lowest < at(limit).number && at(limit).number < range.highest;
  }

  /// Whether no readings make the condition true, or false: proved, so not if there is no answer.
  bool isNever(ExprId condition, bool wanted) {
    const ExprId not_so = wanted ? write_.negation(condition) : condition;
    const ProofContext proof_context(m_, proof_context_.platform);
    const std::vector<StateBounds> anywhere(
        m_.states.size(), {0, kGreatestNumber, kGreatestNumber, kGreatestNumber, kGreatestNumber});
    return AnyMoment(proof_context, anywhere).neverFalse(not_so, effort_, budget_);
  }

  ExprId comparison(ExprId id, bool wanted) {
    std::vector<SensorId> sea;
    forEachIn(m_, id, [&](const Expr& e) {
      const bool of_sea = deciderOf(m_, proof_context_.platform, e) == Decider::Sea;
      if (of_sea && std::ranges::find(sea, e.sensor) == sea.end()) {
        sea.push_back(e.sensor);
      }
    });
    if (sea.size() > kMostReadings) {
      return true_;
    }
    return withReadings(id, wanted, sea, {});
  }

  struct Read {
    SensorId sensor;
    double value = 0;
  };

  /// Some of the readings of `sea`, added to `fixed`, make it so.
  // NOLINTNEXTLINE(misc-no-recursion): once for each sensor, at most kMostReadings
  ExprId withReadings(ExprId id, bool wanted, std::vector<SensorId> sea, std::vector<Read> fixed) {
    if (sea.empty()) {
      const ExprId atom = copy(id, fixed);
      return wanted ? atom : write_.negation(atom);
    }
    const SensorId sensor = sea.back();
    sea.pop_back();
    const Interval& all = proof_context_.sensors[sensor.index];
    ExprId any = false_;
    for (const double value : {all.lowest, (all.lowest + all.highest) / 2, all.highest}) {
      fixed.push_back({sensor, value});
      any = write_.either(any, withReadings(id, wanted, sea, fixed));
      fixed.pop_back();
    }
    return any;
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the condition nests
  ExprId copy(ExprId id, const std::vector<Read>& fixed) {
    if (fixed.empty()) {
      return id;
    }
    Expr e = m_[id];
    const auto read = std::ranges::find_if(
        fixed, [&](const Read& one) { return e.op == Op::Sensor && e.sensor == one.sensor; });
    if (read != fixed.end()) {
      e.op = Op::Constant;
      e.number = read->value;
    }
    for (uint32_t i = 0; i < operandCount(e); ++i) {
      e.operands[i] = copy(e.operands[i], fixed);
    }
    return write_.add(e);
  }

  const Mission& m_;
  MissionWriter write_;
  const ProofContext& proof_context_;
  unsigned effort_;
  Budget& budget_;
  ExprId true_, false_;
};

class DecidedCheck {
 public:
  explicit DecidedCheck(Proof& proof)
      : proof_(proof),
        proof_context_(proof.proof_context),
        m_(proof_context_.mission),
        deepest_(std::ranges::max(deepestByState(proof_context_))) {}

  void run() {
    for (uint32_t i = 0; i < m_.assumptions.size(); ++i) {
      const Assumption& a = m_.assumptions[i];
      const bool watched = a.kind == AssumptionKind::Range || a.kind == AssumptionKind::Always;
      if (watched && (a.watch.monitor.step.valid() ? slowsTheMission(a) : limitsTheMission(a))) {
        proof_.decided_assumptions.insert(i);
        if (!contradicts(a)) {
          report(a);
        }
      }
    }
  }

 private:
  /// Whether it is already reported that no readings satisfy it.
  [[nodiscard]] bool contradicts(const Assumption& a) const {
    return std::ranges::any_of(proof_.diagnostics.sorted(), [&](const support::Diagnostic& one) {
      return one.id == support::diagnostics::assumptionsContradict && one.range == a.range;
    });
  }

  /// Whether the condition is false for something that the mission may do, for all readings of the
  /// sea.
  [[nodiscard]] bool limitsTheMission(const Assumption& a) const {
    if (!reads(a.watch.condition)) {
      return false;
    }
    Mission mission = m_;
    narrow(mission);
    const ExprId can = Projection(mission, proof_context_, proof_.options.effort, proof_.checks)
                           .canBe(a.watch.condition, true);
    const ProofContext proof_context(mission, proof_context_.platform);
    const std::vector<StateBounds> bounds(
        mission.states.size(), {0, kGreatestNumber, kGreatestNumber, kGreatestNumber, deepest_});
    return AnyMoment(proof_context, bounds).mayBeFalse(can, proof_.options.effort, proof_.checks);
  }
  [[nodiscard]] bool reads(ExprId condition) const {
    return anyIn(m_, condition, [&](const Expr& e) {
      return isDecided(deciderOf(m_, proof_context_.platform, e));
    });
  }

  /// To what the commands can lead to: only a limit within says something about the mission.
  void narrow(Mission& mission) const {
    const auto& hull = proof_context_.platform.envelope;
    for (Sensor& sensor : mission.sensors) {
      const platforms::PlatformSensor* row = proof_context_.platform.find(sensor.vehicle_name);
      if (row == nullptr) {
        continue;
      }
      const auto within = [&](double lowest, double highest) {
        sensor.lowest = std::max(sensor.lowest, lowest / sensor.to_si);
        sensor.highest = std::min(sensor.highest, highest / sensor.to_si);
      };
      if (row->alias == "depthrate") {
        within(-hull.vertical_rate_m_s, hull.vertical_rate_m_s);
      } else if (row->alias == "pitch") {
        within(-hull.steepest_pitch_rad, hull.steepest_pitch_rad);
      } else if (isPressure(*row) && std::isfinite(deepest_)) {
        sensor.lowest = std::max(sensor.lowest, -0.1);
        sensor.highest = std::min(sensor.highest, barAt(deepest_));
      }
    }
  }
  static bool isPressure(const platforms::PlatformSensor& row) {
    return (row.alias == "pressure" || row.alias == "scipressure") && row.unit == "bar";
  }
  [[nodiscard]] double barAt(double depth) const {
    return (depth + proof_context_.platform.world.depth_error_m) / kMetresPerBar;
  }

  /// Of `S changes <= R`: whether the vehicle moves faster, by the environment model. What only
  /// `known S every T` says is about the vehicle's sensors.
  [[nodiscard]] bool slowsTheMission(const Assumption& a) const {
    const Expr* kept = nullptr;
    forEachStatement(m_, a.watch.monitor.step, [&](const Statement& statement) {
      if (statement.kind == StatementKind::Set && m_[statement.value].op == Op::Sensor) {
        kept = &m_[statement.value];
      }
    });
    if (kept == nullptr) {
      return false;
    }
    const Sensor& sensor = m_[kept->sensor];
    const platforms::PlatformSensor* row = proof_context_.platform.find(sensor.vehicle_name);
    if (row == nullptr || !isDecided(deciderOf(*row))) {
      return false;
    }
    const double fastest = proof_context_.platform.envelope.vertical_rate_m_s;
    const double limit = row->alias == "depth"   ? fastest
                         : isPressure(*row)      ? fastest / kMetresPerBar * sensor.to_si
                         : row->alias == "pitch" ? 0  // how fast it turns is the vehicle's
                                                 : kGreatestNumber;
    return a.limit < limit;
  }

  void report(const Assumption& a) const {
    std::vector<std::string> counted, commanded, launched;
    const auto note = [&](const Expr& e) {
      const Decider decider = deciderOf(m_, proof_context_.platform, e);
      auto& names = decider == Decider::Counted     ? counted
                    : decider == Decider::Commanded ? commanded
                                                    : launched;
      const std::string name = fmt::format("`{}`", nameOf(e));
      if (isDecided(decider) && std::ranges::find(names, name) == names.end()) {
        names.push_back(name);
      }
    };
    forEachIn(m_, a.watch.condition, note);
    if (a.watch.monitor.step.valid()) {
      commanded.clear();
      counted.clear();
      launched.clear();
      forEachStatement(m_, a.watch.monitor.step, [&](const Statement& statement) {
        if (statement.kind == StatementKind::Set && m_[statement.value].op == Op::Sensor) {
          note(m_[statement.value]);
        }
      });
    }
    std::vector<std::string> why;
    if (!counted.empty()) {
      why.push_back(fmt::format("how long the mission flies decides {}", fmt::join(counted, ", ")));
    }
    if (!commanded.empty()) {
      why.push_back(fmt::format("the mission's commands decide {}{}", fmt::join(commanded, ", "),
                                decidesDepth(commanded) ? upTo() : ""));
    }
    if (why.empty()) {
      why.push_back(fmt::format("the pilot chooses {} at the launch", fmt::join(launched, ", ")));
    }
    proof_.diagnostics.report(
        support::diagnostics::assumptionDecided, a.range, a.words,
        fmt::format("{}", fmt::join(why, ", and ")),
        counted.empty() && commanded.empty() ? "narrow the range of the parameter instead"
        : commanded.empty() ? "write `require exit within …` instead, so that it is proved; "
                              "assume only what the sea and the vehicle do"
                            : "write `require always …` instead, so that it is proved; "
                              "assume only what the sea and the vehicle do");
  }
  [[nodiscard]] static bool decidesDepth(const std::vector<std::string>& names) {
    return std::ranges::any_of(names, [](const std::string& name) {
      return name.find("depth") != std::string::npos || name.find("pressure") != std::string::npos;
    });
  }
  /// ", which lead down to 25 m".
  [[nodiscard]] std::string upTo() const {
    return std::isfinite(deepest_) ? fmt::format(", and may lead to a depth of {:.4g} m", deepest_)
                                   : "";
  }
  [[nodiscard]] std::string nameOf(const Expr& e) const {
    return e.op == Op::Sensor     ? m_[e.sensor].name
           : e.op == Op::Variable ? m_[e.variable].name
                                  : "missiontime";
  }

  Proof& proof_;
  const ProofContext& proof_context_;
  const Mission& m_;
  double deepest_;
};

}  // namespace

void passes::decidedAssumptions(Proof& proof) {
  if (!proof.proof_context.mission.assumptions.empty()) {
    DecidedCheck(proof).run();
  }
}

}  // namespace glider::ir::prove
