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

/// Converts along and across to right and down.
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

/// Lines of text; the top left corner of the first is at `at`. A leading number is bold.
void drawLines(SvgText& svg, const std::vector<diagram::Line>& lines, Spot at);
/// An arrow's line and head along an edge's stretches.
void drawArrow(SvgText& svg, const diagram::Arrow& arrow, const layered::PlacedEdge& edge,
               const Page& page);
/// The same for an arrow from a box to itself; the middle of `box` is at `middle`.
void drawLoop(SvgText& svg, const diagram::Arrow& loop, const diagram::Box& box, Spot middle,
              const Page& page);
/// A box with its text around `middle`.
void drawBox(SvgText& svg, const Graph& graph, const diagram::Box& box, Spot middle);
/// Draws samples of all shapes with their meaning, from `at` on in lines of at most `width`;
/// returns the height.
double drawLegend(SvgText& svg, const Graph& graph, Spot at, double width);

}  // namespace glider::report
