// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace glider::analysis {

/// The values that can be chosen for each line `choose` of a mission, in the units of its text:
/// from the lowest on with the distance that the line names (`by 5 m`); without one, the ends of
/// the range and round numbers between them, at most kUsualValues.
class PlanGrid {
 public:
  static constexpr int kUsualValues = 25;

  explicit PlanGrid(std::span<const frontend::OpenChoice> choices);

  struct Row {
    std::string name;
    std::string unit;
    std::vector<double> values;  ///< in the unit, ascending
  };
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  /// How many ways there are to choose all; infinite where no number can say.
  [[nodiscard]] double count() const;
  /// The way with this number, below count(): the first choice changes slowest.
  [[nodiscard]] std::vector<compiler::ChosenValue> at(size_t number) const;

 private:
  std::vector<Row> rows_;
};

}  // namespace glider::analysis
