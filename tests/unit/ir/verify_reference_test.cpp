// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/print.h"
#include "ir/verify/passes.h"
#include "ir/verify/verify.h"
#include "tests/random_missions/random.h"
#include "tests/unit/ir/missions.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <map>
#include <set>

namespace glider::ir {
namespace {

/// A random mission of few states whose cases do anything, most of them mistaken. Half of them call
/// later states only, and so without a cycle.
Mission tangle(random_missions::Random& random) {
  const bool forward = random.chance(0.5);
  const uint32_t states = random.between(1, forward ? 6 : 4);
  const uint32_t most_cases = random.between(2, 5);
  constexpr const char* kGuards[] = {"(ge statetime 4:time)",
                                     "(ge statetime 4:time)",
                                     "(ge statetime 4:time)",
                                     "true",
                                     "false",
                                     "(not (or true (ge statetime 4:time)))"};
  std::string text = kHeader;
  for (uint32_t s = 0; s < states; ++s) {
    std::string cases;
    for (uint32_t k = random.below(most_cases + 1); k > 0; --k) {
      cases += fmt::format("case {} ", random.chance(0.8) ? kGuards[0] : random.pick(kGuards));
      switch (random.below(8)) {
        case 0:
        case 1:
          cases += fmt::format("goto s{} ", random.below(states));
          break;
        case 2:
        case 3:
        case 4:
          cases += forward && s + 1 == states
                       ? "stay "
                       : fmt::format("call s{} ", forward ? random.between(s + 1, states - 1)
                                                          : random.below(states));
          break;
        case 5:
          cases += "return ";
          break;
        case 6:
          cases += "exit ";
          break;
        default:
          cases += "stay ";
      }
    }
    text += stateText(fmt::format("s{}", s), cases);
  }
  return missionOf(text);
}

/// The stack, outermost first, with the current state last.
using Configuration = std::vector<uint32_t>;

/// What a mission can do, found by walking every configuration with at most twice as many states on
/// the stack as the mission has: a shortest run to a state, or to a state with an empty stack,
/// needs no more.
struct Reference {
  std::set<uint32_t> reached, empty_returns;
  bool recursive = false;
  size_t depth = 0;
  std::map<Configuration, std::set<Configuration>> next;
  std::set<Configuration> ends;  ///< an exit, a dead end or a return to nowhere

  explicit Reference(const Mission& mission) {
    const size_t deepest = 2 * mission.states.size() + 1;
    std::deque<Configuration> pending = {{0}};
    next[{0}];
    while (!pending.empty()) {
      const Configuration now = pending.front();
      pending.pop_front();
      reached.insert(now.back());
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
    for (const Case& c : mission.states[now.back()].cases) {
      if (isFalse(mission, c.guard)) {
        continue;
      }
      leaves |= c.transition != Transition::Stay;
      Configuration then = now;
      if (c.transition == Transition::Goto) {
        result.push_back({c.target.index});
      } else if (c.transition == Transition::Call) {
        recursive |= std::ranges::find(now, c.target.index) != now.end();
        then.push_back(c.target.index);
        result.push_back(then);
      } else if (c.transition == Transition::Return && now.size() > 1) {
        then.pop_back();
        result.push_back(then);
      } else if (c.transition == Transition::Return) {
        empty_returns.insert(now.back());
        ends.insert(now);
      } else if (c.transition == Transition::Exit) {
        ends.insert(now);
      }
      if (mission[c.guard].op == Op::True) {
        break;
      }
    }
    if (!leaves) {
      ends.insert(now);
    }
    return result;
  }

  /// The two constant shapes that `tangle` makes.
  static bool isFalse(const Mission& mission, ExprId guard) {
    return mission[guard].op == Op::False || mission[guard].op == Op::Not;
  }

  /// The states that are current in a configuration from which none of `ends` is reached.
  std::set<uint32_t> endless() const {
    std::set<Configuration> good = ends;
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
        states.insert(configuration.back());
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

TEST(VerifyReference, AgreesWithEveryConfigurationOfRandomMissions) {
  using support::DiagnosticId;
  random_missions::Random random(20260101);
  size_t recursive = 0, empty_returns = 0, deep = 0, endless = 0, unreached = 0;
  for (int i = 0; i < 2000; ++i) {
    const Mission mission = tangle(random);
    const Reference reference(mission);
    support::DiagnosticEngine diagnostics;
    const MissionFacts facts = verify(mission, diagnostics);
    const Structure structure(mission);
    for (uint32_t s = 0; s < mission.states.size(); ++s) {
      EXPECT_EQ(structure.reached(s), reference.reached.contains(s));
    }
    EXPECT_EQ(count(diagnostics, DiagnosticId::unreachableState),
              mission.states.size() - reference.reached.size());
    EXPECT_EQ(count(diagnostics, DiagnosticId::emptyReturn), reference.empty_returns.size());
    EXPECT_EQ(count(diagnostics, DiagnosticId::recursiveCall) > 0, reference.recursive);
    if (!reference.recursive) {
      EXPECT_EQ(facts.stack_depth, reference.depth);
      EXPECT_EQ(facts.deepest_path.size(), reference.depth + 1);
      EXPECT_EQ(endlessOf(structure), reference.endless());
      endless += !reference.endless().empty();
      deep += reference.depth > 1;
    }
    recursive += reference.recursive;
    empty_returns += !reference.empty_returns.empty();
    unreached += reference.reached.size() < mission.states.size();
    ASSERT_FALSE(HasFailure()) << print(mission);
  }
  // The missions must put the question.
  EXPECT_GT(recursive, 200u);
  EXPECT_LT(recursive, 1500u);
  EXPECT_GT(empty_returns, 200u);
  EXPECT_GT(deep, 100u);
  EXPECT_GT(endless, 30u);
  EXPECT_GT(unreached, 200u);
}

}  // namespace
}  // namespace glider::ir
