// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the prover says about the values of expressions, against those of random flights.

#include "ir/core/scopes.h"
#include "ir/eval/arithmetic.h"
#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/abstract/abstract_run.h"
#include "ir/prove/abstract/held_ranges.h"
#include "tests/containment/rule.h"
#include "tests/random_missions/random_arrays.h"
#include "tests/unit/frontend/compile.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <type_traits>

namespace glider::containment {
namespace {

using namespace ir;
using namespace ir::prove;

/// Calls `check` with each expression that has a meaning now, and its value: those that read no
/// state, or the current one.
class Values : public Rule {
 public:
  explicit Values(const ProofContext& context)
      : context_(context), m_(context.mission), reads_(readsOf(m_)) {
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      if (m_.variables[i].initial.valid()) {
        initial_.insert(m_.variables[i].initial.index);
      }
    }
  }

  /// Temporals that were advanced are seen before a state is left.
  void begun(const Flight& flight) override { checkAll(flight, flight.before().result.state); }
  void tick(const Flight& flight) override {
    if (!flight.over()) {
      checkAll(flight, flight.now().result.state);
    }
  }

 protected:
  virtual void check(const Flight& flight, ExprId id, Value value) = 0;

  void checkAll(const Flight& flight, StateId current) {
    for (uint32_t i = 0; i < m_.exprs.size(); ++i) {
      const Reads& reads = reads_[i];
      if (!reads.two_states && (!reads.state.valid() || reads.state == current)) {
        check(flight, {i}, flight.interpreter().evaluate({i}));
      }
    }
    ++steps;
  }

  const ProofContext& context_;
  const Mission& m_;
  std::vector<Reads> reads_;
  std::set<uint32_t> initial_;
};

std::string wordsOf(const Flight& flight, ExprId id, Value value) {
  return fmt::format("expression {} ({}) is {}: {}", id.index, opInfo(flight.mission()[id].op).text,
                     asNumber(value), flight.words());
}

void expectIn(const Interval& range, const Flight& flight, ExprId id, Value value) {
  if (const double* number = std::get_if<double>(&value); number != nullptr && isKnown(*number)) {
    EXPECT_TRUE(!range.empty && range.lowest <= *number && *number <= range.highest)
        << wordsOf(flight, id, value) << " not in " << range.lowest << " to " << range.highest;
  }
}

class Intervals : public Values {
 public:
  using Values::Values;
  void check(const Flight& flight, ExprId id, Value value) override {
    expectIn(context_.intervals[id.index], flight, id, value);
    expectIn(held_[id.index], flight, id, value);
    const Expr& e = m_[id];
    if (e.op == Op::Sensor) {
      expectIn(context_.sensors[e.sensor.index], flight, id, value);
    } else if (e.op == Op::Temporal && isWindow(m_[e.temporal].kind)) {
      expectIn(context_.windows[e.temporal.index], flight, id, value);
    }
  }

 private:
  std::vector<Interval> held_ = heldIntervals(m_);
};

TEST(Containment, Intervals) {
  holds<Intervals>();
}

class NeverUnknown : public Values {
 public:
  using Values::Values;
  void check(const Flight& flight, ExprId id, Value value) override {
    if (context_.known.expressions[id.index]) {
      EXPECT_TRUE(isKnown(asNumber(value))) << wordsOf(flight, id, value);
    }
  }
};

TEST(Containment, NeverUnknown) {
  holds<NeverUnknown>();
}

class WholeNumbers : public Values {
 public:
  using Values::Values;
  void check(const Flight& flight, ExprId id, Value value) override {
    if (const double number = asNumber(value); context_.whole[id.index] && isKnown(number)) {
      EXPECT_EQ(number, std::floor(number)) << wordsOf(flight, id, value);
    }
  }
};

TEST(Containment, WholeNumbers) {
  holds<WholeNumbers>();
}

class MissionTimes : public Values {
 public:
  using Values::Values;
  void start(const Flight& flight) override {
    times_ = {0};
    Values::start(flight);
  }
  void begun(const Flight& flight) override {
    times_.insert(flight.now().time);
    Values::begun(flight);
  }
  void check(const Flight& flight, ExprId id, Value value) override {
    if (const double number = asNumber(value);
        context_.mission_times[id.index] && isKnown(number)) {
      EXPECT_TRUE(times_.contains(number)) << wordsOf(flight, id, value);
    }
  }

 private:
  std::set<double> times_;
};

TEST(Containment, MissionTimes) {
  holds<MissionTimes>();
}

/// The values of variables, one each.
Valuation exactly(const Mission& m, const TickResult& result) {
  Valuation values;
  for (uint32_t i = 0; i < m.variables.size(); ++i) {
    const Variable& v = m.variables[i];
    const double value = result.variables[i];
    PossibleValues held;
    held.never = !isKnown(value);
    if (v.type.kind == TypeKind::Bool) {
      held = {0, 0, false, {value == 1, value == 0, !isKnown(value)}};
    } else if (isKnown(value)) {
      held = {value, value, false, {}};
    }
    values.push_back(held);
  }
  return values;
}

/// The abstract evaluation of every expression, with the variables' very values and ranges of
/// clocks that end where the clocks are.
class Evaluation : public Values {
 public:
  using Values::Values;
  void tick(const Flight& flight) override {
    values_ = exactly(m_, flight.now().result);
    const auto upTo = [&](double time) {
      return Interval{flight.now().time > 60 ? time : 0, time, false};
    };
    const Tick& now = flight.now();
    evaluator_.emplace(
        context_, values_,
        ClockRanges{upTo(now.time), upTo(now.time - now.entered), upTo(now.time - now.resumed)});
    Values::tick(flight);
  }
  void begun(const Flight&) override {}
  void check(const Flight& flight, ExprId id, Value value) override {
    if (const Truth* truth = std::get_if<Truth>(&value)) {
      const Truths& may = evaluator_->truth(id);
      EXPECT_TRUE(*truth == Truth::True    ? may.is_true
                  : *truth == Truth::False ? may.is_false
                                           : may.is_unknown)
          << wordsOf(flight, id, value);
      return;
    }
    expectIn(evaluator_->number(id), flight, id, value);
    EXPECT_TRUE(isKnown(std::get<double>(value)) || evaluator_->maybeUnknown(id))
        << wordsOf(flight, id, value);
  }

 private:
  Valuation values_;
  std::optional<AbstractEvaluator> evaluator_;
};

TEST(Containment, AbstractEvaluation) {
  holds<Evaluation>();
}

/// Missions of the language with arrays and loops, whose tables and choices random missions of the
/// IR have rarely. The index `w` always has an element, `half` never.
std::vector<Mission> missionsWithArrays() {
  constexpr size_t kMissions = 12;
  constexpr size_t kLargest = 1200;  // expressions: each is evaluated on every tick
  std::vector<Mission> missions;
  for (uint64_t seed = 0; missions.size() < kMissions; ++seed) {
    const auto program = random_missions::randomArrays(seed);
    frontend::testing_support::FrontendRun run(
        "mission m\n" + program.declarations +
        "var w: number = 0 in 0 .. 1\nvar half: number = 0.5 in 0 .. 1\nstate s begin "
        "flightprofile surfaced sensors missiontime, "
        "chlorophyll events case known(chlorophyll) || missiontime >= 0 s do\n" +
        program.statements +
        "set w = 1 - w log \"w\", c[w], a[w], c[half] end stay case missiontime > 1 h exit end\n");
    auto mission = run.compile();
    if (mission && mission->exprs.size() < kLargest) {
      missions.push_back(std::move(*mission));
    }
  }
  return missions;
}

TEST(Containment, ValuesOfArrays) {
  const std::vector<Mission> missions = missionsWithArrays();
  const Plan plan{.flights = 1, .ticks = 30};
  const auto rule = [&]<typename R>(std::type_identity<R>) {
    holdsOn(
        missions, [](const ProofContext& context) { return std::make_unique<R>(context); }, plan);
  };
  rule(std::type_identity<Intervals>());
  rule(std::type_identity<NeverUnknown>());
  rule(std::type_identity<WholeNumbers>());
  rule(std::type_identity<Evaluation>());
  for (const Mission& mission : missions) {
    const ProofContext context(mission, slocum());
    EXPECT_TRUE(std::ranges::any_of(mission.exprs, [&](const Expr& e) {
      const auto number = static_cast<size_t>(&e - mission.exprs.data());
      return e.op == Op::Element && context.known.expressions[number];
    }));
  }
}

/// A transition by a state's own case, from the very values of the variables.
class Transitions : public Rule {
 public:
  explicit Transitions(const ProofContext& context) : m_(context.mission), run_(context) {}
  void start(const Flight&) override {}
  void tick(const Flight& flight) override {
    const TickResult& before = flight.before().result;
    const TickResult& now = flight.now().result;
    if (!flight.arrived() || now.moved->list != ListKind::State || now.firedIn(ListKind::Always)) {
      return;
    }
    ++steps;
    const Case& c = m_[before.state].cases[now.moved->number];
    const double time = flight.now().time;
    const auto upTo = [](double most) { return Interval{0, most, false}; };
    const ClockRanges clocks{upTo(time), upTo(time), upTo(time)};
    Valuation values = exactly(m_, before);
    run_.execute(c.action, clocks, values);
    c.transition == Transition::Return ? run_.resume(now.state, clocks, values)
                                       : run_.enter(now.state, &c, clocks, values);
    const Control control = controlOf(now);
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const Variable& v = m_.variables[i];
      if (!v.owner.valid() || control.holds(v.owner)) {
        EXPECT_TRUE(lies(v, now.variables[i], values[i])) << v.name << " " << now.variables[i];
      }
    }
  }

 private:
  static bool lies(const Variable& v, double value, const PossibleValues& held) {
    if (v.type.kind == TypeKind::Bool) {
      return value == 1   ? held.truths.is_true
             : value == 0 ? held.truths.is_false
                          : held.truths.is_unknown;
    }
    return !isKnown(value) || (!held.never && held.lowest <= value && value <= held.highest);
  }

  const Mission& m_;
  AbstractRun run_;
};

TEST(Containment, AbstractRun) {
  holds<Transitions>();
}

/// What variables are ever set to.
class HeldRanges : public Rule {
 public:
  explicit HeldRanges(const ProofContext& context) : held_(heldVariables(context.mission)) {}
  void tick(const Flight& flight) override {
    for (size_t i = 0; i < held_.size(); ++i) {
      const double value = flight.now().result.variables[i];
      if (isKnown(value) && flight.mission().variables[i].type.kind != TypeKind::Bool) {
        ++steps;
        EXPECT_TRUE(!held_[i].empty && held_[i].lowest <= value && value <= held_[i].highest)
            << flight.mission().variables[i].name << " " << value;
      }
    }
  }

 private:
  std::vector<Interval> held_;
};

TEST(Containment, HeldRanges) {
  holds<HeldRanges>();
}

}  // namespace
}  // namespace glider::containment
