// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/svg_shapes.h"
#include "report/svg/text_lines.h"

#include <algorithm>

namespace glider::report {
namespace {

using diagram::Arrow;

constexpr double kRow = 30, kSample = 56, kBetween = 26;

/// An entry: a shape and its meaning.
struct Entry {
  Arrow arrow;
  const char* meaning;
  bool unreached = false;  ///< the shape is that of a state that is not reached
};

Arrow sample(GraphTransition transition, bool always = false, bool never = false) {
  return {.transition = transition, .always = always, .never = never, .lines = {}, .title = ""};
}

std::vector<Entry> entriesFor(const Graph& graph) {
  std::vector<Entry> entries;
  bool seen[5] = {}, never = false;
  auto look = [&](const std::vector<GraphCase>& cases) {
    for (const GraphCase& c : cases) {
      seen[static_cast<size_t>(c.transition)] = true;
      never = never || (!c.never.empty() && c.transition != GraphTransition::Stay);
    }
  };
  look(graph.always);
  for (const GraphState& state : graph.states) {
    look(state.cases);
  }
  if (seen[static_cast<size_t>(GraphTransition::Goto)]) {
    entries.push_back({sample(GraphTransition::Goto), "goto: does not return"});
  }
  if (seen[static_cast<size_t>(GraphTransition::Call)]) {
    entries.push_back({sample(GraphTransition::Call), "call: returns"});
  }
  if (seen[static_cast<size_t>(GraphTransition::Exit)]) {
    entries.push_back({sample(GraphTransition::Exit), "exit: the mission ends"});
  }
  if (!graph.always.empty()) {
    entries.push_back({sample(GraphTransition::Goto, true), "always: from any state"});
  }
  if (never) {
    entries.push_back({sample(GraphTransition::Goto, false, true), "never fires"});
  }
  if (!std::ranges::all_of(graph.states, &GraphState::reached)) {
    entries.push_back({{}, "never entered", true});
  }
  return entries;
}

void drawSample(SvgText& svg, const Arrow& arrow, Spot at) {
  const Page page(diagram::Direction::Right, at);
  const bool exit = arrow.transition == GraphTransition::Exit;
  const double length = exit ? kSample - 22 : kSample;
  const layered::PlacedEdge edge{{{{0, 0}, {length, 0}}}, {}};
  drawArrow(svg, arrow, edge, page);
  if (exit) {
    drawBox(svg, {}, {diagram::Shape::Exit, 0, {}, 24, 24, 0}, {at.x + kSample - 11, at.y});
  }
}

void drawUnreached(SvgText& svg, Spot at) {
  Graph graph;
  graph.states.emplace_back().source = "a state that is never entered";
  graph.states.front().reached = false;
  constexpr double kHeight = 18;
  drawBox(svg, graph, {diagram::Shape::State, 0, {}, kSample, kHeight, 0},
          {at.x + kSample / 2, at.y});
}

}  // namespace

double drawLegend(SvgText& svg, const Graph& graph, Spot at, double width) {
  Spot next = at;
  double height = kRow;
  for (const Entry& entry : entriesFor(graph)) {
    const double wide =
        kSample + 8 + diagram::kCharacter * static_cast<double>(columnsOf(entry.meaning));
    if (next.x > at.x && next.x + wide > at.x + width) {
      next = {at.x, next.y + kRow};
      height += kRow;
    }
    if (entry.unreached) {
      drawUnreached(svg, {next.x, next.y + kRow / 2});
    } else {
      drawSample(svg, entry.arrow, {next.x, next.y + kRow / 2});
    }
    svg.add("<text class=\"muted\" x=\"{}\" y=\"{}\">{}</text>\n", px(next.x + kSample + 8),
            px(next.y + kRow / 2 + 4), entry.meaning);
    next.x += wide + kBetween;
  }
  return height;
}

}  // namespace glider::report
