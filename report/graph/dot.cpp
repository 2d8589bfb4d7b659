// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/diagram.h"
#include "report/svg/text_lines.h"

#include <fmt/format.h>

namespace glider::report {
namespace {

using diagram::Arrow;
using diagram::Box;
using diagram::Shape;

/// Text in quotes as Graphviz reads it, each line to the left.
std::string quoted(const std::vector<diagram::Line>& lines) {
  std::string text = "\"";
  for (const diagram::Line& line : lines) {
    for (const char c : line.text) {
      text += c == '"' || c == '\\'                 ? std::string("\\") + c
              : static_cast<unsigned char>(c) < ' ' ? std::string("?")
                                                    : std::string(1, c);
    }
    text += "\\l";
  }
  return text + '"';
}

std::string attributesOf(const Graph& graph, const Box& box) {
  switch (box.shape) {
    case Shape::Exit:
      return "shape=doublecircle, label=\"\", width=0.15, style=filled, fillcolor=black";
    case Shape::Return:
      return "shape=box, style=rounded, label=\"return\"";
    case Shape::Always:
      return "shape=box, style=dashed, label=" + quoted(box.lines);
    case Shape::State:
      break;
  }
  const bool reached = graph.states[box.state].reached;
  return fmt::format("shape=box, style=\"rounded{}\", penwidth={}, label={}",
                     reached ? "" : ",dotted", box.depth > 0 ? 3 : 1, quoted(box.lines));
}

std::string attributesOf(const Arrow& arrow) {
  std::string text = "label=" + quoted(arrow.lines);
  text += arrow.transition == GraphTransition::Call ? ", color=\"black:invis:black\"" : "";
  text += arrow.never ? ", style=dotted" : arrow.always ? ", style=dashed" : "";
  text += arrow.deepest ? ", penwidth=3" : "";
  return text;
}

}  // namespace

std::string graphToDot(const Graph& graph, const GraphStyle& style) {
  const diagram::Diagram d = diagram::diagramOf(graph, style);
  std::string text =
      fmt::format("digraph {} {{\n  node [fontname=monospace];\n  edge [fontname=monospace];\n",
                  quoted({{graph.mission}}));
  for (size_t i = 0; i < d.boxes.size(); ++i) {
    text += fmt::format("  b{} [{}];\n", i, attributesOf(graph, d.boxes[i]));
  }
  if (!d.boxes.empty()) {
    text += "  start [shape=point, width=0.15];\n  start -> b0;\n";
  }
  for (const std::vector<Arrow>* arrows : {&d.arrows, &d.loops}) {
    for (const Arrow& arrow : *arrows) {
      text += fmt::format("  b{} -> b{} [{}];\n", arrow.from, arrow.to, attributesOf(arrow));
    }
  }
  return text + "}\n";
}

}  // namespace glider::report
