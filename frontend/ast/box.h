// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_range.h"

#include <memory>
#include <utility>

namespace glider::ast {

/// A T on the heap with value semantics, so that a node may contain nodes of its own kind. Never
/// empty, except when moved from.
template <typename T>
class Box {
 public:
  Box(T value)
      : value_(std::make_unique<T>(std::move(value))) {}  // NOLINT: a box of T is made from a T
  Box(const Box& other) : value_(std::make_unique<T>(*other)) {}
  Box(Box&&) noexcept = default;
  Box& operator=(const Box& other) { return *this = Box(other); }
  Box& operator=(Box&&) noexcept = default;
  ~Box() = default;

  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }
  T& operator*() { return *value_; }
  T* operator->() { return value_.get(); }
  bool operator==(const Box& other) const { return *value_ == *other.value_; }

 private:
  std::unique_ptr<T> value_;
};

/// The place of a node in its file. Two nodes that differ only in their places are the same
/// mission, so all places are equal.
struct Where : support::SourceRange {
  Where() = default;
  Where(support::SourceRange range)
      : support::SourceRange(range) {}  // NOLINT: a place, nothing more
  bool operator==(const Where&) const { return true; }
};

}  // namespace glider::ast
