// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/layered.h"

#include <algorithm>

namespace glider::report::layered {
namespace {

constexpr int kSweeps = 24;

class Sweeps {
 public:
  explicit Sweeps(Layers& layers) : layers_(layers), place_(layers.items.size()) {
    for (size_t layer = 0; layer < layers_.order.size(); ++layer) {
      note(layer);
    }
  }

  void run() {
    std::vector<std::vector<uint32_t>> best = layers_.order;
    size_t fewest = crossings();
    for (int sweep = 0; sweep < kSweeps && fewest > 0; ++sweep) {
      const bool forwards = sweep % 2 == 0;
      for (size_t i = 1; i < layers_.order.size(); ++i) {
        arrange(forwards ? i : layers_.order.size() - 1 - i, forwards);
      }
      exchange();
      if (const size_t now = crossings(); now < fewest) {
        fewest = now;
        best = layers_.order;
      }
    }
    layers_.order = best;
  }

 private:
  void note(size_t layer) {
    for (size_t i = 0; i < layers_.order[layer].size(); ++i) {
      place_[layers_.order[layer][i]] = i;
    }
  }

  [[nodiscard]] std::vector<size_t> neighbours(uint32_t item, bool before) const {
    std::vector<size_t> places;
    for (const uint32_t link : before ? layers_.in[item] : layers_.out[item]) {
      const Link& l = layers_.links[link];
      places.push_back(place_[before ? l.from : l.to]);
    }
    std::ranges::sort(places);
    return places;
  }

  /// Sorts a layer by the means of the neighbours' places in the layer before it (or after it); an
  /// item without neighbours stays where it is.
  void arrange(size_t layer, bool before) {
    std::vector<uint32_t>& order = layers_.order[layer];
    std::vector<std::pair<double, uint32_t>> wanted;
    std::vector<bool> fixed(order.size());
    for (size_t i = 0; i < order.size(); ++i) {
      const std::vector<size_t> places = neighbours(order[i], before);
      double sum = 0;
      for (const size_t place : places) {
        sum += static_cast<double>(place);
      }
      fixed[i] = places.empty();
      if (!fixed[i]) {
        wanted.emplace_back(sum / static_cast<double>(places.size()), order[i]);
      }
    }
    std::ranges::stable_sort(wanted, {}, &std::pair<double, uint32_t>::first);
    size_t next = 0;
    for (size_t i = 0; i < order.size(); ++i) {
      if (!fixed[i]) {
        order[i] = wanted[next++].second;
      }
    }
    note(layer);
  }

  /// The number of crossings between the links of `left` and `right`, if `left` comes before
  /// `right`.
  [[nodiscard]] size_t crossingsOf(uint32_t left, uint32_t right) const {
    size_t count = 0;
    for (const bool before : {true, false}) {
      const std::vector<size_t> a = neighbours(left, before), b = neighbours(right, before);
      size_t smaller = 0;
      for (const size_t place : a) {
        while (smaller < b.size() && b[smaller] < place) {
          ++smaller;
        }
        count += smaller;
      }
    }
    return count;
  }

  /// Exchanges neighbours in a layer while that removes crossings.
  void exchange() {
    bool better = true;
    for (int round = 0; round < kSweeps && better; ++round) {
      better = false;
      for (std::vector<uint32_t>& order : layers_.order) {
        for (size_t i = 0; i + 1 < order.size(); ++i) {
          if (crossingsOf(order[i], order[i + 1]) > crossingsOf(order[i + 1], order[i])) {
            std::swap(order[i], order[i + 1]);
            std::swap(place_[order[i]], place_[order[i + 1]]);
            better = true;
          }
        }
      }
    }
  }

  [[nodiscard]] size_t crossings() const {
    size_t count = 0;
    for (const std::vector<uint32_t>& order : layers_.order) {
      count += crossingsAfter(order);
    }
    return count;
  }

  /// The crossings of the links from this layer to the next, counted by inserting their ends in
  /// order (a Fenwick tree counts those beyond).
  [[nodiscard]] size_t crossingsAfter(const std::vector<uint32_t>& order) const {
    std::vector<size_t> ends;
    for (const uint32_t item : order) {
      const std::vector<size_t> places = neighbours(item, false);
      ends.insert(ends.end(), places.begin(), places.end());
    }
    const size_t most = ends.empty() ? 0 : std::ranges::max(ends) + 1;
    std::vector<size_t> tree(most + 1);
    size_t count = 0;
    for (size_t n = 0; n < ends.size(); ++n) {
      size_t not_beyond = 0;
      for (size_t i = ends[n] + 1; i > 0; i -= i & (~i + 1)) {
        not_beyond += tree[i];
      }
      count += n - not_beyond;
      for (size_t i = ends[n] + 1; i <= most; i += i & (~i + 1)) {
        ++tree[i];
      }
    }
    return count;
  }

  Layers& layers_;
  std::vector<size_t> place_;  ///< of each item in its layer
};

}  // namespace

void reduceCrossings(Layers& layers) {
  Sweeps(layers).run();
}

}  // namespace glider::report::layered
