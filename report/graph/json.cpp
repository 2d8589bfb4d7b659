// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/graph.h"

#include <nlohmann/json.hpp>

namespace glider::report {
namespace {

using nlohmann::ordered_json;

const char* nameOf(GraphTransition transition) {
  switch (transition) {
    case GraphTransition::Goto:
      return "goto";
    case GraphTransition::Call:
      return "call";
    case GraphTransition::Return:
      return "return";
    case GraphTransition::Exit:
      return "exit";
    case GraphTransition::Stay:
      return "stay";
  }
  return "";
}

ordered_json casesOf(const Graph& graph, const std::vector<GraphCase>& cases) {
  ordered_json list = ordered_json::array();
  for (const GraphCase& c : cases) {
    ordered_json one = {{"guard", c.guard}, {"transition", nameOf(c.transition)}};
    if (c.transition == GraphTransition::Goto || c.transition == GraphTransition::Call) {
      one["target"] = graph.states.at(c.target).name;
    }
    if (!c.action.empty()) {
      one["action"] = c.action;
    }
    if (!c.never.empty()) {
      one["never"] = c.never;
    }
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace

std::string graphToJson(const Graph& graph) {
  ordered_json states = ordered_json::array(), deepest = ordered_json::array();
  for (const GraphState& state : graph.states) {
    states.push_back({{"name", state.name},
                      {"parameters", state.parameters},
                      {"profile", state.profile},
                      {"route", state.route},
                      {"reached", state.reached},
                      {"led_to_in_vain", state.led_to_in_vain},
                      {"dead_end", state.dead_end},
                      {"cases", casesOf(graph, state.cases)}});
  }
  for (const uint32_t state : graph.deepest_path) {
    deepest.push_back(graph.states.at(state).name);
  }
  const ordered_json document = {{"mission", graph.mission},
                                 {"platform", graph.platform},
                                 {"states", std::move(states)},
                                 {"always", casesOf(graph, graph.always)},
                                 {"deepest_path", std::move(deepest)}};
  return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace glider::report
