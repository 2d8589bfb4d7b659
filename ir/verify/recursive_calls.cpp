// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"

#include <fmt/format.h>

namespace glider::ir {
namespace {

/// Walks the calls depth first from every state that meets an empty stack, so that the walk's own
/// stack is a call stack that can come about; a call of a state on it is the mistake. Without the
/// calls that it reports none is left that could put a state on the stack twice.
class CallWalk {
 public:
  explicit CallWalk(Verification& verification)
      : v_(verification), marks_(verification.structure.size()) {}

  void run() {
    for (uint32_t s : v_.structure.order) {
      if (v_.structure.at({s, false}) && marks_[s] == Mark::New) {
        from(s);
      }
    }
  }

 private:
  enum class Mark : uint8_t { New, OnStack, Done };
  struct Level {
    uint32_t state;
    size_t next_edge = 0;
  };

  void from(uint32_t root) {
    levels_ = {{root}};
    marks_[root] = Mark::OnStack;
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
        report(edge);
      } else if (marks_[edge.to] == Mark::New) {
        marks_[edge.to] = Mark::OnStack;
        levels_.push_back({edge.to});
      }
    }
  }

  void report(const Edge& closing) {
    const Mission& m = v_.structure.mission;
    const State& from = m.states[closing.from];
    const std::string& to = m.states[closing.to].name;
    auto report = v_.diagnostics.report(
        support::DiagnosticId::recursiveCall, from.cases[closing.case_index].range, from.name,
        closing.from == closing.to ? "itself"
                                   : fmt::format("`{}`, which can be on the call stack", to),
        to);
    std::vector<Edge> path = v_.structure.pathTo({levels_.front().state, false});
    for (size_t i = 0; i + 1 < levels_.size(); ++i) {
      path.push_back(v_.structure.moves[levels_[i].state].edges[levels_[i].next_edge - 1]);
    }
    notePath(report, v_.structure, path);
  }

  Verification& v_;
  std::vector<Mark> marks_;
  std::vector<Level> levels_;
};

}  // namespace

void passes::recursiveCalls(Verification& v) {
  CallWalk(v).run();
}

}  // namespace glider::ir
