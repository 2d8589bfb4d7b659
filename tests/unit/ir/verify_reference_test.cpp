// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/print.h"
#include "ir/verify/passes.h"
#include "ir/verify/verify.h"
#include "support/diagnostics/ids/verification.h"
#include "tests/random_missions/random_structure.h"
#include "tests/unit/ir/missions.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <set>

namespace glider::ir {
namespace {

Mission tangle(random_missions::Random& random, bool with_always) {
  return missionOf(random_missions::randomStructure(random, with_always));
}

/// A state that waits, or is current, with the limit that `always` has there.
using Level = std::pair<uint32_t, uint32_t>;
/// The stack, outermost first, with the current state last.
using Configuration = std::vector<Level>;

bool holds(const Configuration& configuration, uint32_t state) {
  return std::ranges::find(configuration, state, &Level::first) != configuration.end();
}

/// What a mission can do, found by walking every configuration with at most twice as many states on
/// the stack as the mission has: a shortest run to a state, or to a state with an empty stack,
/// needs no more. A call that puts a state on the stack twice is not followed if there is `always`,
/// which would go on without end.
struct Reference {
  std::set<uint32_t> reached, empty_returns, stuck;
  bool recursive = false;
  size_t depth = 0;
  std::map<Configuration, std::set<Configuration>> next;
  std::set<Configuration> ends;     ///< an exit or a return to nowhere
  std::set<Configuration> nowhere;  ///< where nothing can fire that leaves

  explicit Reference(const Mission& mission) {
    const size_t deepest = 2 * mission.states.size() + 1;
    std::deque<Configuration> pending = {{{0, kEndlessLimit}}};
    next[pending.front()];
    while (!pending.empty()) {
      const Configuration now = pending.front();
      pending.pop_front();
      reached.insert(now.back().first);
      depth = std::max(depth, now.size() - 1);
      for (const Configuration& then : step(mission, now)) {
        next[now].insert(then);
        if (then.size() <= deepest && !next.contains(then)) {
          next[then];
          pending.push_back(then);
        }
      }
    }
  }

  std::vector<Configuration> step(const Mission& mission, const Configuration& now) {
    std::vector<Configuration> result;
    bool leaves = false;
    for (const Case& c : mission.states[now.back().first].cases) {
      if (isFalse(mission, c.guard)) {
        continue;
      }
      leaves |= c.transition != Transition::Stay;
      fire(mission, now, c, std::nullopt, result);
      if (mission[c.guard].op == Op::True) {
        break;
      }
    }
    for (uint32_t i = 0; i < mission.always.size() && i < now.back().second; ++i) {
      const Case& c = mission.always[i];
      const bool in_use = c.target.valid() && holds(now, c.target.index);
      if (!isFalse(mission, c.guard) && !in_use) {
        leaves |= c.transition != Transition::Stay;
        fire(mission, now, c, i, result);
      }
      if (mission[c.guard].op == Op::True && !c.target.valid()) {
        break;
      }
    }
    if (!leaves) {
      nowhere.insert(now);
      stuck.insert(now.back().first);
    }
    return result;
  }

  void fire(const Mission& mission, const Configuration& now, const Case& c,
            std::optional<uint32_t> always, std::vector<Configuration>& result) {
    Configuration then = now;
    if (c.transition == Transition::Goto) {
      result.push_back({{c.target.index, always.value_or(kEndlessLimit)}});
    } else if (c.transition == Transition::Call) {
      const bool twice = holds(now, c.target.index);
      recursive |= twice;
      then.emplace_back(c.target.index, always.value_or(now.back().second));
      if (!twice || mission.always.empty()) {
        result.push_back(then);
      }
    } else if (c.transition == Transition::Return && now.size() > 1) {
      then.pop_back();
      result.push_back(then);
    } else if (c.transition == Transition::Return) {
      empty_returns.insert(now.back().first);
      ends.insert(now);
    } else if (c.transition == Transition::Exit) {
      ends.insert(now);
    }
  }

  /// The two constant shapes that the random structures have.
  static bool isFalse(const Mission& mission, ExprId guard) {
    return mission[guard].op == Op::False || mission[guard].op == Op::Not;
  }

  /// The states that are current in a configuration from which no end is reached; a dead end counts
  /// as one if it is `told`.
  std::set<uint32_t> endless(const std::set<uint32_t>& told) const {
    std::set<Configuration> good = ends;
    for (const Configuration& c : nowhere) {
      if (told.contains(c.back().first)) {
        good.insert(c);
      }
    }
    for (bool grown = true; grown;) {
      grown = false;
      for (const auto& [from, to] : next) {
        const bool leads =
            std::ranges::any_of(to, [&](const Configuration& c) { return good.contains(c); });
        grown |= leads && good.insert(from).second;
      }
    }
    std::set<uint32_t> states;
    for (const auto& [configuration, to] : next) {
      if (!good.contains(configuration)) {
        states.insert(configuration.back().first);
      }
    }
    return states;
  }
};

std::set<uint32_t> endlessOf(const Structure& structure) {
  const std::vector<bool> endless = statesWithoutEnd(structure);
  std::set<uint32_t> states;
  for (uint32_t s = 0; s < structure.size(); ++s) {
    if (endless[s]) {
      states.insert(s);
    }
  }
  return states;
}

size_t count(const support::DiagnosticEngine& diagnostics, support::DiagnosticId id) {
  const auto all = diagnostics.sorted();
  return static_cast<size_t>(std::ranges::count(all, id, &support::Diagnostic::id));
}

std::set<uint32_t> deadEndsOf(const Structure& structure) {
  std::set<uint32_t> states;
  for (uint32_t s : structure.order) {
    if (structure.deadEnd(s)) {
      states.insert(s);
    }
  }
  return states;
}

/// How often the random missions put each question.
struct Statistics {
  size_t recursive = 0, empty_returns = 0, deep = 0, endless = 0, unreached = 0, stuck = 0;
  size_t missed_endless = 0, missed_stuck = 0;
};

/// What is exact with `always` and without.
void compare(const Mission& mission, const Reference& reference, Statistics& s) {
  support::DiagnosticEngine diagnostics;
  const MissionFacts facts = verify(mission, diagnostics);
  const Structure structure(mission);
  for (uint32_t i = 0; i < mission.states.size(); ++i) {
    EXPECT_EQ(structure.reached(i), reference.reached.contains(i));
  }
  EXPECT_EQ(count(diagnostics, support::diagnostics::unreachableState),
            mission.states.size() - reference.reached.size());
  EXPECT_EQ(count(diagnostics, support::diagnostics::emptyReturn), reference.empty_returns.size());
  EXPECT_EQ(count(diagnostics, support::diagnostics::recursiveCall) > 0, reference.recursive);
  const std::set<uint32_t> dead = deadEndsOf(structure);
  const std::set<uint32_t> endless = endlessOf(structure);
  if (!reference.recursive) {
    EXPECT_TRUE(std::ranges::includes(reference.stuck, dead));
    s.missed_stuck += dead != reference.stuck;
    s.stuck += !reference.stuck.empty();
    EXPECT_EQ(facts.stack_depth, reference.depth);
    ASSERT_EQ(facts.deepest_path.size(), reference.depth + 1);
    const std::set<StateId> different(facts.deepest_path.begin(), facts.deepest_path.end());
    EXPECT_EQ(different.size(), facts.deepest_path.size());
    const std::set<uint32_t> expected = reference.endless(dead);
    EXPECT_TRUE(std::ranges::includes(expected, endless));
    auto missed = [&](uint32_t state) {
      return !endless.contains(state) &&
             (mission.always.empty() || !structure.moves[state].return_case);
    };
    s.missed_endless += std::ranges::any_of(expected, missed);
    s.endless += !expected.empty();
    s.deep += reference.depth > 1;
  }
  s.recursive += reference.recursive;
  s.empty_returns += !reference.empty_returns.empty();
  s.unreached += reference.reached.size() < mission.states.size();
}

TEST(VerifyReference, AgreesWithEveryConfigurationOfRandomMissions) {
  random_missions::Random random(20260101);
  Statistics s;
  for (int i = 0; i < 2000; ++i) {
    const Mission mission = tangle(random, false);
    compare(mission, Reference(mission), s);
    ASSERT_FALSE(HasFailure()) << print(mission);
  }
  EXPECT_EQ(s.missed_stuck, 0u);
  EXPECT_EQ(s.missed_endless, 0u);
  // The missions must put the question.
  EXPECT_GT(s.recursive, 200u);
  EXPECT_LT(s.recursive, 1500u);
  EXPECT_GT(s.empty_returns, 200u);
  EXPECT_GT(s.deep, 100u);
  EXPECT_GT(s.endless, 30u);
  EXPECT_GT(s.unreached, 200u);
}

/// Depth, recursion, empty returns and what is reached are exact with `always` too; no warning of
/// a dead end or of a missing exit is false, and few are missed (states that return get none).
TEST(VerifyReference, AgreesWithAlways) {
  random_missions::Random random(20260102);
  Statistics s;
  for (int i = 0; i < 3000; ++i) {
    const Mission mission = tangle(random, true);
    compare(mission, Reference(mission), s);
    ASSERT_FALSE(HasFailure()) << print(mission);
  }
  EXPECT_LT(s.missed_stuck * 10, s.stuck);
  EXPECT_LT(s.missed_endless * 8, s.endless);
  EXPECT_GT(s.recursive, 200u);
  EXPECT_LT(s.recursive, 2500u);
  EXPECT_GT(s.empty_returns, 200u);
  EXPECT_GT(s.deep, 300u);
  EXPECT_GT(s.endless, 30u);
  EXPECT_GT(s.stuck, 100u);
}

}  // namespace
}  // namespace glider::ir
