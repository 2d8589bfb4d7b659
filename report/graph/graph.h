// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// The state machine of a mission as a picture or as data.
namespace glider::report {

enum class GraphTransition : uint8_t { Goto, Call, Return, Exit, Stay };

/// A case. Texts are as written in the mission, on one line; `source` is the whole case with its
/// line breaks.
struct GraphCase {
  std::string guard;
  std::string action;  ///< what `do` does; may be empty
  std::string source;
  GraphTransition transition = GraphTransition::Stay;
  uint32_t target = 0;  ///< a state's number; of Goto and Call
  std::string never;    ///< why the case never fires; empty: it may fire
};

struct GraphState {
  std::string name;
  std::string parameters;  ///< "to: position, limit: time"; may be empty
  std::string profile;     ///< "yo(5 m, 20 m, 26 deg, 26 deg)"
  std::string route;
  std::string source;           ///< the head of the state, up to `events`, with its line breaks
  bool reached = true;          ///< something leads to it
  bool led_to_in_vain = false;  ///< not reached, because only cases that never fire lead to it
  bool dead_end = false;        ///< nothing leaves it
  std::vector<GraphCase> cases;
};

struct Graph {
  std::string mission;
  std::string platform;
  std::vector<GraphState> states;  ///< the mission starts in the first
  std::vector<GraphCase> always;
  std::vector<uint32_t> deepest_path;  ///< the states of a deepest call stack, the current one last
};

/// How a picture is made.
struct GraphStyle {
  bool deepest = false;  ///< mark the deepest call stack
};

/// The picture as one self-contained SVG; the same graph always gives the same bytes.
std::string graphToSvg(const Graph& graph, const GraphStyle& style);
/// The graph in the language of Graphviz.
std::string graphToDot(const Graph& graph, const GraphStyle& style);
/// The graph as JSON: the members of Graph under the same names.
std::string graphToJson(const Graph& graph);

}  // namespace glider::report
