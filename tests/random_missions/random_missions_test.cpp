// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/ops.h"
#include "ir/core/validate.h"
#include "ir/text/print.h"
#include "ir/verify/verify.h"
#include "tests/random_missions/random_mission.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <set>

namespace glider::random_missions {
namespace {

constexpr uint64_t kMissions = 200;
constexpr size_t kTicks = 300;

constexpr ir::ListKind kLists[] = {ir::ListKind::Always, ir::ListKind::State, ir::ListKind::Profile,
                                   ir::ListKind::Route};

const std::vector<ir::Case>& casesOf(const ir::Mission& mission, ir::StateId state,
                                     ir::ListKind list) {
  switch (list) {
    case ir::ListKind::Always:
      return mission.always;
    case ir::ListKind::State:
      return mission[state].cases;
    case ir::ListKind::Profile:
      return mission[state].profile.cases;
    case ir::ListKind::Route:
      break;
  }
  return mission[state].route.cases;
}

/// What happened over many missions: whether they are worth running two things against each other.
struct Statistics {
  std::set<ir::Op> ops;
  std::set<std::pair<ir::ListKind, ir::Transition>> fired;
  std::set<ir::Command> commands;
  size_t refused = 0, lost_notes = 0, unknown_sets = 0, logs = 0, variables = 0,
         unknown_variables = 0;
  size_t several = 0, left_first = 0, called = 0, returned = 0, exited = 0, transitions = 0,
         ticks = 0;
  size_t deepest = 0, states = 0, states_visited = 0;
  size_t guards = 0, unknown_guards = 0, true_guards = 0;
  size_t arguments = 0, unknown_arguments = 0, readings = 0, unknown_readings = 0,
         subnormal_arguments = 0;

  void run(uint64_t seed) {
    const ir::Mission mission = seed % 2 == 0 ? flownMission(seed) : randomMission(seed);
    support::DiagnosticEngine diagnostics;
    const ir::MissionFacts facts = ir::verify(mission, diagnostics);
    ASSERT_FALSE(diagnostics.hasErrors())
        << seed << ": " << diagnostics.sorted().front().message << ir::print(mission);
    for (const ir::Expr& e : mission.exprs) {
      ops.insert(e.op);
    }
    ir::Interpreter interpreter(mission, facts.stack_depth, randomExternals());
    ir::TickResult last;
    std::set<uint32_t> visited;
    bool calls = false;
    bool returns = false;
    const std::vector<StreamTick> stream = randomStream(mission, seed, kTicks);
    for (size_t i = 0; i < stream.size() && !last.finished; ++i) {
      const ir::TickResult now =
          i == 0 ? interpreter.start(stream[i].frame, randomParameters(mission, seed))
                 : interpreter.tick(stream[i].mission_time, stream[i].frame);
      for (ir::ListKind list : kLists) {
        if (now.firedIn(list)) {
          const ir::Transition transition =
              casesOf(mission, last.state, list)[*now.firedIn(list)].transition;
          fired.insert({list, transition});
          transitions += now.moved && now.moved->list == list;
          calls |= transition == ir::Transition::Call;
          returns |= transition == ir::Transition::Return;
        }
      }
      notes(now);
      count(mission, interpreter, now);
      visited.insert(now.state.index);
      deepest = std::max(deepest, now.stack.size());
      last = now;
    }
    several += mission.states.size() > 1;
    left_first += visited.size() > 1;
    called += calls;
    returned += returns;
    exited += last.finished;
    states += mission.states.size();
    states_visited += visited.size();
  }

  void notes(const ir::TickResult& now) {
    lost_notes += now.lost_notes;
    for (const ir::Note& note : now.notes) {
      unknown_sets += note.kind == ir::NoteKind::UnknownSet;
      logs += note.kind == ir::NoteKind::Log;
    }
    for (double value : now.variables) {
      ++variables;
      unknown_variables += value != value;
    }
  }

  void count(const ir::Mission& mission, const ir::Interpreter& interpreter,
             const ir::TickResult& now) {
    ++ticks;
    for (const ir::Case& c : mission[now.state].cases) {
      const ir::Truth truth = interpreter.truthOf(c.guard);
      ++guards;
      unknown_guards += truth == ir::Truth::Unknown;
      true_guards += truth == ir::Truth::True;
    }
    for (uint32_t i = 0; i < mission.sensors.size(); ++i) {
      const double value = interpreter.readingOf({i});
      ++readings;
      unknown_readings += value != value;
    }
    for (const ir::Action& action : now.actions) {
      if (const auto* command = std::get_if<ir::CommandRun>(&action)) {
        commands.insert(command->command);
        refused += command->refused;
        continue;
      }
      for (double value : std::get<ir::ActivityRun>(action).arguments) {
        ++arguments;
        unknown_arguments += value != value;
        subnormal_arguments += value != 0 && std::abs(value) < 0x1p-1022;
      }
    }
  }
};

/// Corners that passes and generated code have gone wrong in.
struct Corners {
  size_t idle_calls = 0;    ///< `false && f()`
  size_t unread_calls = 0;  ///< watched, and read by nothing
  size_t along_twins = 0;   ///< windows that differ only in what they run along
  size_t minus_zeros = 0;   ///< constants
  size_t ages_of_six = 0;   ///< steps of 6 s: what a window just takes

  void count(const ir::Mission& m, uint64_t seed) {
    const auto of = [&](ir::ExprId id) { return m[id].op; };
    std::vector<bool> read(m.temporals.size());
    for (const ir::Expr& e : m.exprs) {
      if (e.op == ir::Op::And || e.op == ir::Op::Or) {
        const ir::Op ruling = e.op == ir::Op::And ? ir::Op::False : ir::Op::True;
        idle_calls += (of(e.operands[0]) == ruling && of(e.operands[1]) == ir::Op::Call) ||
                      (of(e.operands[1]) == ruling && of(e.operands[0]) == ir::Op::Call);
      }
      if (e.temporal.valid()) {
        read[e.temporal.index] = true;
      }
      minus_zeros += e.op == ir::Op::Constant && e.number == 0 && std::signbit(e.number);
    }
    for (size_t i = 0; i < m.temporals.size(); ++i) {
      const ir::Temporal& t = m.temporals[i];
      unread_calls += !read[i] && of(t.operand) == ir::Op::Call;
      const ir::Temporal* last = i > 0 ? &m.temporals[i - 1] : nullptr;
      along_twins += last != nullptr && last->kind == t.kind && last->operand == t.operand &&
                     last->length == t.length && last->along != t.along;
    }
    const auto stream = randomStream(m, seed, kTicks);
    for (size_t i = 1; i < stream.size(); ++i) {
      ages_of_six += stream[i].mission_time - stream[i - 1].mission_time == 6;
    }
  }
};

TEST(RandomMissions, ReachTheCorners) {
  Corners c;
  for (uint64_t seed = 0; seed < kMissions; ++seed) {
    c.count(flownMission(seed), seed);
  }
  EXPECT_GT(c.idle_calls, 20u);
  EXPECT_GT(c.unread_calls, 20u);
  EXPECT_GT(c.along_twins, 20u);
  EXPECT_GT(c.minus_zeros, 100u);
  EXPECT_GT(c.ages_of_six, kMissions);
}

TEST(RandomMissions, AreWorthRunning) {
  Statistics s;
  for (uint64_t seed = 0; seed < kMissions; ++seed) {
    s.run(seed);
    ASSERT_FALSE(HasFatalFailure());
  }
  EXPECT_EQ(s.ops.size(), ir::opCount());
  EXPECT_EQ(s.fired.size(), 13u) << "every transition of every list fires";
  EXPECT_EQ(s.commands.size(), ir::commands().size());
  EXPECT_GT(s.refused, 100u);
  EXPECT_GT(s.lost_notes, 100u);
  EXPECT_GT(s.unknown_sets, 100u);
  EXPECT_GT(s.logs, 1000u);
  EXPECT_GT(s.unknown_variables, s.variables / 50);
  EXPECT_LT(s.unknown_variables, s.variables * 7 / 10);
  EXPECT_GT(s.several, kMissions * 8 / 10);
  EXPECT_GT(s.left_first, s.several * 8 / 10);
  EXPECT_GT(s.called, kMissions / 2);
  EXPECT_GT(s.returned, kMissions * 4 / 10);
  EXPECT_GT(s.exited, kMissions / 20);
  EXPECT_LT(s.exited, kMissions * 6 / 10);
  EXPECT_GT(s.transitions, s.ticks / 20);
  EXPECT_GT(s.ticks, kMissions * kTicks / 2);
  EXPECT_GE(s.deepest, 4u);
  EXPECT_GT(s.states_visited * 20, s.states * 9);
  EXPECT_GT(s.unknown_guards, s.guards / 20);
  EXPECT_GT(s.true_guards, s.guards / 10);
  EXPECT_GT(s.unknown_readings, s.readings / 20);
  EXPECT_LT(s.unknown_readings, s.readings / 2);
  EXPECT_GT(s.unknown_arguments, s.arguments / 50);
  EXPECT_GT(s.subnormal_arguments, 0u);
}

TEST(RandomMissions, AreTheSameForASeed) {
  EXPECT_EQ(ir::print(randomMission(7)), ir::print(randomMission(7)));
  EXPECT_NE(ir::print(randomMission(7)), ir::print(randomMission(8)));
  const ir::Mission mission = randomMission(7);
  const auto a = randomStream(mission, 1, 100);
  const auto b = randomStream(mission, 1, 100);
  ASSERT_EQ(a.size(), 101u);
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].frame.size(), b[i].frame.size());
    for (size_t k = 0; k < a[i].frame.size(); ++k) {
      EXPECT_EQ(std::bit_cast<uint64_t>(a[i].frame[k].raw),
                std::bit_cast<uint64_t>(b[i].frame[k].raw));
    }
  }
}

TEST(RandomMissions, StreamsHoldEverySpecialReading) {
  bool signalling = false, subnormal = false, infinite = false, minus_zero = false,
       backwards = false, gap = false;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const auto stream = randomStream(flownMission(seed), seed, kTicks);
    for (size_t i = 1; i < stream.size(); ++i) {
      backwards |= stream[i].mission_time < stream[i - 1].mission_time;
      gap |= stream[i].mission_time > stream[i - 1].mission_time + 600;
      for (const ir::SensorUpdate& update : stream[i].frame) {
        const auto bits = std::bit_cast<uint64_t>(update.raw);
        signalling |= std::isnan(update.raw) && (bits >> 51 & 1) == 0;
        subnormal |= update.raw != 0 && std::abs(update.raw) < 0x1p-1022;
        infinite |= std::isinf(update.raw);
        minus_zero |= bits == 1ULL << 63;
      }
    }
  }
  EXPECT_TRUE(signalling && subnormal && infinite && minus_zero && backwards && gap);
}

}  // namespace
}  // namespace glider::random_missions
