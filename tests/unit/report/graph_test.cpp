// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/graph.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

namespace glider::report {
namespace {

using testing::HasSubstr;
using testing::Not;

GraphCase caseOf(const char* guard, GraphTransition transition, uint32_t target = 0) {
  return {guard, "", guard, transition, target, ""};
}

/// Two states, one of them dead, and a case that never fires.
Graph small() {
  Graph graph;
  graph.mission = "a<b";
  graph.platform = "slocum";
  GraphState look;
  look.name = "look";
  look.profile = "yo(5 m, \"20\" m & more)";
  look.route = "noheading";
  look.cases = {caseOf("depth < 5 m", GraphTransition::Call, 1),
                caseOf("true", GraphTransition::Exit)};
  look.cases[0].never = "never fires: its guard is always false";
  GraphState lost;
  lost.name = "lost";
  lost.reached = false;
  lost.cases = {caseOf("temp > 3 degC", GraphTransition::Return)};
  graph.states = {look, lost};
  graph.deepest_path = {0};
  return graph;
}

TEST(Graph, TextIsEscapedInSvg) {
  const std::string svg = graphToSvg(small(), {});
  EXPECT_THAT(svg, HasSubstr("a&lt;b"));
  EXPECT_THAT(svg, HasSubstr("depth &lt; 5 m"));
  EXPECT_THAT(svg, HasSubstr("m &amp; more"));
  EXPECT_THAT(svg, Not(HasSubstr("a<b")));
}

TEST(Graph, DeadPartsAreMarked) {
  const std::string svg = graphToSvg(small(), {});
  EXPECT_THAT(svg, HasSubstr("class=\"unreached\""));
  EXPECT_THAT(svg, HasSubstr("nothing leads here"));
  EXPECT_THAT(svg, HasSubstr("(never fires: its guard is always false)"));
  EXPECT_THAT(svg, HasSubstr("class=\"line call lost\""));
  Graph alive = small();
  alive.states[0].cases[0].never.clear();
  alive.states[1].reached = true;
  EXPECT_THAT(graphToSvg(alive, {}), Not(HasSubstr("class=\"unreached\"")));
  EXPECT_THAT(graphToSvg(alive, {}), Not(HasSubstr("never fires")));
}

TEST(Graph, OnlyTheNumberOfACaseIsBold) {
  Graph graph = small();
  graph.states[0].profile =
      "thermotrackyo(5 m, 28 m, 26 deg, 26 deg)";  // a line begins with "26 deg"
  const std::string svg = graphToSvg(graph, {});
  EXPECT_THAT(svg, HasSubstr("<tspan class=\"number\">1</tspan>"));
  EXPECT_THAT(svg, Not(HasSubstr("<tspan class=\"number\">26</tspan>")));
}

TEST(Graph, NothingIsAskedFromElsewhere) {
  const std::string svg = graphToSvg(small(), {});
  EXPECT_THAT(svg, Not(HasSubstr("href")));
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  EXPECT_THAT(svg, Not(HasSubstr("@import")));
}

TEST(Graph, OddStatesAreDrawn) {
  Graph graph;
  graph.mission = "m";
  graph.states.resize(1);
  graph.states[0].name = std::string(300, 'x') + "\x01\xff";
  graph.states[0].cases = {caseOf("", GraphTransition::Goto, 0), caseOf("", GraphTransition::Stay)};
  graph.always = {caseOf(std::string(2000, 'y').c_str(), GraphTransition::Call, 0)};
  EXPECT_THAT(graphToSvg(graph, {true}), Not(HasSubstr("\x01")));
  EXPECT_THAT(graphToDot(graph, {}), HasSubstr("digraph"));
}

TEST(Graph, JsonHasThePartsUnderTheirNames) {
  const auto parsed = nlohmann::json::parse(graphToJson(small()));
  EXPECT_EQ(parsed.at("mission"), "a<b");
  EXPECT_EQ(parsed.at("states").size(), 2);
  EXPECT_EQ(parsed.at("states")[1].at("reached"), false);
  EXPECT_EQ(parsed.at("states")[0].at("cases")[0].at("target"), "lost");
  EXPECT_EQ(parsed.at("states")[0].at("cases")[0].at("never"),
            "never fires: its guard is always false");
  EXPECT_EQ(parsed.at("states")[0].at("cases")[1].at("transition"), "exit");
  EXPECT_FALSE(parsed.at("states")[0].at("cases")[1].contains("target"));
}

TEST(Graph, DotQuotesTexts) {
  EXPECT_THAT(graphToDot(small(), {}), HasSubstr("\\\"20\\\" m"));
}

}  // namespace
}  // namespace glider::report
