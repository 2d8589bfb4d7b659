// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

namespace glider::report::picture {

/// A linear scale between values and places on the page.
class Axis {
 public:
  /// Value `from` lies at `from_px`, value `to` at `to_px`; the values differ.
  Axis(double from, double to, double from_px, double to_px)
      : from_(from), to_(to), from_px_(from_px), to_px_(to_px) {}
  [[nodiscard]] double at(double value) const {
    return from_px_ + (value - from_) / (to_ - from_) * (to_px_ - from_px_);
  }
  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }

 private:
  double from_, to_, from_px_, to_px_;
};

/// The least of 1, 2, 5 times a power of ten that fits into `span` (> 0) at most `most` times.
double niceStep(double span, int most);
/// The multiples of `step` from `from` to `to` (from <= to), both included.
std::vector<double> ticks(double from, double to, double step);
/// A tick's number with as many decimals as `step` has.
std::string tickText(double value, double step);

}  // namespace glider::report::picture
