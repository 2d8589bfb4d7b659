// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/layered.h"

#include <algorithm>

namespace glider::report::layered {
namespace {

class LayerMaker {
 public:
  LayerMaker(const std::vector<Node>& nodes, const std::vector<uint32_t>& layer_of)
      : layer_of_(layer_of) {
    const uint32_t last = layer_of.empty() ? 0 : std::ranges::max(layer_of);
    made_.order.resize(last + 1);
    for (uint32_t node = 0; node < nodes.size(); ++node) {
      add({Item::Kind::Node, node, layer_of[node], nodes[node].size, nodes[node].before});
    }
  }

  /// Adds items of the edge in each layer between its nodes; the label is next to the node from
  /// which it leads.
  void edge(uint32_t number, const Edge& edge) {
    const bool backwards = layer_of_[edge.to] < layer_of_[edge.from];
    const uint32_t first = backwards ? edge.to : edge.from;
    const uint32_t second = backwards ? edge.from : edge.to;
    const uint32_t label = backwards ? layer_of_[second] - 1 : layer_of_[first] + 1;
    uint32_t before = first;
    for (uint32_t layer = layer_of_[first] + 1; layer < layer_of_[second]; ++layer) {
      const bool here = layer == label;
      const uint32_t item = add(
          {here ? Item::Kind::Label : Item::Kind::Bend, number, layer, here ? edge.label : Size{}});
      link(before, item, number);
      before = item;
    }
    link(before, second, number);
  }

  Layers take() { return std::move(made_); }

 private:
  uint32_t add(const Item& item) {
    const auto number = static_cast<uint32_t>(made_.items.size());
    made_.items.push_back(item);
    made_.out.emplace_back();
    made_.in.emplace_back();
    made_.order[item.layer].push_back(number);
    return number;
  }

  void link(uint32_t from, uint32_t to, uint32_t edge) {
    const auto number = static_cast<uint32_t>(made_.links.size());
    made_.links.push_back({from, to, edge});
    made_.out[from].push_back(number);
    made_.in[to].push_back(number);
  }

  const std::vector<uint32_t>& layer_of_;
  Layers made_;
};

}  // namespace

Layers makeLayers(const std::vector<Node>& nodes, const std::vector<Edge>& edges,
                  const std::vector<uint32_t>& layer_of) {
  LayerMaker maker(nodes, layer_of);
  for (uint32_t i = 0; i < edges.size(); ++i) {
    maker.edge(i, edges[i]);
  }
  return maker.take();
}

}  // namespace glider::report::layered
