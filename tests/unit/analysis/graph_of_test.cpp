// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The graph of a mission: all that it contains about states and cases, in the mission's own words.

#include "analysis/graph_of.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <gmock/gmock.h>

namespace glider::analysis {
namespace {

using report::GraphTransition;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Every transition; `deaf` is reached by a case that never fires alone, `end` has no transition.
const std::string kMission = R"(mission m
var n : number = 0
always
  case depth > 50 m  exit
state first
begin
  flightroute nav(39 N,
                  74 W)
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)  # as usual
  sensors missiontime, depth, temp
  events
    case temp > 4 degC && depth > 3 m
      do
        set n = n + 1
        log "warm", n
        if n > 3 then set n = 0 end
      end
      stay
    case missiontime >= 1 h  goto second(1 h,
                                         2)
    case missiontime >= 2 h  call third
end
state second(limit: time, k: number)
begin
  flightprofile surfaced
  sensors statetime
  events
    case statetime > limit  goto first
    case false              goto deaf
end
state third
begin
  flightprofile surfaced
  sensors statetime
  events
    case statetime > 1 h  return
    case true             goto first
    case statetime > 2 h  goto first
end
state deaf
begin
  flightprofile surfaced
  sensors statetime
  events
    case statetime > 1 h  exit
end
)";

class GraphOf : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1); }
  /// The graph of `text`, of whose cases `dead` are proved never to fire.
  static report::Graph graph(const std::string& text,
                             const std::map<ir::CasePlace, bool>& dead = {},
                             const std::string& file = "m.mission") {
    const auto compiled = compiler::compileText(file, text);
    EXPECT_TRUE(compiled && compiled->lowered);
    if (!compiled || !compiled->lowered) {
      std::string why;
      for (const auto& one : compiled->diagnostics.sorted()) {
        why += one.message + "\n";
      }
      ADD_FAILURE() << why;
      return {};
    }
    return graphOf(*compiled->lowered, {{2}, {0}}, dead);
  }
};

TEST_F(GraphOf, HasTheStatesAsTheyAreWritten) {
  const report::Graph of = graph(kMission);
  EXPECT_EQ(of.mission, "m");
  EXPECT_EQ(of.platform, "slocum");
  EXPECT_THAT(of.deepest_path, ElementsAre(2, 0));
  ASSERT_EQ(of.states.size(), 4U);
  const report::GraphState& first = of.states[0];
  EXPECT_EQ(first.name, "first");
  EXPECT_EQ(first.parameters, "");
  EXPECT_EQ(first.profile, "yo(5 m, 20 m, 26 deg, 26 deg)");
  EXPECT_EQ(first.route, "nav(39 N, 74 W)") << "on one line";
  EXPECT_TRUE(first.source.starts_with("state first\nbegin\n  flightroute nav(39 N,\n"))
      << first.source;
  EXPECT_FALSE(first.source.ends_with("\n")) << first.source;
  EXPECT_EQ(of.states[1].parameters, "limit: time, k: number");
  EXPECT_EQ(of.states[1].profile, "surfaced");
}

TEST_F(GraphOf, HasEveryTransitionWithItsTarget) {
  const report::Graph of = graph(kMission);
  const auto& first = of.states.at(0).cases;
  ASSERT_EQ(first.size(), 3U);
  EXPECT_EQ(first[0].transition, GraphTransition::Stay);
  EXPECT_EQ(first[0].guard, "temp > 4 degC && depth > 3 m");
  EXPECT_EQ(first[0].action, "set n, log, if …");
  EXPECT_EQ(first[1].transition, GraphTransition::Goto);
  EXPECT_EQ(first[1].target, 1U);
  EXPECT_EQ(first[1].action, "");
  EXPECT_THAT(first[1].source, ::testing::HasSubstr("goto second(1 h,\n   "));
  EXPECT_EQ(first[2].transition, GraphTransition::Call);
  EXPECT_EQ(first[2].target, 2U);
  EXPECT_EQ(of.states[2].cases.at(0).transition, GraphTransition::Return);
  EXPECT_EQ(of.states[3].cases.at(0).transition, GraphTransition::Exit);
  ASSERT_EQ(of.always.size(), 1U);
  EXPECT_EQ(of.always[0].transition, GraphTransition::Exit);
  EXPECT_EQ(of.always[0].guard, "depth > 50 m");
}

TEST_F(GraphOf, TellsArraysAndLoopsAsTheyAreWritten) {
  const report::Graph of = graph(
      "mission m\nvar a[3]: temperature = 0 degC\nvar n: number = 0 in 0 .. 2\nstate s\nbegin\n"
      "  flightprofile surfaced\n  sensors temp, missiontime\n  events\n"
      "    case temp > a[n] do push(a, temp) set a[n] = temp\n"
      "      for i in 0 .. 2 do set a[i] = temp log \"i\", i end set n = min(n + 1, 2) end stay\n"
      "    case missiontime > 1 h exit\nend\n");
  EXPECT_EQ(of.states.at(0).cases.at(0).action, "push, set a[n], set a[i], log, set n");
}

TEST_F(GraphOf, SaysWhyACaseNeverFires) {
  const report::Graph of =
      graph(kMission, {{{ir::StateId{0}, 1}, true}, {{ir::StateId{0}, 2}, false}});
  const auto& first = of.states.at(0).cases;
  EXPECT_EQ(first[0].never, "");
  EXPECT_EQ(first[1].never, "never fires: whenever its condition is true, an earlier case fires");
  EXPECT_EQ(first[2].never, "never fires: its condition cannot be true");
  EXPECT_EQ(of.states[1].cases.at(1).never, "never fires: its guard is always false");
  EXPECT_EQ(of.states[2].cases.at(1).never, "");
  EXPECT_EQ(of.states[2].cases.at(2).never,
            "never fires: an earlier case of the state always fires first");
  EXPECT_EQ(of.always.at(0).never, "");
}

TEST_F(GraphOf, SaysWhatIsNotReached) {
  const report::Graph plain = graph(kMission);
  EXPECT_TRUE(plain.states.at(0).reached && plain.states[1].reached && plain.states[2].reached);
  EXPECT_FALSE(plain.states[3].reached);
  EXPECT_FALSE(plain.states[3].led_to_in_vain) << "its guard is false as it stands";
  EXPECT_FALSE(plain.states[0].dead_end);
  const report::Graph proved = graph(kMission, {{{ir::StateId{0}, 2}, false}});
  EXPECT_FALSE(proved.states.at(2).reached);
  EXPECT_TRUE(proved.states[2].led_to_in_vain);
  EXPECT_TRUE(proved.states[1].reached);
}

}  // namespace
}  // namespace glider::analysis
