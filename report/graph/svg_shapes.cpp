// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/svg_shapes.h"

#include "report/svg/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace glider::report {
namespace {

using diagram::Arrow;
using diagram::Box;
using diagram::Direction;
using diagram::Line;
using diagram::Shape;
using diagram::Style;

constexpr double kHead = 10, kHeadWidth = 4.6;

std::string classOf(const Line& line) {
  switch (line.style) {
    case Style::Name:
      return " class=\"name\"";
    case Style::Muted:
      return " class=\"muted\"";
    case Style::Never:
      return line.text.starts_with("✗") ? " class=\"note\"" : " class=\"never\"";
    case Style::Text:
      return "";
  }
  return "";
}

std::string classesOf(const Arrow& arrow) {
  std::string classes = "line";
  classes += arrow.transition == GraphTransition::Call ? " call" : "";
  classes += arrow.always ? " interrupt" : "";
  classes += arrow.never ? " lost" : "";
  classes += arrow.deepest ? " deep" : "";
  return classes;
}

/// A line, or for a call two parallel lines.
void drawPath(SvgText& svg, const Arrow& arrow, const std::string& path) {
  svg.add("<path class=\"{}\" d=\"{}\"/>\n", classesOf(arrow), path);
  if (arrow.transition == GraphTransition::Call) {
    svg.add("<path class=\"core\" d=\"{}\"/>\n", path);
  }
}

/// A head whose tip is at `tip`; it points along (dx, dy), one of the four directions.
void drawHead(SvgText& svg, Spot tip, double dx, double dy, double size = 1) {
  const double length = kHead * size, width = kHeadWidth * size;
  svg.add("<path class=\"head\" d=\"M{} {}L{} {}L{} {}Z\"/>\n", px(tip.x), px(tip.y),
          px(tip.x - dx * length - dy * width), px(tip.y - dy * length - dx * width),
          px(tip.x - dx * length + dy * width), px(tip.y - dy * length + dx * width));
}

double headSize(const Arrow& arrow) {
  return arrow.deepest ? 1.7 : arrow.transition == GraphTransition::Call ? 1.25 : 1;
}

/// Straight stretches joined by curves that begin and end along.
std::string pathOf(const std::vector<layered::Stretch>& stretches, const Page& page) {
  std::string path;
  for (size_t i = 0; i < stretches.size(); ++i) {
    const Spot from = page.at(stretches[i].from), to = page.at(stretches[i].to);
    if (i == 0) {
      path += fmt::format("M{} {}", px(from.x), px(from.y));
    } else {
      const layered::Point before = stretches[i - 1].to, after = stretches[i].from;
      const double middle = (before.along + after.along) / 2;
      const Spot a = page.at({middle, before.across}), b = page.at({middle, after.across});
      path += fmt::format("C{} {} {} {} {} {}", px(a.x), px(a.y), px(b.x), px(b.y), px(from.x),
                          px(from.y));
    }
    path += fmt::format("L{} {}", px(to.x), px(to.y));
  }
  return path;
}

}  // namespace

void drawLines(SvgText& svg, const std::vector<Line>& lines, Spot at) {
  double y = at.y;
  for (const Line& line : lines) {
    y += line.style == Style::Name ? diagram::kNameLine : diagram::kLine;
    svg.add("<text x=\"{}\" y=\"{}\"{}>", px(at.x), px(y - 4), classOf(line));
    if (line.numbered) {
      const size_t digits = line.text.find(' ');
      svg.add("<tspan class=\"number\">{}</tspan>{}", line.text.substr(0, digits),
              toXml(line.text.substr(digits)));
    } else {
      svg.add(toXml(line.text));
    }
    svg.add("</text>\n");
  }
}

void drawArrow(SvgText& svg, const Arrow& arrow, const layered::PlacedEdge& edge,
               const Page& page) {
  std::vector<layered::Stretch> stretches = edge.stretches;
  const double forwards = stretches.back().to.along > stretches.front().from.along ? 1 : -1;
  const layered::Point tip = stretches.back().to;
  layered::Stretch& last = stretches.back();
  last.to.along -= forwards * (kHead - 1) * headSize(arrow);
  last.from.along = forwards > 0 ? std::min(last.from.along, last.to.along)
                                 : std::max(last.from.along, last.to.along);
  svg.add("<g><title>{}</title>\n", toXml(arrow.title));
  drawPath(svg, arrow, pathOf(stretches, page));
  const bool right = page.direction() == Direction::Right;
  drawHead(svg, page.at(tip), right ? forwards : 0, right ? 0 : forwards, headSize(arrow));
  const Spot label = page.at(edge.label);
  const double beside = right ? 5 : arrow.deepest ? 9 + diagram::kThick : 9;
  drawLines(svg, arrow.lines, {label.x - arrow.width / 2 + beside, label.y - arrow.height / 2});
  svg.add("</g>\n");
}

void drawLoop(SvgText& svg, const Arrow& loop, const Box& box, Spot middle, const Page& page) {
  svg.add("<g><title>{}</title>\n", toXml(loop.title));
  const double r = diagram::kLoopHeight;
  if (page.direction() == Direction::Right) {
    const double top = middle.y - box.height / 2;
    drawPath(svg, loop,
             fmt::format("M{0} {1}C{2} {3} {4} {3} {5} {6}", px(middle.x + 16), px(top),
                         px(middle.x + 34), px(top - 1.25 * r), px(middle.x - 34),
                         px(middle.x - 16), px(top - kHead + 1)));
    drawHead(svg, {middle.x - 16, top}, 0, 1, headSize(loop));
    drawLines(svg, loop.lines, {middle.x - loop.width / 2 + 5, top - r - loop.height + 2});
  } else {
    const double left = middle.x - box.width / 2;
    drawPath(svg, loop,
             fmt::format("M{0} {1}C{2} {3} {2} {4} {5} {6}", px(left), px(middle.y - 12),
                         px(left - 1.25 * r), px(middle.y - 26), px(middle.y + 26),
                         px(left - kHead + 1), px(middle.y + 12)));
    drawHead(svg, {left, middle.y + 12}, 1, 0, headSize(loop));
    drawLines(svg, loop.lines, {left - r - loop.width + 5, middle.y - loop.height / 2});
  }
  svg.add("</g>\n");
}

void drawBox(SvgText& svg, const Graph& graph, const Box& box, Spot middle) {
  const double left = middle.x - box.width / 2, top = middle.y - box.height / 2;
  if (box.shape == Shape::Exit) {
    svg.add(
        "<g><title>exit: the mission ends</title><circle class=\"end\" cx=\"{0}\" cy=\"{1}\" "
        "r=\"11\"/>"
        "<circle class=\"head\" cx=\"{0}\" cy=\"{1}\" r=\"6\"/></g>\n",
        px(middle.x), px(middle.y));
    return;
  }
  if (box.shape == Shape::Return) {
    svg.add(
        "<g><title>return: back to the state that called</title><rect class=\"end\" x=\"{}\" "
        "y=\"{}\" width=\"{}\" "
        "height=\"{}\" rx=\"12\"/><text x=\"{}\" y=\"{}\" "
        "text-anchor=\"middle\">return</text></g>\n",
        px(left), px(top), px(box.width), px(box.height), px(middle.x), px(middle.y + 4));
    return;
  }
  const bool state = box.shape == Shape::State;
  const bool reached = !state || graph.states[box.state].reached;
  svg.add("<g><title>{}</title>\n",
          state ? toXml(graph.states[box.state].source) : "always: tried in every state");
  svg.add("<rect class=\"{}{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"8\"/>\n",
          !reached ? "unreached"
          : state  ? "box"
                   : "always",
          box.depth > 0 ? " deepest" : "", px(left), px(top), px(box.width), px(box.height));
  double text_height = 0;
  for (const Line& line : box.lines) {
    text_height += line.style == Style::Name ? diagram::kNameLine : diagram::kLine;
  }
  drawLines(svg, box.lines, {left + 11, middle.y - text_height / 2 - 1});
  if (box.depth > 0) {
    svg.add(
        "<circle class=\"head\" cx=\"{0}\" cy=\"{1}\" r=\"11\"/><text class=\"number\" x=\"{0}\" "
        "y=\"{2}\" "
        "text-anchor=\"middle\" style=\"fill: #ffffff\">{3}</text>\n",
        px(left + box.width), px(top), px(top + 4), box.depth);
  }
  svg.add("</g>\n");
}

}  // namespace glider::report
