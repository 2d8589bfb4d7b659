// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/against/held_guards.h"

#include "ir/core/mission_writer.h"
#include "support/one_line.h"
#include "support/utc.h"

#include <algorithm>
#include <array>
#include <optional>

namespace glider::analysis {
namespace {

using ir::ListKind;
using report::LoggedCase;

const std::vector<ir::Case>& casesIn(const ir::Mission& mission, ListKind list, ir::StateId state) {
  return list == ListKind::Always    ? mission.always
         : list == ListKind::State   ? mission[state].cases
         : list == ListKind::Profile ? mission[state].profile.cases
                                     : mission[state].route.cases;
}

/// The mission with the same cases, of which those that would leave a state never fire. What proves
/// that variables stay in their ranges does not apply to it, so they have none.
ir::Mission withoutTransitions(ir::Mission mission) {
  const ir::ExprId never = ir::MissionWriter(mission).truth(false);
  const auto hold = [never](std::vector<ir::Case>& cases) {
    for (ir::Case& one : cases) {
      if (one.transition != ir::Transition::Stay && one.transition != ir::Transition::Done) {
        one.guard = never;
      }
    }
  };
  for (ir::Variable& variable : mission.variables) {
    variable.lowest = -ir::Variable::kEndless;
    variable.highest = ir::Variable::kEndless;
  }
  hold(mission.always);
  mission.always_table = {};
  for (ir::State& state : mission.states) {
    hold(state.cases);
    state.table = {};
  }
  return mission;
}

/// The values that the parameters of states have while the guards of the state are evaluated.
class Arguments {
 public:
  Arguments(const ir::Mission& held, uint32_t stack_depth, std::span<const double> parameters)
      : m_(held), stack_depth_(stack_depth), parameters_(parameters), of_(m_.states.size()) {
    of_[0].emplace();
    std::vector<uint32_t> reached = {0};
    for (size_t i = 0; i < reached.size(); ++i) {
      follow({reached[i]}, m_.always, reached);
      follow({reached[i]}, m_[ir::StateId{reached[i]}].cases, reached);
    }
  }

  [[nodiscard]] std::vector<double> of(ir::StateId state) const {
    const auto& found = of_.at(state.index);
    return found ? *found
                 : std::vector<double>(m_[state].parameters.size(),
                                       std::numeric_limits<double>::quiet_NaN());
  }

 private:
  void follow(ir::StateId from, const std::vector<ir::Case>& cases,
              std::vector<uint32_t>& reached) {
    for (const ir::Case& one : cases) {
      if (!one.target.valid() || of_[one.target.index]) {
        continue;
      }
      of_[one.target.index] = argumentsOf(from, one);
      reached.push_back(one.target.index);
    }
  }

  [[nodiscard]] std::vector<double> argumentsOf(ir::StateId from,
                                                const ir::Case& transition) const {
    std::vector<double> values;
    if (transition.arguments.empty()) {
      return values;
    }
    ir::Interpreter interpreter(m_, stack_depth_);
    interpreter.startIn(from, of(from), {}, parameters_);
    for (const ir::ExprId argument : transition.arguments) {
      values.push_back(ir::asNumber(interpreter.evaluate(argument)));
    }
    return values;
  }

  const ir::Mission& m_;
  uint32_t stack_depth_;
  std::span<const double> parameters_;
  std::vector<std::optional<std::vector<double>>> of_;
};

/// The guards of one state along the log.
class HeldState {
 public:
  HeldState(const ir::Mission& held, const LogTicks& log) : m_(held), log_(log) {}

  /// `guard`: that of the mission, which the held one may not have.
  void watch(const WatchedCase& watched, ir::ExprId guard, LoggedCase& out) {
    cases_.push_back({&watched, &out, guard, {}, {}});
  }

  void run(ir::Interpreter interpreter, ir::StateId state, const std::vector<double>& arguments,
           std::span<const double> parameters) {
    if (log_.ticks.empty() || cases_.empty()) {
      return;
    }
    interpreter.startIn(state, arguments, log_.ticks[0].frame, parameters);
    for (uint32_t tick = 1; tick < log_.ticks.size(); ++tick) {
      interpreter.advance(log_.ticks[tick].time_s, log_.ticks[tick].frame);
      for (HeldCase& held : cases_) {
        look(held, interpreter);
      }
      const ir::TickResult result = interpreter.decide();
      for (HeldCase& held : cases_) {
        settle(held, result, tick);
      }
    }
  }

 private:
  struct HeldCase {
    const WatchedCase* of;
    LoggedCase* out;
    ir::ExprId guard;
    FiringOnce once;
    std::vector<report::LoggedValue> values;  ///< in this tick, if it may fire
  };

  /// Before any case of the tick has fired.
  void look(HeldCase& held, const ir::Interpreter& interpreter) const {
    const ir::Truth truth = interpreter.truthOf(held.guard);
    held.out->known_ticks += truth == ir::Truth::Unknown ? 0U : 1U;
    held.out->true_ticks += truth == ir::Truth::True ? 1U : 0U;
    held.once.look(truth == ir::Truth::True);
    if (held.once.due()) {
      held.values = valuesOf(held.of->reads, interpreter);
    }
  }

  /// After the tick. The cases that would leave the state have not fired, but would have.
  void settle(HeldCase& held, const ir::TickResult& result, uint32_t tick) const {
    const auto first = result.firedIn(held.of->list);
    const bool passed_over = first && *first < held.of->number;
    if (held.once.due() && !passed_over) {
      held.once.fire();
      held.out->firings.push_back({momentOf(log_, tick), std::move(held.values)});
    }
  }

  const ir::Mission& m_;
  const LogTicks& log_;
  std::vector<HeldCase> cases_;
};

std::string transitionText(const ir::Mission& mission, const ir::Case& of) {
  const std::string word(ir::wordOf(of.transition));
  return of.target.valid() ? word + " " + mission[of.target].name : word;
}

LoggedCase describe(const compiler::Checked& checked, const WatchedCase& watched) {
  const ir::Mission& mission = checked.mission();
  const ir::Case& of = caseOf(mission, watched);
  LoggedCase out;
  out.list = std::string(ir::wordOf(watched.list));
  out.state = watched.state.valid() ? mission[watched.state].name : "";
  out.range = of.range;
  const support::SourceRange guard = mission[of.guard].range;
  out.guard = guard.valid() ? support::onOneLine(checked.sources().text(guard)) : "";
  out.transition = transitionText(mission, of);
  return out;
}

}  // namespace

const ir::Case& caseOf(const ir::Mission& mission, const WatchedCase& watched) {
  return casesIn(mission, watched.list, watched.state).at(watched.number);
}

std::vector<WatchedCase> watchedCases(const compiler::Checked& checked) {
  const ir::Mission& mission = checked.mission();
  std::vector<WatchedCase> all;
  const auto add = [&](ListKind list, ir::StateId state) {
    const std::vector<ir::Case>& cases = casesIn(mission, list, state);
    for (uint32_t i = 0; i < cases.size(); ++i) {
      if (!checked.lowered->inStandardLibrary(cases[i].range.file)) {
        all.push_back({list, state, i, readsOf(mission, checked.sources(), cases[i].guard)});
      }
    }
  };
  add(ListKind::Always, {});
  for (uint32_t i = 0; i < mission.states.size(); ++i) {
    for (const ListKind list : {ListKind::State, ListKind::Profile, ListKind::Route}) {
      add(list, {i});
    }
  }
  return all;
}

report::LoggedMoment momentOf(const LogTicks& log, uint32_t tick) {
  const LogTick& at = log.ticks.at(tick);
  return {at.utc_s, support::utcText(at.utc_s), at.time_s / 3600, at.depth_m, tick};
}

std::vector<LoggedCase> evaluateGuards(const compiler::Checked& checked, const LogTicks& log,
                                       std::span<const double> parameters) {
  const ir::Mission held = withoutTransitions(checked.mission());
  const Arguments arguments(held, checked.facts.stack_depth, parameters);
  const std::vector<WatchedCase> watched = watchedCases(checked);
  std::vector<LoggedCase> out;
  for (const WatchedCase& one : watched) {
    out.push_back(describe(checked, one));
  }
  for (uint32_t state = 0; state < held.states.size(); ++state) {
    HeldState run(held, log);
    for (size_t i = 0; i < watched.size(); ++i) {
      // Those of `always` do not depend on the state.
      if (watched[i].state.valid() ? watched[i].state.index == state : state == 0) {
        run.watch(watched[i], caseOf(checked.mission(), watched[i]).guard, out[i]);
      }
    }
    run.run(ir::Interpreter(held, checked.facts.stack_depth), {state}, arguments.of({state}),
            parameters);
  }
  for (LoggedCase& one : out) {
    one.flickers = flickersOf(one.firings);
  }
  return out;
}

std::vector<report::Flicker> flickersOf(const std::vector<report::LoggedFiring>& firings) {
  std::vector<report::Flicker> all;
  const auto seconds = [&](size_t from, size_t to) {
    return firings[to].at.time_s - firings[from].at.time_s;
  };
  constexpr size_t kMore = report::kFlickerFirings - 1;
  for (size_t i = 0; i + kMore < firings.size(); ++i) {
    if (seconds(i, i + kMore) > report::kFlickerSeconds) {
      continue;
    }
    size_t last = i + kMore;
    while (last + 1 < firings.size() &&
           seconds(last + 1 - kMore, last + 1) <= report::kFlickerSeconds) {
      ++last;
    }
    all.push_back(
        {static_cast<uint32_t>(i), static_cast<uint32_t>(last + 1 - i), seconds(i, last)});
    i = last;
  }
  return all;
}

}  // namespace glider::analysis
