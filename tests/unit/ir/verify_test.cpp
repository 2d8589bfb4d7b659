// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/verify.h"

#include "tests/unit/ir/missions.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace glider::ir {
namespace {

struct Verified {
  support::DiagnosticEngine diagnostics;
  MissionFacts facts;
  explicit Verified(const Mission& mission) : facts(verify(mission, diagnostics)) {}
};

std::vector<uint32_t> indices(const std::vector<StateId>& ids) {
  std::vector<uint32_t> result;
  std::ranges::transform(ids, std::back_inserter(result), &StateId::index);
  return result;
}

std::string clock(int seconds) {
  return fmt::format("case (ge statetime {}:time) ", seconds);
}

TEST(Verify, FindsTheDeepestStackWithItsPath) {
  const Verified v(missionOf(
      kHeader + stateText("a", clock(4) + "call b " + clock(8) + "goto d " + clock(12) + "exit") +
      stateText("b", clock(4) + "return") +
      stateText("c", clock(4) + "call b " + clock(8) + "return") +
      stateText("d", clock(4) + "call b " + clock(5) + "call c " + clock(8) + "exit")));
  EXPECT_FALSE(v.diagnostics.hasErrors());
  EXPECT_EQ(v.facts.stack_depth, 2u);
  EXPECT_EQ(indices(v.facts.deepest_path), (std::vector<uint32_t>{3, 2, 1}));
}

TEST(Verify, AMissionWithoutCallsNeedsNoStack) {
  const Verified v(missionOf(kHeader + stateText("a", clock(4) + "goto a " + clock(8) + "exit")));
  EXPECT_EQ(v.facts.stack_depth, 0u);
  EXPECT_EQ(indices(v.facts.deepest_path), (std::vector<uint32_t>{0}));
  EXPECT_EQ(v.diagnostics.sorted().size(), 0u);
}

/// Calls that only an unreached state makes deepen nothing.
TEST(Verify, CountsReachedCallsOnly) {
  const Verified v(missionOf(kHeader + stateText("a", clock(4) + "call b " + clock(8) + "exit") +
                             stateText("b", clock(4) + "return") +
                             stateText("c", clock(4) + "call a")));
  EXPECT_EQ(v.facts.stack_depth, 1u);
  EXPECT_FALSE(v.diagnostics.hasErrors());
}

/// bench/verify has their times.
TEST(Verify, LongChainsOfCallsAreFollowed) {
  constexpr int kStates = 10'000;
  std::string text = kHeader;
  for (int i = 0; i < kStates; ++i) {
    const std::string next = i + 1 < kStates ? fmt::format("call s{} ", i + 1) + clock(8) : "";
    text += stateText(fmt::format("s{}", i), clock(4) + next + (i == 0 ? "exit" : "return"));
  }
  const Mission mission = missionOf(text);
  const Verified v(mission);
  EXPECT_FALSE(v.diagnostics.hasErrors());
  EXPECT_EQ(v.facts.stack_depth, kStates - 1u);
  EXPECT_EQ(v.facts.deepest_path.size(), size_t{kStates});
}

/// Every state calls, goes to and returns everywhere: many errors, each with a short path.
TEST(Verify, TangledMissionsEndInShortNotes) {
  constexpr int kStates = 150;
  std::string text = kHeader;
  for (int i = 0; i < kStates; ++i) {
    std::string cases;
    for (int k = 0; k < kStates; ++k) {
      cases += clock(k) + fmt::format("{} s{} ", k % 2 == 0 ? "call" : "goto", k);
    }
    text += stateText(fmt::format("s{}", i), cases + clock(1) + "return");
  }
  const Mission mission = missionOf(text);
  const Verified v(mission);
  EXPECT_TRUE(v.diagnostics.hasErrors());
  for (const support::Diagnostic& d : v.diagnostics.sorted()) {
    EXPECT_LT(d.notes.size(), 20u);
  }
}

TEST(Verify, NamesEightOfTheStatesWithoutEnd) {
  const auto notes = [](int states) {
    std::string text = kHeader + stateText("a", clock(4) + "goto s0 " + clock(8) + "exit");
    for (int i = 0; i < states; ++i) {
      text +=
          stateText(fmt::format("s{}", i), clock(4) + fmt::format("goto s{}", (i + 1) % states));
    }
    const Verified v(missionOf(text));
    const auto all = v.diagnostics.sorted();
    EXPECT_EQ(all.size(), 1u);
    return std::ranges::count_if(all.at(0).notes, [](const auto& note) {
      return note.message.find("cannot reach an `exit` either") != std::string::npos;
    });
  };
  EXPECT_EQ(notes(9), 8);
  EXPECT_EQ(notes(10), 8);
  EXPECT_EQ(notes(8), 7);
}

TEST(Verify, PassesAreNamedOnceEach) {
  std::set<std::string_view> names;
  for (const VerifyPass& pass : verifyPasses()) {
    EXPECT_TRUE(names.insert(pass.name).second);
    EXPECT_FALSE(pass.purpose.empty());
  }
  EXPECT_EQ(names.size(), 9u);
}

}  // namespace
}  // namespace glider::ir
