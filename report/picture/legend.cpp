// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/legend.h"

namespace glider::report::picture {
namespace {

constexpr double kSample = 22, kGap = 7, kBetween = 20, kLine = 21;

void drawSample(SvgText& svg, const LegendEntry& entry, Dot at) {
  if (entry.classes == "waypoint") {
    drawDiamond(svg, {at.x + kSample / 2, at.y});
    return;
  }
  if (entry.colour.empty()) {
    addPath(svg, entry.classes, {{{at.x, at.y}, {at.x + kSample, at.y}}});
    return;
  }
  svg.add("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"11\" fill=\"{}\"/>\n",
          entry.classes, px(at.x), px(at.y - 5.5), px(kSample), entry.colour);
}

}  // namespace

void drawDiamond(SvgText& svg, Dot middle) {
  svg.add("<path class=\"waypoint\" d=\"M{} {}l5.5 5.5-5.5 5.5-5.5-5.5z\"/>\n", px(middle.x),
          px(middle.y - 5.5));
}

double drawLegend(SvgText& svg, const std::vector<LegendEntry>& entries, Dot at, double width) {
  double x = at.x, y = at.y;
  for (const LegendEntry& entry : entries) {
    const double wide = kSample + kGap + textWidth(entry.text, kLabelFont);
    if (x > at.x && x + wide > at.x + width) {
      x = at.x;
      y += kLine;
    }
    drawSample(svg, entry, {x, y});
    addText(svg, {x + kSample + kGap, y + 4.5}, "start", "label", entry.text);
    x += wide + kBetween;
  }
  return entries.empty() ? 0 : y - at.y + kLine;
}

}  // namespace glider::report::picture
