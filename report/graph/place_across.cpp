// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/layered.h"

#include <algorithm>

namespace glider::report::layered {
namespace {

constexpr int kRounds = 80;
constexpr double kBetweenPorts = 14, kPortMargin = 9;
constexpr double kGap = 18;      ///< between nodes and labels
constexpr double kBendGap = 10;  ///< beside a bend

class Placement {
 public:
  Placement(Layers& layers, const std::vector<Edge>& edges) : layers_(layers), edges_(edges) {}

  void run() {
    choosePorts();
    for (std::vector<uint32_t>& order : layers_.order) {
      pack(order);
    }
    for (int round = 0; round < kRounds; ++round) {
      const bool last = round + 2 >= kRounds;
      for (size_t i = 0; i < layers_.order.size(); ++i) {
        const bool forwards = round % 2 == 0;
        settle(layers_.order[forwards ? i : layers_.order.size() - 1 - i], forwards || last,
               !forwards || last);
      }
    }
  }

 private:
  Item& item(uint32_t number) { return layers_.items[number]; }

  /// Spreads the links of one side of a node over it, in the order of their other ends; the links
  /// of labels and bends are in one line.
  void choosePorts() {
    std::vector<size_t> place(layers_.items.size());
    for (const std::vector<uint32_t>& order : layers_.order) {
      for (size_t i = 0; i < order.size(); ++i) {
        place[order[i]] = i;
      }
    }
    for (uint32_t i = 0; i < layers_.items.size(); ++i) {
      for (const bool before : {true, false}) {
        std::vector<uint32_t> links = before ? layers_.in[i] : layers_.out[i];
        auto other = [&](uint32_t link) {
          return place[before ? layers_.links[link].from : layers_.links[link].to];
        };
        std::ranges::stable_sort(links, {}, other);
        for (size_t k = 0; k < links.size(); ++k) {
          Link& link = layers_.links[links[k]];
          (before ? link.to_offset : link.from_offset) = portOffset(item(i), k, links.size());
        }
      }
    }
  }

  [[nodiscard]] double portOffset(const Item& of, size_t k, size_t count) const {
    if (of.kind == Item::Kind::Label) {
      return edges_[of.of].line;
    }
    if (of.kind == Item::Kind::Bend || count < 2) {
      return of.before / 2;
    }
    const auto gaps = static_cast<double>(count - 1);
    const double box = of.size.across - of.before;
    const double step = std::min(kBetweenPorts, std::max(box - 2 * kPortMargin, 0.0) / gaps);
    return of.before / 2 + step * (static_cast<double>(k) - gaps / 2);
  }

  /// The least distance between the middles of two neighbours.
  [[nodiscard]] double apart(const Item& a, const Item& b) const {
    const bool bend = a.kind == Item::Kind::Bend || b.kind == Item::Kind::Bend;
    return (a.size.across + b.size.across) / 2 + (bend ? kBendGap : kGap);
  }

  void pack(const std::vector<uint32_t>& order) {
    double at = 0;
    for (size_t i = 0; i < order.size(); ++i) {
      at += i == 0 ? 0 : apart(item(order[i - 1]), item(order[i]));
      item(order[i]).across = at;
    }
    for (const uint32_t i : order) {
      item(i).across -= at / 2;
    }
  }

  /// The place that an item's links pull it to, and how strongly: long stretches most need to be
  /// straight.
  void pull(uint32_t number, bool before, double& sum, double& weight) {
    for (const uint32_t k : before ? layers_.in[number] : layers_.out[number]) {
      const Link& link = layers_.links[k];
      const Item& other = item(before ? link.from : link.to);
      const int nodes = (other.kind == Item::Kind::Node) + (item(number).kind == Item::Kind::Node);
      const double w = nodes == 0 ? 8 : nodes == 1 ? 2 : 1;
      sum += w * (before ? other.across + link.from_offset - link.to_offset
                         : other.across + link.to_offset - link.from_offset);
      weight += w;
    }
  }

  /// Moves a layer's items as near to the places that their links pull them to as their order and
  /// distances allow: least squares, by pooling neighbours that come too near (isotonic
  /// regression).
  void settle(const std::vector<uint32_t>& order, bool by_before, bool by_after) {
    struct Pool {
      double wanted, weight;
      size_t count;
    };
    std::vector<Pool> pools;
    std::vector<double> offsets;
    for (size_t i = 0; i < order.size(); ++i) {
      offsets.push_back(i == 0 ? 0 : offsets.back() + apart(item(order[i - 1]), item(order[i])));
      double sum = 0, weight = 0;
      if (by_before) {
        pull(order[i], true, sum, weight);
      }
      if (by_after) {
        pull(order[i], false, sum, weight);
      }
      constexpr double kStay = 0.01;  // an item that nothing pulls stays
      const double wanted = weight > 0 ? sum / weight : item(order[i]).across;
      pools.push_back({wanted - offsets[i], weight + kStay, 1});
      while (pools.size() > 1 && pools[pools.size() - 2].wanted > pools.back().wanted) {
        const Pool last = pools.back();
        pools.pop_back();
        Pool& into = pools.back();
        into.wanted =
            (into.wanted * into.weight + last.wanted * last.weight) / (into.weight + last.weight);
        into.weight += last.weight;
        into.count += last.count;
      }
    }
    size_t next = 0;
    for (const Pool& pool : pools) {
      for (size_t i = 0; i < pool.count; ++i, ++next) {
        item(order[next]).across = pool.wanted + offsets[next];
      }
    }
  }

  Layers& layers_;
  const std::vector<Edge>& edges_;
};

}  // namespace

void placeAcross(Layers& layers, const std::vector<Edge>& edges) {
  Placement(layers, edges).run();
}

}  // namespace glider::report::layered
