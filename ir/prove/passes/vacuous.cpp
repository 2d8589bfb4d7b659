// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `vacuous`: requirements that are proved only because what they depend on is never true
// (GL3122): `whenever A then B` without any A. In: the verdicts, so it comes last; out: warnings.
// The conditions of a requirement and of its monitor are asked of any moment (AnyMoment), then the
// truth values of the monitor follow by a fixpoint. Certain; some are missed, because a moment is
// not a trace. Also those that no mission at all could violate: `always` of what the sensors'
// ranges alone ensure, and a state that answers because it waits on the stack (StandingAnswers).

#include "ir/core/mission_writer.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/context/sensors_read.h"
#include "ir/prove/encoding/any_moment.h"
#include "ir/prove/passes.h"
#include "ir/prove/requirements/standing_answer.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// What can be true at some moment of a flight; other expressions are certainly never true.
class PossibleTruths {
 public:
  /// Adds the negations that are asked about to `mission`.
  explicit PossibleTruths(Mission& mission) : m_(mission) {}

  /// To be called for every condition before ask().
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  void prepare(ExprId id) {
    const Expr e = m_[id];
    if (e.op == Op::And || e.op == Op::Or) {
      prepare(e.operands[0]);
      prepare(e.operands[1]);
    } else if (isAsked(e) && !negations_.contains(id.index)) {
      negations_.emplace(id.index, MissionWriter(m_).negation(id));
    }
  }

  void ask(const Proof& proof, const EndBound& end, Budget& budget) {
    const ProofContext plain(m_, proof.proof_context.platform);
    const ProofContext context = end.by ? plain.endingBy(std::ranges::max(end.left_by)) : plain;
    const std::vector<StateBounds> bounds = stateBounds(context, end);
    AnyMoment moment(context, bounds);
    for (const auto& [condition, negation] : negations_) {
      if (moment.neverFalse(negation, proof.options.effort, budget)) {
        never_.insert(condition);
      }
    }
  }

  /// With `flags`, the truth values of monitors that can be true. `why` becomes what is never true.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  bool mayBeTrue(ExprId id, const std::set<uint32_t>& flags, std::optional<ExprId>& why) const {
    const Expr& e = m_[id];
    const auto part = [&](size_t i) { return mayBeTrue(e.operands[i], flags, why); };
    if (e.op == Op::And) {
      return part(0) && part(1);
    }
    if (e.op == Op::Or) {
      return part(0) || part(1);
    }
    if (e.op == Op::Variable && isOfMonitor(m_[e.variable].kind)) {
      return flags.contains(e.variable.index);
    }
    if (e.op == Op::False) {
      return false;
    }
    if (never_.contains(id.index)) {
      why = why.value_or(id);
      return false;
    }
    return true;
  }

 private:
  [[nodiscard]] bool isAsked(const Expr& e) const {
    return e.op != Op::True && e.op != Op::False && e.op != Op::Not &&
           !(e.op == Op::Variable && isOfMonitor(m_[e.variable].kind));
  }

  Mission& m_;
  std::map<uint32_t, ExprId> negations_;  ///< by condition
  std::set<uint32_t> never_;              ///< conditions
};

/// A statement that may make a truth value of a monitor true.
struct Setting {
  VariableId variable;
  std::vector<ExprId> conditions;  ///< all true, and the value
};

class Vacuity {
 public:
  Vacuity(const Mission& mission, const Requirement& requirement)
      : m_(mission), requirement_(requirement) {
    gather(requirement.monitor.step, {});
  }

  void prepare(PossibleTruths& possible) const {
    for (const Setting& setting : settings_) {
      std::ranges::for_each(setting.conditions, [&](ExprId id) { possible.prepare(id); });
    }
  }

  /// What is never true although the requirement depends on it; none if it may be put to the test.
  [[nodiscard]] std::optional<ExprId> why(const PossibleTruths& possible) const {
    std::optional<ExprId> never;
    const std::set<uint32_t> flags = possibleFlags(possible, never);
    const auto dead = [&](const Expr& e) {
      return e.op == Op::Variable && isOfMonitor(m_[e.variable].kind) &&
             e.type.kind == TypeKind::Bool && !flags.contains(e.variable.index);
    };
    const auto tested = [&](const Setting& setting) {
      return isViolation(setting.variable) &&
             std::ranges::none_of(setting.conditions, [&](ExprId id) { return needs(id, dead); });
    };
    return std::ranges::any_of(settings_, tested) ? std::nullopt : never;
  }

 private:
  [[nodiscard]] bool isViolation(VariableId variable) const {
    return std::ranges::any_of(requirement_.monitor.violations, [&](const Violation& violation) {
      return m_[violation.condition].variable == variable;
    });
  }

  /// Whether a condition is only true if some `is` is.
  template <typename Is>
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] bool needs(ExprId id, const Is& is) const {
    const Expr& e = m_[id];
    return e.op == Op::And  ? needs(e.operands[0], is) || needs(e.operands[1], is)
           : e.op == Op::Or ? needs(e.operands[0], is) && needs(e.operands[1], is)
                            : is(e);
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the monitor's statements nest
  void gather(BlockId block, const std::vector<ExprId>& conditions) {
    if (!block.valid()) {
      return;
    }
    for (const Statement& s : m_[block].statements) {
      if (s.kind == StatementKind::Set && m_[s.variable].type.kind == TypeKind::Bool) {
        settings_.push_back({s.variable, conditions});
        settings_.back().conditions.push_back(s.value);
      } else if (s.kind == StatementKind::If) {
        auto inner = conditions;
        inner.push_back(s.value);
        gather(s.then, inner);
        gather(s.otherwise, conditions);
      }
    }
  }

  /// The truth values that can be true: from those that are at first or are observed, until no
  /// setting adds one.
  std::set<uint32_t> possibleFlags(const PossibleTruths& possible,
                                   std::optional<ExprId>& never) const {
    std::set<uint32_t> flags;
    for (const Observation& observation : requirement_.monitor.observations) {
      flags.insert(observation.variable.index);
    }
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const ExprId initial = m_.variables[i].initial;
      if (initial.valid() && m_[initial].op == Op::True) {
        flags.insert(i);
      }
    }
    for (bool grown = true; grown;) {
      grown = false;
      never.reset();
      for (const Setting& setting : settings_) {
        const auto may = [&](ExprId id) { return possible.mayBeTrue(id, flags, never); };
        if (std::ranges::all_of(setting.conditions, may)) {
          grown |= flags.insert(setting.variable.index).second;
        }
      }
    }
    return flags;
  }

  const Mission& m_;
  const Requirement& requirement_;
  std::vector<Setting> settings_;
};

/// The first place of `whenever A then B`, if one condition expresses it: `never (A and not B)`,
/// which is not in the mission's text.
std::optional<ExprId> causeOf(const Mission& m, const Requirement& requirement) {
  const Expr& e = m[requirement.condition];
  if (e.op != Op::Not || m[e.operands[0]].op != Op::And || e.range != requirement.range ||
      m[e.operands[0]].range != requirement.range) {
    return std::nullopt;
  }
  return m[e.operands[0]].operands[0];
}

/// Whether the condition is about readings and constants alone: what a mission sets or how long it
/// takes is for it to ensure.
bool isAboutReadings(const Mission& m, const Requirement& requirement) {
  return !requirement.monitor.step.valid() && requirement.geofences.empty() &&
         !anyIn(m, requirement.condition, [](const Expr& e) {
           const OpGroup group = groupOf(e.op);
           return group == OpGroup::Variable || group == OpGroup::Clock || group == OpGroup::Age ||
                  group == OpGroup::Known;
         });
}

/// Reports promises that no mission at all could break.
class Unbreakable {
 public:
  explicit Unbreakable(Proof& proof)
      : proof_(proof), m_(proof.proof_context.mission), standing_(m_) {}

  /// True, and reported, if a state on the stack keeps it.
  bool byTheStack(const Requirement& requirement) {
    const auto standing = standing_.of(requirement);
    if (!standing) {
      return false;
    }
    const std::string& response = m_[standing->response].name;
    const std::string& cause = m_[standing->cause].name;
    proof_.diagnostics
        .report(support::diagnostics::requirementVacuous, requirement.range,
                fmt::format("`{}` is always on the stack when `{}` is", response, cause))
        .note(requirement.range,
              fmt::format("a state that waits on the stack counts, so this says nothing of when "
                          "`{}` returns to `{}`",
                          cause, response));
    return true;
  }

  /// Reports a condition that holds for every value that its sensors can have, for any commands.
  void byRanges(const Requirement& requirement) {
    if (!isAboutReadings(m_, requirement) ||
        !anyReadings().neverFalse(requirement.condition, proof_.options.effort, proof_.checks)) {
      return;
    }
    bool depth = false;
    forEachSensorRead(m_, requirement.condition,
                      [&](SensorId id) { depth |= plain_->depth && id == *plain_->depth; });
    auto warning =
        proof_.diagnostics.report(support::diagnostics::requirementVacuous, requirement.range,
                                  "no value within the range of what it reads can violate it");
    if (depth) {
      warning.note(m_[requirement.condition].range,
                   "depths are counted down from the surface, which is at 0 m: none is negative");
    }
  }

 private:
  /// A moment with any readings and clocks.
  AnyMoment& anyReadings() {
    if (!moment_) {
      plain_.emplace(m_, proof_.proof_context.platform);
      moment_.emplace(*plain_, unbounded_);
    }
    return *moment_;
  }

  Proof& proof_;
  const Mission& m_;
  StandingAnswers standing_;
  std::vector<StateBounds> unbounded_ = {{0, kGreatestNumber, kGreatestNumber, kGreatestNumber,
                                          std::numeric_limits<double>::infinity()}};
  std::optional<ProofContext>
      plain_;  ///< made when it is asked for: it looks at all of the mission
  std::optional<AnyMoment> moment_;
};

}  // namespace

void passes::vacuous(Proof& proof) {
  const Mission& written = proof.proof_context.mission;
  if (proof.findings.requirements.empty()) {
    return;
  }
  Mission mission = written;
  PossibleTruths possible(mission);
  Unbreakable unbreakable(proof);
  std::vector<std::pair<const Requirement*, Vacuity>> asked;
  for (const RequirementVerdict& verdict : proof.findings.requirements) {
    const Requirement& requirement = written.requirements[verdict.requirement];
    if (verdict.verdict != Verdict::Proved || requirement.kind != RequirementKind::Always) {
      continue;
    }
    if (unbreakable.byTheStack(requirement)) {
      continue;
    }
    unbreakable.byRanges(requirement);
    asked.emplace_back(&requirement, Vacuity(written, requirement));
    asked.back().second.prepare(possible);
    if (const auto cause = causeOf(written, requirement)) {
      possible.prepare(*cause);
    }
  }
  if (asked.empty()) {
    return;
  }
  possible.ask(proof, proof.ending.bound(), proof.checks);
  for (const auto& [requirement, vacuity] : asked) {
    std::optional<ExprId> never = vacuity.why(possible);
    const auto cause = causeOf(written, *requirement);
    if (cause && !possible.mayBeTrue(*cause, {}, never)) {
      never = never.value_or(*cause);
    } else if (cause) {
      never.reset();
    }
    if (never) {
      proof.diagnostics
          .report(support::diagnostics::requirementVacuous, requirement->range,
                  "what it depends on is never true")
          .note(written[*never].range, "no moment of any flight makes this true");
    }
  }
}

}  // namespace glider::ir::prove
