// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/layered.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::report::layered {
namespace {

constexpr double kLeastGap = 24, kGreatestGap = 80;

/// The beginning and end of each layer, along.
struct Band {
  double begin = 0;
  double end = 0;
};

/// A gap is wider where links go a long way across, so that curves stay smooth.
std::vector<Band> bandsOf(const Layers& layers) {
  std::vector<double> steepest(layers.order.size());
  for (const Link& link : layers.links) {
    const Item& from = layers.items[link.from];
    const Item& to = layers.items[link.to];
    double& most = steepest[from.layer];
    most = std::max(most, std::abs(from.across + link.from_offset - to.across - link.to_offset));
  }
  std::vector<Band> bands;
  double at = 0;
  for (size_t i = 0; i < layers.order.size(); ++i) {
    double length = 0;
    for (const uint32_t item : layers.order[i]) {
      length = std::max(length, layers.items[item].size.along);
    }
    bands.push_back({at, at + length});
    at += length + std::clamp(0.22 * steepest[i], kLeastGap, kGreatestGap);
  }
  return bands;
}

class Tracer {
 public:
  Tracer(const Layers& layers, const std::vector<Edge>& edges)
      : layers_(layers), bands_(bandsOf(layers)), drawing_{} {
    drawing_.edges.resize(edges.size());
    for (const Item& item : layers_.items) {
      if (item.kind == Item::Kind::Node) {
        drawing_.nodes.push_back(middle(item));
      } else if (item.kind == Item::Kind::Label) {
        drawing_.edges[item.of].label = middle(item);
      }
    }
    trace(edges);
    shift();
  }

  Drawing take() { return std::move(drawing_); }

 private:
  [[nodiscard]] Point middle(const Item& item) const {
    const Band& band = bands_[item.layer];
    return {(band.begin + band.end) / 2, item.across};
  }

  /// The links of an edge are in the order of the layers.
  void trace(const std::vector<Edge>& edges) {
    for (const Link& link : layers_.links) {
      const Item& from = layers_.items[link.from];
      const Item& to = layers_.items[link.to];
      std::vector<Stretch>& stretches = drawing_.edges[link.edge].stretches;
      const Band& band = bands_[from.layer];
      const double across = from.across + link.from_offset;
      const double begin =
          from.kind == Item::Kind::Node ? middle(from).along + from.size.along / 2 : band.begin;
      stretches.push_back({{begin, across}, {band.end, across}});
      if (to.kind == Item::Kind::Node) {
        const double at = to.across + link.to_offset;
        stretches.push_back(
            {{bands_[to.layer].begin, at}, {middle(to).along - to.size.along / 2, at}});
      }
    }
    for (size_t i = 0; i < edges.size(); ++i) {
      std::vector<Stretch>& stretches = drawing_.edges[i].stretches;
      if (!stretches.empty() && middleOf(edges[i].to).along < middleOf(edges[i].from).along) {
        std::ranges::reverse(stretches);
        for (Stretch& stretch : stretches) {
          std::swap(stretch.from, stretch.to);
        }
      }
    }
  }

  [[nodiscard]] Point middleOf(uint32_t node) const { return drawing_.nodes[node]; }

  /// Moves everything so that it begins at 0.
  void shift() {
    if (layers_.items.empty()) {
      return;
    }
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Item& item : layers_.items) {
      least = std::min(least, item.across - item.size.across / 2);
      most = std::max(most, item.across + item.size.across / 2);
    }
    for (Point& node : drawing_.nodes) {
      node.across -= least;
    }
    for (PlacedEdge& edge : drawing_.edges) {
      edge.label.across -= least;
      for (Stretch& stretch : edge.stretches) {
        stretch.from.across -= least;
        stretch.to.across -= least;
      }
    }
    drawing_.size = {bands_.back().end, most - least};
  }

  const Layers& layers_;
  const std::vector<Band> bands_;
  Drawing drawing_;
};

}  // namespace

Drawing layOut(const std::vector<Node>& nodes, const std::vector<Edge>& edges) {
  Layers layers = makeLayers(nodes, edges, assignLayers(nodes.size(), edges));
  reduceCrossings(layers);
  placeAcross(layers, edges);
  return Tracer(layers, edges).take();
}

}  // namespace glider::report::layered
