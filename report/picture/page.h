// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/picture/axis.h"
#include "report/picture/polyline.h"
#include "report/svg/svg_text.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace glider::report::picture {

/// A rectangle of the page, px.
struct Box {
  double left, top, right, bottom;
  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
};

/// Begins an SVG of that size, dark on white, with the style of all pictures. `title`: plain text.
void beginPage(SvgText& svg, double width, double height, std::string_view title);

inline constexpr double kTickFont = 12, kLabelFont = 13;

/// The approximate width of `text`, overestimated: the reader's fonts are not known.
double textWidth(std::string_view text, double font_px);

/// Text with its reference point at `at`. `anchor` is start, middle or end; `classes` as in the
/// style.
void addText(SvgText& svg, Dot at, std::string_view anchor, std::string_view classes,
             std::string_view text);
/// The same, rotated to read upwards, with its middle at `at`.
void addUpwards(SvgText& svg, Dot at, std::string_view classes, std::string_view text);
/// One path of class `classes` over all `lines`; nothing if none has two points.
void addPath(SvgText& svg, std::string_view classes, const std::vector<Line>& lines);
/// Lines by their colour.
using ColouredLines = std::map<std::string, std::vector<Line>>;
/// A path of class `classes` for each colour.
void addPaths(SvgText& svg, std::string_view classes, const ColouredLines& by_colour);
/// A grid line and a number at each tick below `box`, and the axis' title below them.
void addAcross(SvgText& svg, const Box& box, const Axis& axis, double step, std::string_view title);
/// The same at the left of `box`.
void addUp(SvgText& svg, const Box& box, const Axis& axis, double step, std::string_view title);
/// The border of `box`.
void addFrame(SvgText& svg, const Box& box);

}  // namespace glider::report::picture
