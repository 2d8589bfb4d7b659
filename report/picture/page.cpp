// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/page.h"

#include "report/svg/text_lines.h"

#include <cmath>

namespace glider::report::picture {
namespace {

/// Dark on white, on any background: the colours are chosen for it.
constexpr std::string_view kStyle = R"svg(<style>
text { font-family: "Helvetica Neue", Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif; fill: #1b2733 }
.title { font-size: 18px; font-weight: bold }
.label { font-size: 13px }
.tick { font-size: 12px }
.muted { font-size: 13px; fill: #566573 }
.halo { paint-order: stroke; stroke: #ffffff; stroke-width: 4px; stroke-linejoin: round }
path { fill: none; stroke-linejoin: round; stroke-linecap: butt }
.grid { stroke: #e6eaee; stroke-width: 1 }
.frame { fill: none; stroke: #1b2733; stroke-width: 1 }
.isotherm { stroke: #8fa6ba; stroke-width: 1 }
.marked { stroke: #1b2733; stroke-width: 1.5; stroke-dasharray: 5 3 }
.commanded { stroke: #1b2733; stroke-width: .9 }
.change { stroke: #566573; stroke-width: .8; stroke-dasharray: 1 3 }
.seabed { fill: #d9cdbd; stroke: #7d6c55; stroke-width: 1 }
.around { stroke: #ffffff; stroke-width: 3; stroke-opacity: .8 }
.track { stroke-width: 2.4; stroke-linecap: round }
.reckoned { stroke: #566573; stroke-width: 1; stroke-dasharray: 4 3 }
.waypoint { fill: #ffffff; stroke: #1b2733; stroke-width: 1.3 }
.mark { fill: #ffffff; stroke: #1b2733; stroke-width: 1.8 }
</style>
)svg";

}  // namespace

void beginPage(SvgText& svg, double width, double height, std::string_view title) {
  svg.add(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\">\n<title>{2}</title>\n",
      px(width), px(std::ceil(height)), toXml(title));
  svg.add(kStyle);
  svg.add("<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n");
}

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
