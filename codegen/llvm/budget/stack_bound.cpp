// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/stack_bound.h"

#include "codegen/llvm/budget/stack_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace glider::codegen {

/// Follows the paths through one function.
class StackBound::Walk {
 public:
  /// `excluded`: the groups of functions that it does not call through pointers. `begin`: the stack
  /// depth at the start; more than 0 for a part that a function calls of itself.
  Walk(StackBound& all, uint64_t entry, uint32_t excluded, const FlowGraph& graph,
       int64_t begin = 0)
      : all_(all),
        entry_(entry),
        excluded_(excluded),
        graph_(graph),
        begin_(begin),
        states_(graph.instructions.size()),
        visits_(graph.instructions.size(), 0) {}

  Bound run() {
    call_.way = {entry_};
    states_[0].emplace(all_.machine_, begin_);
    work_ = {0};
    while (!work_.empty() && !problem_) {
      const uint32_t node = work_.back();
      work_.pop_back();
      step(node);
    }
    if (problem_) {
      return std::unexpected(*problem_);
    }
    // Each recursive call begins at the depth of the deepest of them.
    call_.bytes += (all_.knowledge_.at_once(all_.image_.symbolAt(entry_)) - 1) * to_itself_;
    return call_;
  }

 private:
  static constexpr uint32_t kMostVisits = 64;  // beyond it the stack grows in a loop

  void step(uint32_t node) {
    const Instruction& one = all_.image_.code()[graph_.instructions[node]];
    const StackState state = *states_[node];
    const StackState met = state.under(one.stack);
    if (++visits_[node] > kMostVisits) {
      give("the stack may grow in a loop of", one);
    } else if (!met.depth()) {
      give("it is not known how deep the stack is in", one);
    } else if (!one.stack.stops) {
      take(node, one, state, met);
    }
  }

  /// Follows an instruction that begins at a known depth.
  void take(uint32_t node, const Instruction& one, const StackState& state, const StackState& met) {
    switch (one.flow) {
      case Flow::Call:
      case Flow::CallByPointer:
        return call(node, one, state, *met.depth());
      case Flow::JumpByPointer:
        return leave(one, met);
      case Flow::ReturnIf:
        go(node, state.passing(one.stack));
        return finish(one, met);
      case Flow::Return:
        return finish(one, met);
      case Flow::Next:
      case Flow::Jump:
      case Flow::JumpIf:
      case Flow::JumpByTable:
      case Flow::JumpAhead:
      case Flow::JumpAheadIf:
      case Flow::Unknown:
        break;
    }
    pass(node, one, state);
  }

  void pass(uint32_t node, const Instruction& one, StackState state) {
    const int64_t kernel = one.stack.enters_kernel ? all_.machine_.kernel_bytes : 0;
    deepen(state.under(one.stack).depth().value_or(0) + kernel, {});
    state.apply(one.stack);
    go(node, state);
  }

  void call(uint32_t node, const Instruction& one, StackState state, int64_t depth) {
    const int64_t below = depth + all_.machine_.call_bytes;
    if (one.flow == Flow::Call && one.target == one.address + one.size) {
      state.apply({.to = all_.machine_.pointer,
                   .from = all_.machine_.pointer,
                   .bytes = all_.machine_.call_bytes});
      return go(node, state);  // position-independent code finds its own address this way
    }
    if (isPart(one)) {
      return callPart(node, one, state, below);
    }
    if (const auto called = callee(one, below)) {
      deepen(below + static_cast<int64_t>(called->bytes), called->way);
      state.call(called->released);
      if (called->returns || one.stack.conditional()) {
        go(node, state);
      }
    }
  }

  /// Whether it calls a part of the function that contains it, as the compiler's arithmetic does.
  [[nodiscard]] bool isPart(const Instruction& one) const {
    const uint64_t start = all_.image_.startOfSymbol(one.address);
    return one.flow == Flow::Call && start != 0 && one.target != start &&
           all_.image_.startOfSymbol(one.target) == start;
  }

  /// A part may release its function's stack and return in its place.
  void callPart(uint32_t node, const Instruction& one, StackState state, int64_t below) {
    const auto graph = FlowGraph::asFarAsKnown(all_.image_, one.target);
    if (!graph || begin_ != 0) {
      return give("it is not known what calls of its own parts do in", one);
    }
    Walk part(all_, one.target, excluded_, *graph, below);
    const Bound called = part.run();
    if (!called) {
      problem_ = called.error();
      return;
    }
    deepen(static_cast<int64_t>(called->bytes), {});
    if (part.ends_caller_) {
      ends(true, 0);
    }
    state.call(called->released);
    if (called->returns || one.stack.conditional()) {
      go(node, state);
    }
  }

  /// Follows a jump to another function, which returns in this one's place.
  void leave(const Instruction& one, const StackState& met) {
    const int64_t depth = *met.depth();
    const bool known = one.pointer != StackEffect::kNone;  // by PointerJumps
    if (depth != begin_ && !known) {
      return give("it is not known where a jump leads in", one);
    }
    if (const auto called = callee(one, depth)) {
      deepen(depth + static_cast<int64_t>(called->bytes), called->way);
      if (called->returns && depth != begin_) {
        return give("the stack is not restored by", one);
      }
      ends(called->returns, called->released);
    }
  }

  void finish(const Instruction& one, StackState met) {
    StackEffect effect = one.stack;
    std::ranges::fill(effect.condition, 0);
    met.apply(effect);
    if (met.depth() == begin_) {
      ends(true, one.stack.released);
    } else if (met.depth() == 0) {
      ends_caller_ = true;
    } else {
      give("the stack is not restored by", one);
    }
  }

  void ends(bool returns, uint32_t released) {
    if (returns) {
      call_.released = call_.returns ? std::min(call_.released, released) : released;
      call_.returns = true;
    }
  }

  /// The needs of the function called from depth `below`; empty if there is no bound, with the
  /// reason in `problem_`.
  std::optional<Call> callee(const Instruction& one, int64_t below) {
    std::vector<uint64_t> targets = {one.target};
    if (one.flow != Flow::Call) {
      targets = all_.knowledge_.pointers(one.address, excluded_);
    }
    Call most{.bytes = 0, .way = {}, .released = UINT32_MAX, .returns = targets.empty()};
    for (const uint64_t target : targets) {
      const auto found = calledAt(target, below);
      if (!found) {
        problem_ = found.error();
        return std::nullopt;
      }
      if (found->bytes >= most.bytes) {
        most.bytes = found->bytes;
        most.way = found->way;
      }
      most.released = found->returns ? std::min(most.released, found->released) : most.released;
      most.returns = most.returns || found->returns;
    }
    most.released = most.released == UINT32_MAX ? 0 : most.released;
    return most;
  }

  Bound calledAt(uint64_t target, int64_t below) {
    if (target == entry_ && all_.knowledge_.at_once(all_.image_.symbolAt(entry_)) > 1) {
      to_itself_ = std::max(to_itself_, static_cast<uint64_t>(std::max<int64_t>(below, 0)));
      return Call{.bytes = 0, .way = {}, .released = 0, .returns = true};
    }
    return all_.bound(target, excluded_);
  }

  void go(uint32_t node, const StackState& state) {
    if (graph_.lost.contains(node)) {
      problem_ =
          FlowGraph::whyLost(all_.image_, all_.image_.code()[graph_.instructions[node]].address);
      return;
    }
    deepen(state.depth().value_or(0), {});
    for (const uint32_t next : graph_.next[node]) {
      if (!states_[next]) {
        states_[next] = state;
        work_.push_back(next);
      } else if (states_[next]->join(state)) {
        work_.push_back(next);
      }
    }
  }

  void deepen(int64_t bytes, const std::vector<uint64_t>& way) {
    if (bytes > static_cast<int64_t>(call_.bytes)) {
      call_.bytes = static_cast<uint64_t>(bytes);
      call_.way = {entry_};
      call_.way.insert(call_.way.end(), way.begin(), way.end());
    }
  }

  void give(const char* what, const Instruction& one) {
    problem_ =
        fmt::format("{} `{}` at {:#x}", what, all_.image_.baseNameAt(one.address), one.address);
  }

  StackBound& all_;
  uint64_t entry_;
  uint32_t excluded_;
  const FlowGraph& graph_;
  int64_t begin_;
  bool ends_caller_ = false;  // a part has returned in its function's place
  std::vector<std::optional<StackState>> states_;
  std::vector<uint32_t> visits_;
  std::vector<uint32_t> work_;
  std::optional<std::string> problem_;
  uint64_t to_itself_ = 0;
  Call call_;
};

StackBound::StackBound(const Image& image, const StackMachine& machine, CallKnowledge knowledge)
    : image_(image), machine_(machine), knowledge_(std::move(knowledge)) {}

StackBound::Bound StackBound::bound(uint64_t entry) {
  return bound(entry, 0);
}

/// `excluded`: by the functions that are active where it is called. A function may be met again
/// within itself where more is excluded; that does not go on for ever, for there are only so many
/// groups.
StackBound::Bound StackBound::bound(uint64_t entry, uint32_t excluded) {
  const std::pair place(entry, excluded | knowledge_.excluded(entry));
  const auto known = known_.find(place);
  if (known != known_.end()) {
    return known->second;
  }
  known_.emplace(place,
                 std::unexpected(fmt::format("`{}` may call itself", image_.baseNameAt(entry))));
  Bound found = walk(entry, place.second);
  known_.insert_or_assign(place, found);
  return found;
}

StackBound::Bound StackBound::walk(uint64_t entry, uint32_t excluded) {
  const auto graph = FlowGraph::asFarAsKnown(image_, entry);
  return graph ? Walk(*this, entry, excluded, *graph).run() : std::unexpected(graph.error());
}

}  // namespace glider::codegen
