// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::ir {

/// A window over a leg as ir/README.md defines it, which keeps every reading: the reference for the
/// runtime's running sums.
class PlainLegs {
 public:
  struct Reading {
    double value = 0;
    double at = 0;
  };

  explicit PlainLegs(const Temporal& window) : window_(window) {}

  /// Empties the window and starts it at mission time `time`, s.
  void start(double time);
  /// A tick; see gliderLegAdvance of runtime/abi/leg.h.
  void advance(double time, double phase, double value, double at, bool fresh);
  /// NaN: unknown.
  [[nodiscard]] double value() const { return value_; }

 private:
  struct Part {
    std::vector<Reading> readings;
    bool whole = false;
  };
  [[nodiscard]] bool isLeg(double phase) const;
  [[nodiscard]] double worth() const;

  Temporal window_;
  Part present_;
  Part last_;
  double begun_ = 0;
  double since_ = 0;  ///< mission time of the start, s
  double phase_ = 0;  ///< NaN: not known yet
  double time_ = 0;   ///< of the newest tick on which the phase was known
  double value_ = 0;
};

}  // namespace glider::ir
