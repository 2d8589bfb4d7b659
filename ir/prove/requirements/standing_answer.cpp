// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Which promises hold only because a state that waits on the stack counts. In: a requirement, as
// its monitor; out: the two states. The monitor keeps a flag of what is owed. If it becomes true
// only on ticks on which A is on the stack, and is set to false later on the same tick where B is,
// and B is wherever A is, it is false after every tick.

#include "ir/prove/requirements/standing_answer.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// A statement that sets a truth value of the monitor.
struct Setting {
  VariableId variable;
  bool to_true = false;
  std::vector<ExprId> conditions;  ///< all true where it is run, and the value
};

using Flags = std::set<uint32_t>;

class OwedFlag {
 public:
  OwedFlag(const Mission& mission, const Requirement& requirement, StandingAnswers& answers)
      : m_(mission), monitor_(requirement.monitor), answers_(answers) {
    gather(monitor_.step, {});
  }

  /// The states of a flag that all violations need.
  [[nodiscard]] std::optional<StandingAnswer> find() const {
    for (size_t i = 0; i < settings_.size(); ++i) {
      const Setting& met = settings_[i];
      if (met.to_true || !isFalseAtFirst(m_[met.variable]) || !isNeeded(met.variable)) {
        continue;
      }
      if (const auto found = answerTo(met, i)) {
        return found;
      }
    }
    return std::nullopt;
  }

 private:
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the monitor's statements nest
  void gather(BlockId block, const std::vector<ExprId>& conditions) {
    if (!block.valid()) {
      return;
    }
    for (const Statement& s : m_[block].statements) {
      if (s.kind == StatementKind::Set && m_[s.variable].type.kind == TypeKind::Bool) {
        Setting setting{s.variable, m_[s.value].op != Op::False, conditions};
        if (setting.to_true) {
          setting.conditions.push_back(s.value);
        }
        settings_.push_back(std::move(setting));
      } else if (s.kind == StatementKind::If) {
        auto inner = conditions;
        inner.push_back(s.value);
        gather(s.then, inner);
      }
    }
  }

  /// What is read in a conjunction.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the monitor's conditions nest
  void addFlags(ExprId id, Flags& flags, bool& only) const {
    const Expr& e = m_[id];
    if (e.op == Op::And) {
      addFlags(e.operands[0], flags, only);
      addFlags(e.operands[1], flags, only);
    } else if (e.op == Op::Variable) {
      flags.insert(e.variable.index);
    } else if (e.op != Op::True) {
      only = false;
    }
  }

  /// The flags that are true where all `conditions` are, also by what has set those of this tick.
  // NOLINTNEXTLINE(misc-no-recursion): a flag of a tick is set from flags that come before it
  [[nodiscard]] Flags needed(const std::vector<ExprId>& conditions, size_t depth = 0) const {
    constexpr size_t kDeepest = 8;
    Flags flags;
    bool only = true;
    for (const ExprId condition : conditions) {
      addFlags(condition, flags, only);
    }
    for (const uint32_t flag : Flags(flags)) {
      if (m_.variables[flag].kind == VariableKind::Momentary && depth < kDeepest) {
        flags.merge(behind({flag}, depth + 1));
      }
    }
    return flags;
  }

  /// The flags that are true wherever this one, of this tick, has been set to true.
  // NOLINTNEXTLINE(misc-no-recursion): see needed
  [[nodiscard]] Flags behind(VariableId flag, size_t depth) const {
    std::optional<Flags> all;
    for (const Setting& setting : settings_) {
      if (setting.variable != flag || !setting.to_true) {
        continue;
      }
      const Flags here = needed(setting.conditions, depth);
      if (all) {
        std::erase_if(*all, [&](uint32_t one) { return !here.contains(one); });
      } else {
        all = here;
      }
    }
    return all.value_or(Flags());
  }

  [[nodiscard]] bool isFalseAtFirst(const Variable& flag) const {
    return flag.kind == VariableKind::Monitor && m_[flag.initial].op == Op::False;
  }

  /// Whether nothing is violated unless the flag is true.
  [[nodiscard]] bool isNeeded(VariableId flag) const {
    const auto& ways = monitor_.violations;
    return !ways.empty() && std::ranges::all_of(ways, [&](const Violation& way) {
      return needed({way.condition}).contains(flag.index);
    });
  }

  [[nodiscard]] StateId insideOf(uint32_t flag) const {
    const auto found = std::ranges::find_if(monitor_.observations, [&](const Observation& seen) {
      return seen.variable.index == flag && seen.kind == ObservationKind::Inside;
    });
    return found == monitor_.observations.end() ? StateId() : found->state;
  }

  /// `met`, setting `number`, sets a flag to false: the states if it always undoes what has set it.
  [[nodiscard]] std::optional<StandingAnswer> answerTo(const Setting& met, size_t number) const {
    Flags asked;
    bool only = true;
    for (const ExprId condition : met.conditions) {
      addFlags(condition, asked, only);
    }
    const auto owes = [&](const Setting& setting) {
      return setting.variable == met.variable && setting.to_true;
    };
    const auto owing = std::ranges::find_if(settings_, owes);
    if (!only || std::ranges::count_if(settings_, owes) != 1 ||
        static_cast<size_t>(owing - settings_.begin()) > number) {
      return std::nullopt;
    }
    const Flags true_then = needed(owing->conditions);
    for (const uint32_t cause : true_then) {
      for (const uint32_t response : asked) {
        Flags others = asked;
        others.erase(response);
        if (std::ranges::includes(true_then, others) && insideOf(cause).valid() &&
            insideOf(response).valid() &&
            answers_.isOnStackWith(insideOf(cause), insideOf(response))) {
          return StandingAnswer{insideOf(cause), insideOf(response)};
        }
      }
    }
    return std::nullopt;
  }

  const Mission& m_;
  const Monitor& monitor_;
  StandingAnswers& answers_;
  std::vector<Setting> settings_;
};

}  // namespace

std::optional<StandingAnswer> StandingAnswers::of(const Requirement& requirement) {
  return requirement.monitor.step.valid() ? OwedFlag(m_, requirement, *this).find() : std::nullopt;
}

bool StandingAnswers::isOnStackWith(StateId cause, StateId response) {
  if (!std::exchange(searched_, true)) {
    configurations_ = configurations(m_);
  }
  return cause != response && configurations_ &&
         std::ranges::all_of(*configurations_, [&](const Reached& reached) {
           return !reached.control.holds(cause) || reached.control.holds(response);
         });
}

}  // namespace glider::ir::prove
