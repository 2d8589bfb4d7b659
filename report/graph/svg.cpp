// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/svg_shapes.h"
#include "report/graph/svg_style.h"
#include "report/svg/text_lines.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::report {
namespace {

using diagram::Direction;

constexpr double kMargin = 28, kHeadline = 64, kStart = 36;
constexpr double kLeastWidth = 460;

/// The largest scale of the drawing on a landscape sheet of A3.
double scaleOnSheet(layered::Size size, Direction direction) {
  constexpr double kLong = 420, kShort = 297;
  const bool right = direction == Direction::Right;
  const double width = right ? size.along : size.across;
  const double height = right ? size.across : size.along;
  return std::min(kLong / (width + 2 * kMargin + kStart), kShort / (height + kHeadline + 60));
}

std::string headlineOf(const Graph& graph) {
  std::string text =
      fmt::format("{} state{}", graph.states.size(), graph.states.size() == 1 ? "" : "s");
  if (graph.deepest_path.size() > 1) {
    text += fmt::format(", greatest call depth {}:", graph.deepest_path.size() - 1);
    for (size_t i = 0; i < graph.deepest_path.size(); ++i) {
      text += (i == 0 ? " " : " calls ") + graph.states[graph.deepest_path[i]].name;
    }
  }
  return text;
}

/// The dot where the mission starts, with an arrow to the first state.
void drawStart(SvgText& svg, const diagram::Box& box, Spot middle, Direction direction) {
  const bool right = direction == Direction::Right;
  const double edge = right ? middle.x - box.width / 2 : middle.y - box.height / 2;
  const double dot = edge - kStart + 7;
  const auto spot = [&](double along) {
    return right ? Spot{along, middle.y} : Spot{middle.x, along};
  };
  svg.add(
      "<g><title>the mission starts here</title><circle class=\"head\" cx=\"{}\" cy=\"{}\" "
      "r=\"7\"/>",
      px(spot(dot).x), px(spot(dot).y));
  svg.add("<path class=\"line\" d=\"M{} {}L{} {}\"/>", px(spot(dot).x), px(spot(dot).y),
          px(spot(edge - 9).x), px(spot(edge - 9).y));
  const Spot tip = spot(edge), a = spot(edge - 10);
  const double dx = right ? 0 : 4.6, dy = right ? 4.6 : 0;
  svg.add("<path class=\"head\" d=\"M{} {}L{} {}L{} {}Z\"/></g>\n", px(tip.x), px(tip.y),
          px(a.x + dx), px(a.y + dy), px(a.x - dx), px(a.y - dy));
}

class Picture {
 public:
  Picture(const Graph& graph, const GraphStyle& style)
      : graph_(graph), diagram_(diagram::diagramOf(graph, style)) {
    layered::Drawing right = diagram::place(diagram_, Direction::Right);
    layered::Drawing down = diagram::place(diagram_, Direction::Down);
    const bool choose_right =
        scaleOnSheet(right.size, Direction::Right) >= scaleOnSheet(down.size, Direction::Down);
    direction_ = choose_right ? Direction::Right : Direction::Down;
    drawing_ = choose_right ? std::move(right) : std::move(down);
  }

  std::string draw() {
    const bool right = direction_ == Direction::Right;
    const layered::Size size = drawing_.size;
    const double wide = (right ? size.along + kStart : size.across) + 2 * kMargin;
    const double high = right ? size.across : size.along + kStart;
    const std::string headline = headlineOf(graph_);
    const double text = diagram::kCharacter * static_cast<double>(columnsOf(headline));
    const double width = std::max({wide, kLeastWidth, text + 2 * kMargin});
    const Page page(direction_, {kMargin + (right ? kStart : 0) + (width - wide) / 2,
                                 kHeadline + (right ? 0 : kStart)});
    SvgText body;
    boxesAndArrows(body, page);
    const double legend_top = kHeadline + high + 18;
    const double legend = drawLegend(body, graph_, {kMargin, legend_top}, width - 2 * kMargin);
    const double height = legend_top + legend + 8;
    SvgText svg;
    svg.add(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\">\n<title>{2}</title>\n",
        px(std::ceil(width)), px(std::ceil(height)), toXml("mission " + graph_.mission));
    svg.add(kSvgStyle);
    svg.add("<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n");
    svg.add("<text class=\"title\" x=\"{}\" y=\"30\">{}</text>\n", px(kMargin),
            toXml(graph_.mission));
    svg.add("<text class=\"muted\" x=\"{}\" y=\"50\">{}</text>\n", px(kMargin), toXml(headline));
    svg.add(body.take());
    svg.add("</svg>\n");
    return svg.take();
  }

 private:
  /// The middle of a box; the space for loops is on one side of it.
  [[nodiscard]] Spot middleOf(uint32_t box, const Page& page) const {
    layered::Point point = drawing_.nodes[box];
    for (const diagram::Arrow& loop : diagram_.loops) {
      const bool right = page.direction() == Direction::Right;
      if (loop.from == box) {
        point.across += ((right ? loop.height : loop.width) + diagram::kLoopHeight) / 2;
      }
    }
    return page.at(point);
  }

  void boxesAndArrows(SvgText& svg, const Page& page) {
    for (size_t i = 0; i < diagram_.arrows.size(); ++i) {
      drawArrow(svg, diagram_.arrows[i], drawing_.edges[i], page);
    }
    for (const diagram::Arrow& loop : diagram_.loops) {
      drawLoop(svg, loop, diagram_.boxes[loop.from], middleOf(loop.from, page), page);
    }
    for (uint32_t i = 0; i < diagram_.boxes.size(); ++i) {
      drawBox(svg, graph_, diagram_.boxes[i], middleOf(i, page));
    }
    if (!diagram_.boxes.empty()) {
      drawStart(svg, diagram_.boxes[0], middleOf(0, page), direction_);
    }
  }

  const Graph& graph_;
  diagram::Diagram diagram_;
  Direction direction_ = Direction::Right;
  layered::Drawing drawing_;
};

}  // namespace

std::string graphToSvg(const Graph& graph, const GraphStyle& style) {
  return Picture(graph, style).draw();
}

}  // namespace glider::report
