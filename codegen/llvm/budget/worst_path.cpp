// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/worst_path.h"

#include "codegen/llvm/budget/flow_graph.h"
#include "codegen/llvm/budget/strongly_connected.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace glider::codegen {
namespace {

using Bound = std::expected<uint64_t, std::string>;
using Nodes = std::vector<uint32_t>;
/// A function with the functions it was inlined into, outermost first.
using Chain = std::vector<std::pair<std::string, std::string>>;

constexpr uint64_t kMost = std::numeric_limits<uint64_t>::max();

uint64_t add(uint64_t a, uint64_t b) {
  return a > kMost - b ? kMost : a + b;
}
uint64_t multiply(uint64_t a, uint64_t b) {
  return b != 0 && a > kMost / b ? kMost : a * b;
}

/// Weighs one function: the heaviest path through its graph.
class Weigher {
 public:
  /// `weights`: of each node, including what it calls.
  Weigher(const Image& image, const Knowledge& knowledge, const FlowGraph& graph,
          std::vector<uint64_t> weights)
      : image_(image),
        knowledge_(knowledge),
        graph_(graph),
        weights_(std::move(weights)),
        frames_(weights_.size()) {}

  Bound weigh() {
    Nodes all(weights_.size());
    for (uint32_t i = 0; i < all.size(); ++i) {
      all[i] = i;
    }
    std::multiset<Chain> explained;
    return region(all, kNone, {}, explained);
  }

 private:
  static constexpr uint32_t kNone = UINT32_MAX;

  /// The heaviest path through `nodes`, none of which leads to `cut`. `around` are the owners of
  /// the loops around them; those of the loops within are added to `explained`.
  Bound region(const Nodes& nodes, uint32_t cut, const std::multiset<Chain>& around,
               std::multiset<Chain>& explained) {
    std::vector<uint32_t> place(weights_.size(), kNone);
    for (uint32_t i = 0; i < nodes.size(); ++i) {
      place[nodes[i]] = i;
    }
    std::vector<std::vector<uint32_t>> next(nodes.size());
    for (uint32_t i = 0; i < nodes.size(); ++i) {
      for (const uint32_t to : graph_.next[nodes[i]]) {
        if (place[to] != kNone && to != cut) {
          next[i].push_back(place[to]);
        }
      }
    }
    const Circles components(next);
    std::vector<uint64_t> heaviest(components.list().size());
    uint64_t most = 0;
    for (uint32_t c = 0; c < heaviest.size(); ++c) {  // each after all that it leads to
      Nodes members;
      uint64_t after = 0;
      for (const uint32_t i : components.list()[c]) {
        members.push_back(nodes[i]);
        for (const uint32_t to : next[i]) {
          after = std::max(after, components.of(to) == c ? 0 : heaviest[components.of(to)]);
        }
      }
      const Bound own =
          components.turns(c) ? loop(members, around, explained) : weights_[members.front()];
      if (!own) {
        return own;
      }
      heaviest[c] = add(*own, after);
      most = std::max(most, heaviest[c]);
    }
    return most;
  }

  /// A loop: the heaviest path from its head back to it, as often as its owner allows. If loops
  /// cannot be distinguished, all of it as often as all owners allow.
  Bound loop(const Nodes& nodes, const std::multiset<Chain>& around,
             std::multiset<Chain>& explained) {
    const Chain owner = ownerOf(nodes);
    const Turns stated = owner.empty() ? Turns{} : turnsOf(owner.back());
    if (stated.outer == 0) {
      return std::unexpected(fmt::format("no bound is stated for the loop in `{}`",
                                         owner.empty() ? "" : owner.back().second));
    }
    const size_t level = around.count(owner);
    const uint64_t turns = level == 0 ? stated.outer : level == 1 ? stated.inner : 0;
    const uint32_t head = headOf(nodes);
    explained.insert(owner);
    if (turns != 0 && head != kNone) {
      std::multiset<Chain> within = around, found;
      within.insert(owner);
      const Bound once = region(nodes, head, within, found);
      found.insert(owner);
      if (once && allExplained(nodes, around, found)) {
        explained.insert(found.begin(), found.end());
        return multiply(add(turns, 1), *once);
      }
    }
    return flat(nodes, explained);
  }

  Bound flat(const Nodes& nodes, std::multiset<Chain>& explained) {
    uint64_t turns = 1, weight = 0;
    for (const uint32_t node : nodes) {
      weight = add(weight, weights_[node]);
      uint64_t together = 1;
      for (const Frame& frame : framesOf(node)) {
        const Turns stated = knowledge_.turns(frame);
        together = multiply(together, add(stated.outer, 1));
        together = multiply(together, add(stated.inner, 1));
      }
      turns = std::max(turns, together);
      for (const Chain& chain : statedChains(node)) {
        explained.insert(chain);
        explained.insert(chain);  // both levels
      }
    }
    return multiply(turns, weight);
  }

  /// Whether each function with loops among the nodes has a loop that was weighed separately.
  bool allExplained(const Nodes& nodes, const std::multiset<Chain>& around,
                    const std::multiset<Chain>& found) {
    return std::ranges::all_of(nodes, [&](uint32_t node) {
      return std::ranges::all_of(statedChains(node), [&](const Chain& chain) {
        const size_t levels = turnsOf(chain.back()).inner == 0 ? 1 : 2;
        return around.count(chain) + found.count(chain) >= levels;
      });
    });
  }

  [[nodiscard]] Turns turnsOf(const std::pair<std::string, std::string>& function) const {
    return knowledge_.turns({function.first, function.second, 1});
  }

  /// The only node that is reached from outside; kNone if there are several.
  [[nodiscard]] uint32_t headOf(const Nodes& nodes) const {
    const std::set<uint32_t> inside(nodes.begin(), nodes.end());
    std::set<uint32_t> heads;
    if (inside.contains(0)) {
      heads.insert(0);
    }
    for (uint32_t from = 0; from < graph_.next.size(); ++from) {
      for (const uint32_t to : graph_.next[from]) {
        if (inside.contains(to) && !inside.contains(from)) {
          heads.insert(to);
        }
      }
    }
    return heads.size() == 1 ? *heads.begin() : kNone;
  }

  const std::vector<Frame>& framesOf(uint32_t node) {
    if (frames_[node].empty()) {
      frames_[node] = image_.framesAt(image_.code()[graph_.instructions[node]].address);
    }
    return frames_[node];
  }

  Chain chainOf(uint32_t node) {
    Chain chain;
    for (const Frame& frame : framesOf(node)) {
      chain.emplace(chain.begin(), frame.file, frame.function);
    }
    return chain;
  }

  /// The functions of a node that have a row of loops.
  std::vector<Chain> statedChains(uint32_t node) {
    std::vector<Chain> chains;
    Chain chain = chainOf(node);
    for (; !chain.empty(); chain.pop_back()) {
      if (turnsOf(chain.back()).outer != 0) {
        chains.push_back(chain);
      }
    }
    return chains;
  }

  /// The innermost function that contains all nodes with known lines: it owns the loop.
  Chain ownerOf(const Nodes& nodes) {
    const bool placed =
        std::ranges::any_of(nodes, [&](uint32_t node) { return framesOf(node).front().line != 0; });
    Chain common;
    bool first = true;
    for (const uint32_t node : nodes) {
      if (placed && framesOf(node).front().line == 0) {
        continue;
      }
      const Chain chain = chainOf(node);
      if (first) {
        common = chain;
      }
      common.erase(std::ranges::mismatch(common, chain).in1, common.end());
      first = false;
    }
    return common;
  }

  const Image& image_;
  const Knowledge& knowledge_;
  const FlowGraph& graph_;
  std::vector<uint64_t> weights_;
  std::vector<std::vector<Frame>> frames_;
};

/// The weight of an instruction with what it calls or repeats.
Bound weightOf(const Image& image, const Knowledge& knowledge, const Instruction& one,
               const std::function<Bound(uint64_t)>& bound) {
  if (one.repeats == Instruction::kUncounted) {
    return std::unexpected(
        fmt::format("it is not known how often `{}` repeats the instruction at {:#x}",
                    image.baseNameAt(one.address), one.address));
  }
  if (one.repeats >= 0) {
    return add(1, static_cast<uint64_t>(one.repeats));
  }
  std::vector<uint64_t> targets;
  if (one.flow == Flow::Call) {
    targets.push_back(one.target);
  } else if (one.flow == Flow::CallByPointer || one.flow == Flow::JumpByPointer) {
    targets = knowledge.pointers(image.framesAt(one.address));
  }
  uint64_t most = 0;  // without a target the pointer is null, and the call is not made
  for (const uint64_t target : targets) {
    const Bound called = bound(target);
    if (!called) {
      return called;
    }
    most = std::max(most, *called);
  }
  return add(1, most);
}

}  // namespace

WorstPath::WorstPath(const Image& image, Knowledge knowledge)
    : image_(image), knowledge_(std::move(knowledge)) {}

Bound WorstPath::bound(uint64_t entry) {
  const auto known = known_.find(entry);
  if (known != known_.end()) {
    return known->second;
  }
  auto learn = [&](Bound weighed) {
    known_.insert_or_assign(entry, weighed);
    return weighed;
  };
  const std::string name = image_.symbolAt(entry);
  if (knowledge_.never(name)) {
    return learn(0);
  }
  learn(std::unexpected(fmt::format("`{}` may call itself", image_.baseNameAt(entry))));
  const auto graph = FlowGraph::follow(image_, entry);
  if (!graph) {
    return learn(std::unexpected(graph.error()));
  }
  std::vector<uint64_t> weights;
  for (const uint32_t place : graph->instructions) {
    const Bound one = weightOf(image_, knowledge_, image_.code()[place],
                               [&](uint64_t target) { return bound(target); });
    if (!one) {
      return learn(one);
    }
    weights.push_back(*one);
  }
  return learn(Weigher(image_, knowledge_, *graph, std::move(weights)).weigh());
}

}  // namespace glider::codegen
