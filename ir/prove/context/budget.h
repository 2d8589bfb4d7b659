// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>

namespace glider::ir::prove {

/// What the proofs about a mission may take together, in Z3's own count of steps (`rlimit`), to
/// which all else is converted: so what is left undecided does not depend on the machine. A time
/// limit is additional and does depend on it.
class Budget {
 public:
  using Clock = std::chrono::steady_clock;

  /// A question costs this much before Z3 has made a step.
  static constexpr uint64_t kQuestion = 2000;
  /// And this much for each fact or condition that it is given.
  static constexpr uint64_t kCondition = 20;
  /// A rule of a question about all traces.
  static constexpr uint64_t kRule = 500;
  /// A tick of a random flight, and so many expressions of the mission.
  static constexpr uint64_t kTick = 6;
  static constexpr uint64_t kExpressions = 400;
  /// So many operations of the condition that is checked on each tick.
  static constexpr uint64_t kEvaluated = 40;

  explicit Budget(uint64_t steps, std::optional<Clock::time_point> until = std::nullopt)
      : left_(steps), until_(until) {}

  void spend(uint64_t steps) { left_ -= std::min(steps, left_); }
  [[nodiscard]] uint64_t left() const { return isUsedUp() ? 0 : left_; }
  [[nodiscard]] bool isUsedUp() const { return left_ == 0 || isOver(); }
  [[nodiscard]] bool isOver() const { return until_ && Clock::now() >= *until_; }
  /// As much of `wanted` as is left.
  [[nodiscard]] unsigned allow(unsigned wanted) const {
    return static_cast<unsigned>(std::min<uint64_t>(wanted, left()));
  }
  /// For Z3: what is left of the time limit, ms; none if there is no such limit.
  [[nodiscard]] std::optional<unsigned> milliseconds() const {
    if (!until_) {
      return std::nullopt;
    }
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(*until_ - Clock::now());
    constexpr int64_t kLongest = std::numeric_limits<int>::max();
    return static_cast<unsigned>(std::clamp<int64_t>(left.count(), 1, kLongest));
  }

 private:
  uint64_t left_;
  std::optional<Clock::time_point> until_;
};

}  // namespace glider::ir::prove
