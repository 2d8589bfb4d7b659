// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/page.h"

#include "report/svg/text_lines.h"

namespace glider::report::picture {

double textWidth(std::string_view text, double font_px) {
  constexpr double kWide = 0.58;  // of the font's size; most letters are narrower
  return kWide * font_px * static_cast<double>(columnsOf(text));
}

void addText(SvgText& svg, Dot at, std::string_view anchor, std::string_view classes,
             std::string_view text) {
  svg.add("<text class=\"{}\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", classes, px(at.x),
          px(at.y), anchor, toXml(text));
}

void addUpwards(SvgText& svg, Dot at, std::string_view classes, std::string_view text) {
  svg.add(
      "<text class=\"{0}\" x=\"{1}\" y=\"{2}\" text-anchor=\"middle\" "
      "transform=\"rotate(-90 {1} {2})\">{3}</text>\n",
      classes, px(at.x), px(at.y), toXml(text));
}

namespace {

std::string dataOf(const std::vector<Line>& lines) {
  std::string data;
  for (const Line& line : lines) {
    data += pathData(line);
  }
  return data;
}

}  // namespace

void addPath(SvgText& svg, std::string_view classes, const std::vector<Line>& lines) {
  if (const std::string data = dataOf(lines); !data.empty()) {
    svg.add("<path class=\"{}\" d=\"{}\"/>\n", classes, data);
  }
}

void addPaths(SvgText& svg, std::string_view classes, const ColouredLines& by_colour) {
  for (const auto& [colour, lines] : by_colour) {
    if (const std::string data = dataOf(lines); !data.empty()) {
      svg.add("<path class=\"{}\" stroke=\"{}\" d=\"{}\"/>\n", classes, colour, data);
    }
  }
}

void addAcross(SvgText& svg, const Box& box, const Axis& axis, double step,
               std::string_view title) {
  std::vector<Line> grid;
  for (const double value : ticks(axis.from(), axis.to(), step)) {
    const double x = axis.at(value);
    grid.push_back({{x, box.top}, {x, box.bottom}});
    addText(svg, {x, box.bottom + 17}, "middle", "tick", tickText(value, step));
  }
  addPath(svg, "grid", grid);
  addText(svg, {(box.left + box.right) / 2, box.bottom + 37}, "middle", "label", title);
}

void addUp(SvgText& svg, const Box& box, const Axis& axis, double step, std::string_view title) {
  std::vector<Line> grid;
  const bool down = axis.from() > axis.to();
  double widest = 0;
  for (const double value :
       ticks(down ? axis.to() : axis.from(), down ? axis.from() : axis.to(), step)) {
    const double y = axis.at(value);
    grid.push_back({{box.left, y}, {box.right, y}});
    const std::string text = tickText(value, step);
    addText(svg, {box.left - 7, y + 4}, "end", "tick", text);
    widest = std::max(widest, textWidth(text, kTickFont));
  }
  addPath(svg, "grid", grid);
  addUpwards(svg, {box.left - 18 - widest, (box.top + box.bottom) / 2}, "label", title);
}

void addFrame(SvgText& svg, const Box& box) {
  svg.add("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", px(box.left),
          px(box.top), px(box.width()), px(box.height()));
}

}  // namespace glider::report::picture
