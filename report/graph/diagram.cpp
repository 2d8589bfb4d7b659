// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/diagram.h"

#include "report/svg/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace glider::report::diagram {
namespace {

constexpr size_t kBoxColumns = 34, kLabelColumns = 30, kMostLines = 3, kMostCases = 6;
constexpr double kPadding = 11, kLeastPort = 14;

double widthOf(const std::vector<Line>& lines) {
  double width = 0;
  for (const Line& line : lines) {
    const double character = line.style == Style::Name ? kNameCharacter : kCharacter;
    width = std::max(width, character * static_cast<double>(columnsOf(line.text)));
  }
  return width;
}

double heightOf(const std::vector<Line>& lines) {
  double height = 0;
  for (const Line& line : lines) {
    height += line.style == Style::Name ? kNameLine : kLine;
  }
  return height;
}

void addWrapped(std::vector<Line>& lines, const std::string& text, Style style,
                const std::string& first = "", size_t columns = kBoxColumns) {
  const std::string indent(columnsOf(first), ' ');
  for (const std::string& part : wrap(text, columns, kMostLines)) {
    const bool numbered = !first.empty() && lines.empty();
    lines.push_back({(numbered ? first : indent) + part, style, numbered});
  }
}

class DiagramMaker {
 public:
  DiagramMaker(const Graph& graph, const GraphStyle& style) : graph_(graph), style_(style) {
    for (uint32_t s = 0; s < graph_.states.size(); ++s) {
      made_.boxes.push_back(boxOf(s));
    }
    for (uint32_t s = 0; s < graph_.states.size(); ++s) {
      arrowsOf(s, graph_.states[s].cases, false);
    }
    if (!graph_.always.empty()) {
      Box box{.shape = Shape::Always, .lines = {{"always", Style::Name}}};
      addWrapped(box.lines, "in every state, before its own cases", Style::Muted, "", 20);
      addStays(box, graph_.always);
      const auto number = add(std::move(box));
      arrowsOf(number, graph_.always, true);
    }
    grow();
  }

  Diagram take() { return std::move(made_); }

 private:
  uint32_t add(Box box) {
    box.width = widthOf(box.lines) + 2 * kPadding;
    box.height = heightOf(box.lines) + kPadding;
    made_.boxes.push_back(std::move(box));
    return static_cast<uint32_t>(made_.boxes.size() - 1);
  }

  Box boxOf(uint32_t number) {
    const GraphState& state = graph_.states[number];
    Box box{.shape = Shape::State, .state = number, .lines = {{state.name, Style::Name}}};
    if (!state.parameters.empty()) {
      addWrapped(box.lines, "(" + state.parameters + ")", Style::Text);
    }
    addWrapped(box.lines, state.profile, Style::Text);
    if (state.route != "noheading") {
      addWrapped(box.lines, state.route, Style::Text);
    }
    addStays(box, state.cases);
    if (!state.reached) {
      box.lines.push_back(
          {state.led_to_in_vain ? "✗ only cases that never fire lead here" : "✗ nothing leads here",
           Style::Never});
    } else if (state.dead_end) {
      box.lines.push_back({"✗ nothing leaves", Style::Never});
    }
    const auto on_path = std::ranges::find(graph_.deepest_path, number);
    if (style_.deepest && graph_.deepest_path.size() > 1 && on_path != graph_.deepest_path.end()) {
      box.depth = static_cast<uint32_t>(on_path - graph_.deepest_path.begin()) + 1;
    }
    box.width = std::max(widthOf(box.lines) + 2 * kPadding, 90.0);
    box.height = heightOf(box.lines) + kPadding;
    return box;
  }

  /// A case that stays leads nowhere: it is written in the box.
  static void addStays(Box& box, const std::vector<GraphCase>& cases) {
    for (size_t i = 0; i < cases.size(); ++i) {
      if (cases[i].transition == GraphTransition::Stay) {
        const Style style = cases[i].never.empty() ? Style::Muted : Style::Never;
        std::vector<Line> lines;
        addWrapped(lines, "stay: " + told(cases[i]), style, fmt::format("{} ", i + 1),
                   kBoxColumns - 2);
        box.lines.insert(box.lines.end(), lines.begin(), lines.end());
      }
    }
  }

  static std::string told(const GraphCase& c) {
    return c.guard + (c.action.empty() ? "" : " / " + c.action);
  }

  void arrowsOf(uint32_t from, const std::vector<GraphCase>& cases, bool always) {
    std::vector<Arrow> arrows;
    std::vector<std::vector<size_t>> numbers;
    for (size_t i = 0; i < cases.size(); ++i) {
      const GraphCase& c = cases[i];
      if (c.transition == GraphTransition::Stay) {
        continue;
      }
      const bool targeted =
          c.transition == GraphTransition::Goto || c.transition == GraphTransition::Call;
      auto same = [&](const Arrow& a) {
        return a.transition == c.transition && a.never != c.never.empty() &&
               (!targeted || a.to == c.target);
      };
      const auto found = std::ranges::find_if(arrows, same);
      if (found != arrows.end()) {
        numbers[static_cast<size_t>(found - arrows.begin())].push_back(i);
      } else {
        arrows.push_back(
            {from, c.target, c.transition, always, !c.never.empty(), false, {}, "", 0, 0});
        numbers.push_back({i});
      }
    }
    for (size_t i = 0; i < arrows.size(); ++i) {
      finish(std::move(arrows[i]), cases, numbers[i]);
    }
  }

  void finish(Arrow arrow, const std::vector<GraphCase>& cases,
              const std::vector<size_t>& numbers) {
    for (size_t k = 0; k < numbers.size(); ++k) {
      const GraphCase& c = cases[numbers[k]];
      arrow.title +=
          (k == 0 ? "" : "\n") + c.source + (c.never.empty() ? "" : "\n(" + c.never + ")");
      if (k < kMostCases) {
        std::vector<Line> lines;
        addWrapped(lines, told(c), arrow.never ? Style::Never : Style::Text,
                   fmt::format("{} ", numbers[k] + 1), kLabelColumns);
        arrow.lines.insert(arrow.lines.end(), lines.begin(), lines.end());
      }
    }
    if (numbers.size() > kMostCases) {
      arrow.lines.push_back(
          {fmt::format("… and {} more", numbers.size() - kMostCases), Style::Muted});
    }
    arrow.width = widthOf(arrow.lines) + 10;
    arrow.height = heightOf(arrow.lines) + 4;
    if (arrow.transition == GraphTransition::Exit) {
      arrow.to = terminal(Shape::Exit, 24, 24);
    } else if (arrow.transition == GraphTransition::Return) {
      arrow.to = terminal(Shape::Return, 66, 24);
    }
    arrow.deepest = callsOnDeepest(arrow);
    if (arrow.deepest) {  // its line is thick
      arrow.width += kThick;
      arrow.height += kThick;
    }
    (arrow.from == arrow.to ? made_.loops : made_.arrows).push_back(std::move(arrow));
  }

  uint32_t terminal(Shape shape, double width, double height) {
    made_.boxes.push_back({shape, 0, {}, width, height, 0});
    return static_cast<uint32_t>(made_.boxes.size() - 1);
  }

  /// Whether the arrow is a call between two neighbours on the deepest stack.
  [[nodiscard]] bool callsOnDeepest(const Arrow& arrow) const {
    if (arrow.transition != GraphTransition::Call || arrow.never) {
      return false;
    }
    const uint32_t depth = made_.boxes[arrow.to].depth;
    return depth > 1 && (arrow.always || made_.boxes[arrow.from].depth == depth - 1);
  }

  /// Makes boxes large enough for the arrows that meet them on one side.
  void grow() {
    std::vector<double> out(made_.boxes.size()), in(made_.boxes.size());
    for (const Arrow& arrow : made_.arrows) {
      out[arrow.from] += kLeastPort;
      in[arrow.to] += kLeastPort;
    }
    for (size_t i = 0; i < made_.boxes.size(); ++i) {
      const double least = out[i] + in[i] > 2 * kLeastPort ? std::max(out[i], in[i]) + kPadding : 0;
      made_.boxes[i].height = std::max(made_.boxes[i].height, least);
      made_.boxes[i].width = std::max(made_.boxes[i].width, least);
    }
  }

  const Graph& graph_;
  const GraphStyle& style_;
  Diagram made_;
};

}  // namespace

Diagram diagramOf(const Graph& graph, const GraphStyle& style) {
  return DiagramMaker(graph, style).take();
}

layered::Drawing place(const Diagram& diagram, Direction direction) {
  const bool right = direction == Direction::Right;
  auto turned = [&](double width, double height) {
    return right ? layered::Size{width, height} : layered::Size{height, width};
  };
  std::vector<layered::Node> nodes;
  for (const Box& box : diagram.boxes) {
    nodes.push_back({turned(box.width, box.height), 0});
  }
  for (const Arrow& loop : diagram.loops) {
    const double space = right ? loop.height + kLoopHeight : loop.width + kLoopHeight;
    nodes[loop.from].before += space;
    nodes[loop.from].size.across += space;
    if (right) {
      nodes[loop.from].size.along = std::max(nodes[loop.from].size.along, loop.width);
    }
  }
  std::vector<layered::Edge> edges;
  for (const Arrow& arrow : diagram.arrows) {
    edges.push_back({arrow.from, arrow.to, turned(arrow.width, arrow.height),
                     right ? arrow.height / 2 - 1 : 3 - arrow.width / 2});
  }
  return layered::layOut(nodes, edges);
}

}  // namespace glider::report::diagram
