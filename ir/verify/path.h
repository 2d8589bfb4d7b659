// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace glider::ir {

/// A `goto` or `call` that can fire.
struct Edge {
  uint32_t from = 0;  ///< the state that is current then
  uint32_t case_index = 0;
  uint32_t to = 0;
  bool call = false;
  bool always = false;  ///< a case of `always`, not of the state
};

/// The transitions of a trace, in order. For a long one only those at both ends are kept, which are
/// the ones reported: so a path costs the same at any length.
class Path {
 public:
  static constexpr size_t kFirst = 6, kLast = 5;

  void append(const Edge& edge) {
    append(1, [&](size_t) { return edge; });
  }
  void append(const Path& more) {
    const std::vector<Edge> early = more.first_, late = more.last_;
    const size_t size = more.size_;
    append(size,
           [&](size_t i) { return i < early.size() ? early[i] : late[late.size() - (size - i)]; });
  }
  /// Appends `count` transitions, of which `at(i)` is number i; calls `at` only for those that are
  /// kept.
  template <typename At>
  void append(size_t count, At at) {
    for (size_t i = 0; i < count && first_.size() < kFirst; ++i) {
      first_.push_back(at(i));
    }
    for (size_t i = count - std::min(count, kLast); i < count; ++i) {
      last_.push_back(at(i));
    }
    last_.erase(last_.begin(), last_.end() - static_cast<ptrdiff_t>(std::min(last_.size(), kLast)));
    size_ += count;
  }

  [[nodiscard]] size_t size() const { return size_; }
  /// Whether transition `i` is kept.
  [[nodiscard]] bool keeps(size_t i) const {
    return i < first_.size() || size_ - i <= last_.size();
  }
  /// Transition `i`, which is kept.
  [[nodiscard]] const Edge& operator[](size_t i) const {
    return i < first_.size() ? first_[i] : last_[last_.size() - (size_ - i)];
  }

 private:
  std::vector<Edge> first_, last_;  ///< they overlap in a short path
  size_t size_ = 0;
};

}  // namespace glider::ir
