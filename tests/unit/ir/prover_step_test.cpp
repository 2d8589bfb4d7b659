// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Each tick of the interpreter lies inside the step that proofs assume: SymbolicTick's terms
// have a solution that is this tick, and AbstractRun's ranges hold what it leaves.

#include "ir/prove/abstract/abstract_run.h"
#include "ir/prove/encoding/layout.h"
#include "ir/prove/encoding/question.h"
#include "tests/random_missions/random_mission.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <limits>

namespace glider::ir::prove {
namespace {

/// All that a mission keeps matters, except for the vehicle.
ConeOfInfluence everything(const Mission& m) {
  ConeOfInfluence all;
  all.variables.assign(m.variables.size(), true);
  all.temporals.assign(m.temporals.size(), true);
  all.profiles.assign(m.states.size(), true);
  all.routes.assign(m.states.size(), true);
  all.state_time = all.resume_time = true;
  return all;
}

/// What a tick of the interpreter left, with the clocks that it started.
struct Left {
  TickResult result;
  double time = 0, entered = 0, resumed = 0;
};

Left leftBy(TickResult result, double time, const Left& before) {
  Left left{std::move(result), time, before.entered, before.resumed};
  const auto& waiting = before.result.stack;
  if (left.result.moved) {
    left.resumed = time;
    left.entered = left.result.just_returned ? waiting.back().entered : time;
  }
  return left;
}

Control controlOf(const TickResult& result) {
  const auto limit = [](Limit l) { return l == kNoLimit ? Control::kNoLimit : uint32_t{l}; };
  Control control;
  control.state = result.state;
  control.limit = limit(result.limit);
  control.just_returned = result.just_returned;
  for (const Frame& frame : result.stack) {
    control.stack.push_back({frame.state, limit(frame.limit)});
  }
  return control;
}

/// Asks whether a step of the terms is what the interpreter did.
class StepQuestion {
 public:
  StepQuestion(const ProofContext& proof_context, const ConeOfInfluence& relevance)
      : proof_context_(proof_context), m_(proof_context.mission), relevance_(relevance) {}

  Answer ask(const Left& before, const Left& after, const Interpreter& interpreter) {
    z3::context context;
    Unknowns unknowns(context);
    const std::vector<MemoryTerm> memory;
    Question question(context, 2000000);
    const Layout layout(proof_context_, relevance_, memory);
    const Configuration from = layout.make(controlOf(before.result), unknowns);
    equate(question, from, before);
    SymbolicState moment(unknowns, proof_context_);
    const z3::expr now = realOf(context, after.time);
    moment.setClocks(now, now, now);
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      equate(question, moment.reading({i}), interpreter.readingOf({i}));
    }
    auto outcomes =
        SymbolicTick(proof_context_, relevance_, unknowns).run(from, now, moment, Pace::Many);
    question.add(unknowns);
    z3::expr any = context.bool_val(false);
    for (const Outcome& outcome : outcomes) {
      if (isSame(outcome, after.result)) {
        z3::expr same = outcome.condition;
        same = outcome.after ? same && holdsWhat(*outcome.after, after) : same;
        any = any || same;
      }
    }
    question.add(any);
    return question.ask();
  }

  /// Of the start: can the terms be what the interpreter did, or with `other` something else?
  Answer askStart(const Left& after, const Interpreter& interpreter, bool other) {
    z3::context context;
    Unknowns unknowns(context);
    const std::vector<MemoryTerm> memory;
    Question question(context, 2000000);
    const Layout layout(proof_context_, relevance_, memory);
    Configuration from = layout.make({{0}, {}, Control::kNoLimit, false}, unknowns);
    from.mission_time = from.resumed = context.real_val(0);
    from.entered = {context.real_val(0)};
    SymbolicState moment(unknowns, proof_context_);
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      equate(question, moment.reading({i}), interpreter.readingOf({i}));
    }
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      if (m_.variables[i].kind == VariableKind::Parameter) {
        question.add(holds(from.store, i, after.result.variables[i]));
      }
    }
    const Configuration to = SymbolicTick(proof_context_, relevance_, unknowns).start(from, moment);
    question.add(unknowns);
    const z3::expr same = holdsWhat(to, after);
    question.add(other ? !same : same);
    EXPECT_EQ(layout.row(to).size(), layout.row(from).size());
    return question.ask();
  }

 private:
  static bool isSame(const Outcome& outcome, const TickResult& result) {
    if (outcome.fired.has_value() != result.moved.has_value()) {
      return false;
    }
    return !result.moved ||
           (outcome.list == result.moved->list && *outcome.fired == result.moved->number);
  }

  static void equate(Question& question, const NumberTerm& term, double value) {
    z3::context& context = term.value.ctx();
    question.add(value == value ? term.known && term.value == realOf(context, value) : !term.known);
  }

  void equate(Question& question, const Configuration& from, const Left& left) const {
    question.add(holdsWhat(from, left));
    for (const auto& [index, watched] : from.watched) {
      z3::context& context = watched.since.ctx();
      const bool always = m_.temporals[index].list == ListKind::Always;
      question.add(watched.since >= realOf(context, always ? 0 : left.resumed) &&
                   watched.since <= realOf(context, left.time));
    }
  }

  [[nodiscard]] bool keeps(const Control& control, const Variable& v) const {
    return !v.owner.valid() || control.holds(v.owner);
  }

  /// Whether a variable has this value; NaN: unknown.
  [[nodiscard]] z3::expr holds(const Store& store, uint32_t variable, double value) const {
    if (m_.variables[variable].type.kind == TypeKind::Bool) {
      const TruthTerm& term = store.truths.at(variable);
      return value != value ? !term.is_true && !term.is_false
             : value != 0   ? term.is_true && !term.is_false
                            : term.is_false && !term.is_true;
    }
    const NumberTerm& term = store.numbers.at(variable);
    return value == value ? term.known && term.value == realOf(term.value.ctx(), value)
                          : !term.known;
  }

  z3::expr holdsWhat(const Configuration& c, const Left& left) const {
    z3::context& context = c.mission_time.ctx();
    z3::expr same = c.mission_time == realOf(context, left.time) &&
                    c.entered.back() == realOf(context, left.entered) &&
                    c.resumed == realOf(context, left.resumed);
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const double value = left.result.variables[i];
      if (!keeps(c.control, m_.variables[i])) {
        continue;
      }
      same = same && holds(c.store, i, value);
    }
    return same;
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  const ConeOfInfluence& relevance_;
};

/// Ticks of `mission`, each asked for; the number of those that the solver has found.
size_t askTicks(const Mission& mission, const std::vector<random_missions::StreamTick>& stream,
                const Externals& externals = {}) {
  const ProofContext proof_context(mission, slocum());
  const ConeOfInfluence relevance = everything(mission);
  Interpreter interpreter(mission, static_cast<uint32_t>(mission.states.size()), externals);
  Left before{interpreter.start(stream.front().frame), 0, 0, 0};
  size_t found = 0;
  for (size_t i = 1; i < stream.size() && !before.result.finished; ++i) {
    const double time = std::max(before.time, stream[i].mission_time);
    Left after = leftBy(interpreter.tick(time, stream[i].frame), time, before);
    const Answer answer = StepQuestion(proof_context, relevance).ask(before, after, interpreter);
    EXPECT_NE(answer, Answer::No) << "tick " << i << " at " << time << " s";
    found += answer == Answer::Yes ? 1 : 0;
    if (testing::Test::HasFailure()) {
      break;
    }
    before = std::move(after);
  }
  return found;
}

/// Whether the solver finds the start of `mission`, and something else that it may be.
std::pair<Answer, Answer> askStart(const Mission& mission, const std::vector<SensorUpdate>& frame,
                                   const Externals& externals = {}) {
  const ProofContext proof_context(mission, slocum());
  const ConeOfInfluence relevance = everything(mission);
  Interpreter interpreter(mission, static_cast<uint32_t>(mission.states.size()), externals);
  const Left left{interpreter.start(frame), 0, 0, 0};
  StepQuestion question(proof_context, relevance);
  return {question.askStart(left, interpreter, false), question.askStart(left, interpreter, true)};
}

TEST(ProverStep, HoldsTheStartOfRandomMissions) {
  size_t yes = 0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    const Mission mission = random_missions::randomMission(seed);
    const auto frame = random_missions::randomStream(mission, seed, 0).front().frame;
    const auto found = askStart(mission, frame, random_missions::randomExternals()).first;
    ASSERT_NE(found, Answer::No) << "seed " << seed;
    yes += found == Answer::Yes ? 1 : 0;
  }
  EXPECT_GT(yes, 50U);
}

/// Each sees what was set before it: the mission's variables, what `always` watches, the state's
/// variables, what it watches, its entry, its profile, its route.
TEST(ProverStep, TheStartRunsItsPartsInOrder) {
  const Mission mission = missionOf(kHeader + R"(behaviour profile rise symbol "" () reads ()
behaviour route way symbol "" () reads ()
variable p: number parameter lowest 0 highest 9
variable met: bool parameter
variable n: number mission lowest -100 highest 100
variable m: number mission lowest -100 highest 100
variable l: number mission lowest -100 highest 100
variable at_once: bool mission
variable turned: bool mission
variable "a.x": number state of a lowest -100 highest 100
initial p 2
initial met true
initial n (var p)
initial m 0
initial l 5
initial at_once false
initial turned true
initial "a.x" (var n)
temporal held always (and (var met) (gt (sensor depth) 5:length)) for 0:time
temporal became state a (gt (sensor depth) 5:length)
state a
  route way begin entry do set l (var m) end end
  profile rise begin entry do set m (var n) end end
  entry do if (temporal 0) set at_once true end
    if (temporal 1) set turned true else set turned false end
    if (and (le missiontime 0:time) (eq (var "a.x") (var p))) set n 7 end end
  case true stay
)");
  const std::vector<SensorUpdate> frame = {{{0}, 10}};
  Interpreter interpreter(mission, 1);
  EXPECT_EQ(interpreter.start(frame).variables, (std::vector<double>{2, 1, 7, 7, 7, 1, 0, 2}));
  EXPECT_EQ(askStart(mission, frame), std::pair(Answer::Yes, Answer::No));
}

TEST(ProverStep, HoldsTheTicksOfRandomMissions) {
  size_t found = 0;
  for (uint64_t seed = 0; seed < 24; ++seed) {
    const Mission mission = random_missions::randomMission(seed);
    found += askTicks(mission, random_missions::randomStream(mission, seed, 12),
                      random_missions::randomExternals());
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(found, 60U);
}

/// Four seconds apart; the depths are those of the ticks, NaN: none.
std::vector<random_missions::StreamTick> streamOf(const std::vector<double>& depths) {
  std::vector<random_missions::StreamTick> stream;
  for (const double depth : depths) {
    auto& tick = stream.emplace_back();
    tick.mission_time = 4.0 * static_cast<double>(stream.size() - 1);
    if (depth == depth) {
      tick.frame = {{{0}, depth}};
    }
  }
  return stream;
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void expectTicks(const std::string& text, const std::vector<double>& depths) {
  const Mission mission = missionOf(kHeader + text);
  EXPECT_EQ(askTicks(mission, streamOf(depths)), depths.size() - 1);
}

TEST(ProverStep, ArgumentsAreEvaluatedTogether) {
  const std::string swap =
      R"(variable "b.x": number argument of b
variable "b.y": number argument of b
state a route drift () profile glide () case true goto b (1, 9)
state b ("b.x", "b.y") route drift () profile glide () case true goto b ((var "b.y"), (var "b.x"))
)";
  expectTicks(swap, {1, 1, 1, 1});
  const std::string called =
      R"(variable "b.x": number argument of b
variable "b.y": number argument of b
variable m: number mission lowest 0 highest 100
initial m 3
state a route drift () profile glide () case true do set m 5 end goto b (1, (var m))
state b ("b.x", "b.y") route drift () profile glide ()
  case true do set m (var "b.y") end goto b ((add (var "b.y") (var m)), (var "b.x"))
)";
  expectTicks(called, {1, 1, 1, 1});
}

TEST(ProverStep, HeldMayBeTrueAtOnce) {
  for (const char* duration : {"0:time", "-3:time", "4:time"}) {
    expectTicks(fmt::format(R"(variable d: time mission lowest -100 highest 100
variable hit: bool mission
initial d {}
initial hit false
temporal held state b (gt (sensor depth) 5:length) for (var d)
state a route drift () profile glide () case true goto b
state b route drift () profile glide () entry do if (temporal 0) set hit true end end
  case (var hit) goto a
)",
                            duration),
                {1, 10, 10, 1, 10, 10});
  }
}

TEST(ProverStep, ADurationIsRounded) {
  // 0.1 is a little more than a tenth; 40 times that is 4 where doubles round.
  expectTicks(R"(variable d: time mission lowest -100 highest 100
variable hit: bool mission
initial d 40:time
initial hit false
temporal held state b (gt (sensor depth) 5:length) for (mul 0.1 (var d))
state a route drift () profile glide () case true goto b
state b route drift () profile glide () case (temporal 0) do set hit true end goto a
)",
              {1, 10, 10, 10, 10, 10});
}

TEST(ProverStep, AWindowStartsAgainWithItsState) {
  expectTicks(R"(variable known: bool mission
initial known false
temporal lowest state a (sensor depth) over 8
state a route drift () profile glide () entry do if (known (temporal 0)) set known true
  else set known false end end
  case (gt (temporal 0) 1:length) goto a
)",
              {3, 4, 5, 6, 7, 8, 9});
}

TEST(ProverStep, AnIfOnAnUnknownDoesNothing) {
  expectTicks(R"(variable n: number mission lowest 0 highest 100
initial n 1
state a route drift () profile glide ()
  case true do if (gt (sensor depth) 5:length) set n 2 else set n 3 end
    if (gt (var n) 0) if (gt (sensor depth) 50:length) set n 4 else set n 5 end end end stay
)",
              {kNone, kNone, 3, 60, 20, 30, 4});
}

TEST(ProverStep, WholeNumbersEndBelowTwoToThe53) {
  for (const char* start : {"9007199254740990", "9007199254740991", "9007199254740992"}) {
    expectTicks(fmt::format(R"(variable n: number mission lowest 0 highest 9007199254740992
initial n {}
state a route drift () profile glide () case true do set n (add (var n) 1) end stay
)",
                            start),
                {1, 1, 1, 1});
  }
}

TEST(ProverStep, ASumThatAlwaysOverflowsIsUnknown) {
  expectTicks(R"(variable n: number mission lowest 0 highest 10
variable big: number mission
initial n 1
initial big 1.7e308
state a route drift () profile glide ()
  case true do if (known (add 1.7e308 1.7e308)) set n 2 else set n 3 end set big (add (var big) (var big)) end stay
)",
              {1, 1, 1});
}

TEST(ProverStep, AClampWhoseBoundsAreExchangedIsNotContinuous) {
  expectTicks(R"(variable low: length parameter lowest 0 highest 50
variable high: length parameter lowest 0 highest 50
variable x: length mission lowest 0 highest 100
initial low 0.6000000000000001:length
initial high 0.1:length
initial x 0:length
state a route drift () profile glide ()
  case true do set x (clamp (mul 0.1 (sensor depth)) (var low) (var high)) end stay
)",
              {1, 6, 90, 6});  // 0.1 times 6 is rounded up to `low`
}

/// What the interpreter's variables hold lies in a valuation.
void expectWithin(const Valuation& values, const TickResult& result, const Mission& m,
                  const std::string& where) {
  for (uint32_t i = 0; i < m.variables.size(); ++i) {
    const Variable& v = m.variables[i];
    const double value = result.variables[i];
    if (v.owner.valid() && v.owner != result.state) {
      continue;
    }
    const PossibleValues& held = values[i];
    if (v.type.kind == TypeKind::Bool) {
      EXPECT_TRUE(value != value ? held.truths.is_unknown
                  : value != 0   ? held.truths.is_true
                                 : held.truths.is_false)
          << v.name << " " << where;
    } else if (value == value) {
      EXPECT_TRUE(!held.never && value >= held.lowest && value <= held.highest)
          << v.name << " is " << value << " " << where;
    }
  }
}

Valuation exactly(const TickResult& result, const Mission& m) {
  Valuation values;
  for (uint32_t i = 0; i < m.variables.size(); ++i) {
    const double value = result.variables[i];
    PossibleValues held = anything(m.variables[i]);
    if (m.variables[i].type.kind == TypeKind::Bool) {
      held.truths = {value == 1, value == 0, value != value};
    } else if (value == value) {
      held = {value, value, false, {}};
    }
    values.push_back(held);
  }
  return values;
}

/// A transition by a state's own case, on a tick on which nothing else fired.
size_t followTransitions(const Mission& mission,
                         const std::vector<random_missions::StreamTick>& stream,
                         const Externals& externals = {}) {
  const ProofContext proof_context(mission, slocum());
  const AbstractRun abstract(proof_context);
  Interpreter interpreter(mission, static_cast<uint32_t>(mission.states.size()), externals);
  TickResult before = interpreter.start(stream.front().frame);
  size_t followed = 0;
  for (size_t i = 1; i < stream.size() && !before.finished; ++i) {
    const TickResult after = interpreter.tick(stream[i].mission_time, stream[i].frame);
    const bool plain = after.moved && after.moved->list == ListKind::State && !after.finished &&
                       !after.firedIn(ListKind::Always);
    if (plain) {
      const Case& c = mission[before.state].cases[after.moved->number];
      const Interval all{0, 1e12, false};
      const ClockRanges clocks{all, all, all};
      Valuation values = exactly(before, mission);
      abstract.execute(c.action, clocks, values);
      c.transition == Transition::Return ? abstract.resume(after.state, clocks, values)
                                         : abstract.enter(after.state, &c, clocks, values);
      expectWithin(values, after, mission, fmt::format("after tick {}", i));
      ++followed;
    }
    before = after;
  }
  return followed;
}

TEST(AbstractStep, HoldsTheTransitionsOfRandomMissions) {
  size_t followed = 0;
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const Mission mission = random_missions::randomMission(seed);
    followed += followTransitions(mission, random_missions::randomStream(mission, seed, 40),
                                  random_missions::randomExternals());
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(followed, 300U);
}

TEST(AbstractStep, AnUnknownIfTakesNeitherBranch) {
  const Mission mission = missionOf(kHeader + R"(variable n: number mission lowest 0 highest 100
initial n 1
state a route drift () profile glide () case true goto b
state b route drift () profile glide ()
  entry do if (gt (sensor depth) 5:length) set n 2 else set n 3 end end case true goto a
)");
  EXPECT_EQ(followTransitions(mission, streamOf({kNone, kNone, kNone, 10, 10, 2, 2})), 6U);
}

TEST(AbstractStep, ASumThatAlwaysOverflowsIsUnknown) {
  const Mission mission = missionOf(kHeader + R"(variable n: number mission lowest 0 highest 100
initial n 1
state a route drift () profile glide ()
  entry do if (lt (add 1.7e308 1.7e308) 1) set n 2 else set n 3 end end case true goto a
)");
  EXPECT_EQ(followTransitions(mission, streamOf({1, 1, 1})), 2U);
}

TEST(AbstractStep, ArgumentsAreEvaluatedTogether) {
  const Mission mission = missionOf(kHeader + R"(variable "b.x": number argument of b
variable "b.y": number argument of b
state a route drift () profile glide () case true goto b (1, 9)
state b ("b.x", "b.y") route drift () profile glide () case true goto b ((var "b.y"), (var "b.x"))
)");
  EXPECT_EQ(followTransitions(mission, streamOf({1, 1, 1, 1})), 3U);
}

TEST(AbstractEvaluator, AWindowHoldsWhatWasBefore) {
  const Mission mission = missionOf(kHeader + R"(variable n: number mission lowest 0 highest 100
initial n 7
temporal highest always (var n) over 100
always case (gt (temporal 0) 5) stay
state a route drift () profile glide () case true do set n 1 end stay
)");
  const ProofContext proof_context(mission, slocum());
  Valuation values{PossibleValues{1, 1, false, {}}};
  const Interval all{0, 1e6, false};
  const AbstractEvaluator possible(proof_context, values, {all, all, all});
  EXPECT_TRUE(possible.truth(mission.always[0].guard).is_true) << "it was 7 a moment ago";
}

}  // namespace
}  // namespace glider::ir::prove
