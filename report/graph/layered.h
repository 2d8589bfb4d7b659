// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// A layered drawing of a directed graph, after Sugiyama, Tagawa and Toda (1981): nodes are in
/// layers so that most edges lead from one layer to a later one. Edges get a bend in each layer
/// between, and labels get places of their own, so that nothing overlaps. *Along* is the direction
/// from layer to layer, *across* the direction within one; both in pixels.
namespace glider::report::layered {

struct Size {
  double along = 0;
  double across = 0;
};

struct Node {
  Size size;
  double before = 0;  ///< free space on the side of lower across, for loops
};

struct Edge {
  uint32_t from = 0;
  uint32_t to = 0;  ///< another node
  Size label;
  double line = 0;  ///< where in the label the line is, from its middle, across
};

struct Point {
  double along = 0;
  double across = 0;
};

/// A straight part of an edge, along.
struct Stretch {
  Point from, to;
};

struct PlacedEdge {
  std::vector<Stretch> stretches;  ///< from the first node to the second; curves join them
  Point label;                     ///< the middle of the label
};

struct Drawing {
  Size size;
  std::vector<Point> nodes;  ///< their middles
  std::vector<PlacedEdge> edges;
};

/// Lays the graph out. Node 0 is in the first layer; apart from edges that lead back, the other
/// layers follow from it. Deterministic.
Drawing layOut(const std::vector<Node>& nodes, const std::vector<Edge>& edges);

// The steps, in order.

/// An item of a layer: a node, or the place where an edge passes through.
struct Item {
  enum class Kind : uint8_t { Node, Label, Bend };
  Kind kind = Kind::Node;
  uint32_t of = 0;  ///< the number of the node or edge
  uint32_t layer = 0;
  Size size;
  double before = 0;
  double across = 0;  ///< of its middle
};

/// A piece of an edge between an item and one of the next layer.
struct Link {
  uint32_t from = 0;
  uint32_t to = 0;
  uint32_t edge = 0;
  double from_offset = 0;  ///< where it meets the items, from their middles, across
  double to_offset = 0;
};

struct Layers {
  std::vector<Item> items;
  std::vector<Link> links;
  std::vector<std::vector<uint32_t>> order;    ///< of the items of each layer
  std::vector<std::vector<uint32_t>> out, in;  ///< links of each item, in no order
};

/// The layer of each node: nodes have even ones. An edge whose second node is not in a later layer
/// than its first is drawn backwards.
std::vector<uint32_t> assignLayers(size_t nodes, const std::vector<Edge>& edges);
/// Items and links for nodes in these layers; within a layer in the order in which they are found.
Layers makeLayers(const std::vector<Node>& nodes, const std::vector<Edge>& edges,
                  const std::vector<uint32_t>& layer_of);
/// Orders each layer so that few links cross.
void reduceCrossings(Layers& layers);
/// Chooses where links meet nodes, and Item::across, so that edges are as straight as possible.
void placeAcross(Layers& layers, const std::vector<Edge>& edges);

}  // namespace glider::report::layered
