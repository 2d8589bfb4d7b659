// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/graph/graph.h"
#include "report/graph/layered.h"

#include <cstdint>
#include <string>
#include <vector>

/// The elements of a graph that are drawn, and their sizes; in pixels.
namespace glider::report::diagram {

/// Characters have equal widths, so that sizes do not depend on a machine's fonts.
constexpr double kCharacter = 7.23, kNameCharacter = 9.03, kLine = 16, kNameLine = 21;

enum class Style : uint8_t { Name, Text, Muted, Never };
struct Line {
  std::string text;
  Style style = Style::Text;
  bool numbered = false;  ///< begins with the number of a case
};

enum class Shape : uint8_t { State, Always, Exit, Return };

struct Box {
  Shape shape = Shape::State;
  uint32_t state = 0;
  std::vector<Line> lines;
  double width = 0;
  double height = 0;
  uint32_t depth = 0;  ///< place on the deepest stack, from 1; 0: none, or not to be shown
};

/// Cases that lead from one box to another in the same way, in one arrow. The space for an arrow
/// from a box to itself is above the box.
struct Arrow {
  uint32_t from = 0;
  uint32_t to = 0;
  GraphTransition transition = GraphTransition::Goto;
  bool always = false;
  bool never = false;
  bool deepest = false;
  std::vector<Line> lines;
  std::string title;
  double width = 0;
  double height = 0;
};

struct Diagram {
  std::vector<Box> boxes;     ///< the states first, by number
  std::vector<Arrow> arrows;  ///< between different boxes
  std::vector<Arrow> loops;
};

Diagram diagramOf(const Graph& graph, const GraphStyle& style);

/// The direction in which the layers follow each other.
enum class Direction : uint8_t { Right, Down };

constexpr double kLoopHeight = 22;  ///< of a loop without its text
constexpr double kThick = 5;        ///< how much thicker a call on the deepest stack is

layered::Drawing place(const Diagram& diagram, Direction direction);

}  // namespace glider::report::diagram
