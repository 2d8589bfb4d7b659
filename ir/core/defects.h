// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/validate.h"

#include <fmt/format.h>

#include <concepts>
#include <string_view>
#include <utility>
#include <vector>

namespace glider::ir {

/// Collects what `validate` finds. A valid mission costs no text: messages are formatted only for
/// defects, and an argument that is a function is called only then.
class Defects {
 public:
  template <typename... Args>
  void require(bool holds, support::SourceRange range, std::string_view message,
               const Args&... args) {
    if (!holds) {
      add(range, message, told(args)...);
    }
  }
  [[nodiscard]] bool empty() const { return found_.empty(); }
  [[nodiscard]] std::vector<Defect> take() { return std::move(found_); }

 private:
  template <typename T>
  static decltype(auto) told(const T& argument) {
    if constexpr (std::invocable<const T&>) {
      return argument();
    } else {
      return (argument);
    }
  }
  template <typename... Args>
  void add(support::SourceRange range, std::string_view message, const Args&... args) {
    found_.push_back({range, fmt::format(fmt::runtime(message), args...)});
  }

  std::vector<Defect> found_;
};

}  // namespace glider::ir
