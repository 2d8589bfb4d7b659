// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/window_shape.h"

#include <map>

namespace glider::ir {

/// A window as ir/README.md defines it, with memory that grows as needed: the reference for the
/// runtime's ring of bins.
class PlainWindow {
 public:
  explicit PlainWindow(const WindowShape& shape) : shape_(shape) {}

  /// Empties the window and starts it at mission time `time`, s.
  void start(double time);
  /// A tick; see gliderWindowAdvance of runtime/abi/window.h.
  void advance(double time, double along, double value, bool fresh);
  /// NaN: unknown.
  [[nodiscard]] double value() const { return value_; }

 private:
  struct Reading {
    double time = 0;
    double along = 0;
    double value = 0;
  };
  [[nodiscard]] bool covered(double time) const;
  [[nodiscard]] bool within(const Reading& reading, double time, double now) const;
  [[nodiscard]] double workOut(double now) const;

  WindowShape shape_;
  std::map<double, Reading> readings_;  ///< by the number of their bin
  double least_ = 0;                    ///< of all `along` since the start
  double greatest_ = 0;
  bool any_ = false;
  double newest_ = 0;  ///< bin of the newest reading, if there is any
  double since_ = 0;
  double value_ = 0;
};

}  // namespace glider::ir
