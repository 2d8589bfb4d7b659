// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <deque>
#include <optional>
#include <set>
#include <utility>

namespace glider::ir {
namespace {

/// Reports `closing`, a call of a state that can be on the call stack; `path` leads to where it is
/// made.
void reportCall(Verification& v, const Edge& closing, const Path& path) {
  const Mission& m = v.structure.mission;
  const State& from = m.states[closing.from];
  const std::string& to = m.states[closing.to].name;
  auto report = v.diagnostics.report(
      support::diagnostics::recursiveCall, from.cases[closing.case_index].range, from.name,
      closing.from == closing.to ? "itself"
                                 : fmt::format("`{}`, which can be on the call stack", to),
      to);
  notePath(report, v.structure, path);
  v.recursive = true;
}

/// Walks the states' own calls depth first from every state that meets an empty stack or that
/// `always` calls, so that the walk's own stack is a possible call stack; a call of a state on it
/// is the error. Without the reported calls, the states' own calls cannot put a state on the stack
/// twice.
class CallWalk {
 public:
  explicit CallWalk(Verification& verification)
      : v_(verification), marks_(verification.structure.size()) {}

  void run() {
    for (uint32_t s : v_.structure.order) {
      if (v_.structure.meetsEmptyStack(s)) {
        from(v_.structure.root(s));
      }
    }
    for (const Edge& edge : v_.structure.always.edges) {
      if (edge.call && v_.structure.at({edge.to, Arrived::Called})) {
        from({edge.to, Arrived::Called});
      }
    }
  }

 private:
  enum class Mark : uint8_t { New, OnStack, Done };
  struct Level {
    uint32_t state;
    size_t next_edge = 0;
  };

  void from(Place root) {
    if (marks_[root.state] != Mark::New) {
      return;
    }
    levels_ = {{root.state}};
    marks_[root.state] = Mark::OnStack;
    while (!levels_.empty()) {
      Level& level = levels_.back();
      const std::vector<Edge>& edges = v_.structure.moves[level.state].edges;
      if (level.next_edge == edges.size()) {
        marks_[level.state] = Mark::Done;
        levels_.pop_back();
        continue;
      }
      const Edge& edge = edges[level.next_edge++];
      if (!edge.call) {
        continue;
      }
      if (marks_[edge.to] == Mark::OnStack) {
        report(root, edge);
      } else if (marks_[edge.to] == Mark::New) {
        marks_[edge.to] = Mark::OnStack;
        levels_.push_back({edge.to});
      }
    }
  }

  void report(Place root, const Edge& closing) {
    Path path = v_.structure.pathTo(root);
    path.append(levels_.size() - 1, [&](size_t i) {
      return v_.structure.moves[levels_[i].state].edges[levels_[i].next_edge - 1];
    });
    reportCall(v_, closing, path);
  }

  Verification& v_;
  std::vector<Mark> marks_;
  std::vector<Level> levels_;
};

/// Where a path begins: in a state that meets an empty stack; then possibly a call by `always`.
struct Beginning {
  uint32_t root = 0;
  std::optional<Edge> then;
};

/// The states that calls reach from some beginnings, each with how it is reached.
class CallReach {
 public:
  explicit CallReach(const Structure& structure) : s_(structure), how_(structure.size()) {}

  [[nodiscard]] bool has(uint32_t state) const { return how_[state].reached; }

  /// `state` is reached from the start, or is where the path begins.
  void begin(uint32_t state, std::optional<Beginning> how = std::nullopt) {
    if (!has(state)) {
      how_[state] = {true, how, std::nullopt};
      pending_.push_back(state);
    }
  }

  /// Follows calls; `visit` is called for each and returns whether to follow it.
  template <typename Visit>
  void follow(Visit visit) {
    while (!pending_.empty()) {
      const uint32_t state = pending_.front();
      pending_.pop_front();
      for (const Edge& edge : s_.moves[state].edges) {
        if (edge.call && visit(edge) && !has(edge.to)) {
          how_[edge.to] = {true, std::nullopt, edge};
          pending_.push_back(edge.to);
        }
      }
    }
  }

  [[nodiscard]] Path pathTo(uint32_t state) const {
    std::vector<Edge> calls;
    while (how_[state].by) {
      calls.push_back(*how_[state].by);
      state = calls.back().from;
    }
    Path path;
    if (how_[state].beginning) {
      path = s_.pathTo(s_.root(how_[state].beginning->root));
      if (how_[state].beginning->then) {
        path.append(*how_[state].beginning->then);
      }
    }
    path.append(calls.size(), [&](size_t i) { return calls[calls.size() - 1 - i]; });
    return path;
  }

 private:
  struct How {
    bool reached = false;
    std::optional<Beginning> beginning;
    std::optional<Edge> by;
  };
  const Structure& s_;
  std::vector<How> how_;
  std::deque<uint32_t> pending_;
};

/// The errors that case `always` causes: it interrupts a stack, and the state that it calls leads
/// by calls to a state on that stack. The README says which states can be on it.
class Interruption {
 public:
  Interruption(Verification& v, const Edge& always)
      : v_(v), s_(v.structure), always_(always), below_(v.structure) {}

  void run(std::set<std::pair<uint32_t, uint32_t>>& told) {
    findBelow();
    CallReach above(s_);
    above.begin(always_.to);
    above.follow([&](const Edge& edge) {
      if (!below_.has(edge.to)) {
        return true;
      }
      if (told.insert({edge.from, edge.case_index}).second) {
        report(edge, above.pathTo(edge.from));
      }
      return false;
    });
  }

 private:
  /// Every state that can be current, or wait, where the case may fire, with a stack that does not
  /// hold its target.
  void findBelow() {
    for (uint32_t root : s_.order) {
      const std::optional<uint32_t> limit = s_.rootLimit(root);
      if (root != always_.to && limit && *limit > always_.case_index) {
        below_.begin(root, Beginning{root, std::nullopt});
      }
    }
    for (const Edge& other : s_.always.edges) {
      const auto root = s_.otherRoot(other.case_index, always_.to, other.to);
      if (other.call && other.case_index > always_.case_index && other.to != always_.to && root) {
        below_.begin(other.to, Beginning{*root, from(*root, other)});
      }
    }
    below_.follow([&](const Edge& edge) { return edge.to != always_.to; });
  }

  static Edge from(uint32_t state, Edge always) {
    always.from = state;
    return always;
  }

  void report(const Edge& closing, const Path& above) {
    Path path = below_.pathTo(closing.to);
    path.append(from(closing.to, always_));
    path.append(above);
    reportCall(v_, closing, path);
  }

  Verification& v_;
  const Structure& s_;
  Edge always_;
  CallReach below_;
};

}  // namespace

void reportInterruptions(Verification& v) {
  std::set<std::pair<uint32_t, uint32_t>> told;
  for (const Edge& edge : v.structure.always.edges) {
    if (edge.call) {
      Interruption(v, edge).run(told);
    }
  }
}

void passes::recursiveCalls(Verification& v) {
  CallWalk(v).run();
  if (v.recursive || interruptionsRecur(v.structure)) {
    reportInterruptions(v);
  }
}

}  // namespace glider::ir
