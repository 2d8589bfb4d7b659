// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/graph/diagram.h"
#include "report/svg/svg_text.h"

namespace glider::report {

/// Where a point of the drawing lies on the page.
struct Spot {
  double x = 0;
  double y = 0;
};

/// Turns along and across into right and down.
class Page {
 public:
  Page(diagram::Direction direction, Spot origin) : direction_(direction), origin_(origin) {}

  [[nodiscard]] Spot at(layered::Point point) const {
    const bool right = direction_ == diagram::Direction::Right;
    return {origin_.x + (right ? point.along : point.across),
            origin_.y + (right ? point.across : point.along)};
  }
  [[nodiscard]] diagram::Direction direction() const { return direction_; }

 private:
  diagram::Direction direction_;
  Spot origin_;
};

/// Lines of text, the first one's top left corner at `at`. A number that leads a line is bold.
void drawLines(SvgText& svg, const std::vector<diagram::Line>& lines, Spot at);
/// An arrow's line and head along an edge's stretches.
void drawArrow(SvgText& svg, const diagram::Arrow& arrow, const layered::PlacedEdge& edge,
               const Page& page);
/// The same for an arrow from a box to itself; `box` stands around `middle`.
void drawLoop(SvgText& svg, const diagram::Arrow& loop, const diagram::Box& box, Spot middle,
              const Page& page);
/// A box with its text around `middle`.
void drawBox(SvgText& svg, const Graph& graph, const diagram::Box& box, Spot middle);
/// Samples of all forms with their meaning, from `at` on in lines of at most `width`; the height.
double drawLegend(SvgText& svg, const Graph& graph, Spot at, double width);

}  // namespace glider::report
