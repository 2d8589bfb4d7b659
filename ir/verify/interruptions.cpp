// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"

#include <algorithm>

namespace glider::ir {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

/// One walk over the states' own calls, callers first. What can be below a state on the stack is a
/// *source*: a root, which cases below its limit interrupt, or the target of a case of `always`,
/// which cases before that one interrupt. Let T be the target of the first case i whose target
/// leads to state x by calls. Then i makes x recursive if x is a source for more than i, or if a
/// caller of x that T does not lead to is led to by such a source: then x may be on the stack when
/// i calls T. That is sufficient: if a later case k with the target U makes x recursive and T does
/// not, then every way from U to x goes through T, which U also leads to; so the way by which k
/// makes x recursive enters the part that T leads to from outside, and makes a state there
/// recursive for T.
///
/// The roots with the greatest limits are the exception: on the stack as a root, T could keep its
/// own case from firing. The walk leaves them out; they are at most three, and are checked one by
/// one.
class SourceWalk {
 public:
  explicit SourceWalk(const Structure& structure)
      : s_(structure),
        own_(structure.size()),
        sources_(structure.size()),
        target_of_(structure.size(), kNone),
        led_by_(structure.size(), kNone) {
    for (uint32_t s : s_.order) {
      own_[s] = s_.rootLimit(s).value_or(0);
    }
    for (const Edge& edge : s_.always.edges) {
      // A case that no stack lets fire is not a source.
      if (edge.call && s_.otherRoot(edge.case_index, edge.to, edge.to)) {
        own_[edge.to] = std::max(own_[edge.to], edge.case_index);
      }
      if (edge.call && !s_.highRoot(edge.to)) {
        target_of_[edge.to] = std::min(target_of_[edge.to], edge.case_index);
      }
    }
  }

  [[nodiscard]] bool findsMistake() {
    const std::vector<uint32_t> order = callersFirst(s_);
    std::vector<uint32_t> inclusive(s_.size(), kNone);  // as led_by_, including a state's own case
    for (uint32_t s : order) {
      sources_[s] = std::max(sources_[s], own_[s]);
      inclusive[s] = std::min(led_by_[s], target_of_[s]);
      eachCall(s, [&](uint32_t to) {
        sources_[to] = std::max(sources_[to], sources_[s]);
        led_by_[to] = std::min(led_by_[to], inclusive[s]);
      });
    }
    bool found = false;
    for (uint32_t s : order) {
      found |= led_by_[s] != kNone && own_[s] > led_by_[s];
      eachCall(s, [&](uint32_t to) {
        found |= inclusive[s] != led_by_[to] && led_by_[to] != kNone && sources_[s] > led_by_[to];
      });
    }
    return found;
  }

 private:
  template <typename Visit>
  void eachCall(uint32_t state, Visit visit) {
    for (const Edge& edge : s_.moves[state].edges) {
      if (edge.call) {
        visit(edge.to);
      }
    }
  }

  const Structure& s_;
  std::vector<uint32_t> own_;  ///< what a state itself is a source for: all cases before this one
  std::vector<uint32_t> sources_;    ///< the greatest of those that lead to it, including its own
  std::vector<uint32_t> target_of_;  ///< the first case of `always` that calls it
  std::vector<uint32_t> led_by_;     ///< the first one whose target leads to it, except its own
};

/// Whether `always`, a call of one of the roots with the greatest limits, leads to a state that can
/// be below that root.
bool recurs(const Structure& s, const Edge& always) {
  std::vector<bool> below(s.size()), above(s.size());
  auto spread = [&](std::vector<bool>& reached, std::vector<uint32_t> pending) {
    while (!pending.empty()) {
      const uint32_t state = pending.back();
      pending.pop_back();
      for (const Edge& edge : s.moves[state].edges) {
        if (edge.call && edge.to != always.to && !reached[edge.to]) {
          reached[edge.to] = true;
          pending.push_back(edge.to);
        }
      }
    }
  };
  std::vector<uint32_t> sources;
  for (uint32_t root : s.order) {
    if (root != always.to && s.rootLimit(root).value_or(0) > always.case_index) {
      sources.push_back(root);
    }
  }
  for (const Edge& other : s.always.edges) {
    if (other.call && other.case_index > always.case_index && other.to != always.to &&
        s.otherRoot(other.case_index, always.to, other.to)) {
      sources.push_back(other.to);
    }
  }
  for (uint32_t source : sources) {
    below[source] = true;
  }
  spread(below, sources);
  spread(above, {always.to});
  for (uint32_t state : s.order) {
    if (below[state] && above[state]) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool interruptionsRecur(const Structure& structure) {
  std::vector<uint32_t> looked_at;
  for (const Edge& edge : structure.always.edges) {
    if (edge.call && structure.highRoot(edge.to) &&
        std::ranges::find(looked_at, edge.to) == looked_at.end()) {
      looked_at.push_back(edge.to);  // its first case may fire wherever later ones may
      if (recurs(structure, edge)) {
        return true;
      }
    }
  }
  return SourceWalk(structure).findsMistake();
}

}  // namespace glider::ir
