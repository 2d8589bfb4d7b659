// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/plan/grid.h"

#include "report/picture/axis.h"
#include "support/rounded.h"
#include "support/units/units.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace glider::analysis {
namespace {

/// More values than are worth counting.
constexpr double kTooMany = 1e6;
/// Ends that differ by less are the same: of a step, by rounding.
constexpr double kSame = 1e-9;

std::string unitOf(const frontend::OpenChoice& choice) {
  if (!choice.unit.empty()) {
    return choice.unit;
  }
  constexpr double kMinute_s = 60, kHour_s = 3600;
  if (choice.type.dimension == support::dimension::time) {
    return choice.highest >= 2 * kHour_s ? "h" : choice.highest >= 2 * kMinute_s ? "min" : "s";
  }
  const auto bare = support::bareUnit(choice.type.dimension);
  return bare ? std::string(bare->spelling) : "";
}

/// The nearest number of few digits that, as it is read, is within the range.
double readable(double value, double to_si, const frontend::OpenChoice& choice) {
  constexpr int kFewDigits = 10, kAllDigits = 17;
  for (int digits = kFewDigits; digits <= kAllDigits; ++digits) {
    const double number = support::rounded(value, digits);
    if (number * to_si >= choice.lowest && number * to_si <= choice.highest) {
      return number;
    }
  }
  return value;
}

std::vector<double> byStep(double lowest, double highest, double step) {
  std::vector<double> values;
  const double most = std::min(std::floor((highest - lowest) / step + kSame), kTooMany);
  for (double i = 0; i <= most; ++i) {
    values.push_back(lowest + i * step);
  }
  return values;
}

std::vector<double> roundValues(double lowest, double highest) {
  if (lowest == highest) {
    return {lowest};
  }
  const double step = report::picture::niceStep(highest - lowest, PlanGrid::kUsualValues - 2);
  std::vector<double> values{lowest};
  for (const double tick : report::picture::ticks(lowest, highest, step)) {
    if (tick > lowest + kSame * step && tick < highest - kSame * step) {
      values.push_back(tick);
    }
  }
  values.push_back(highest);
  return values;
}

}  // namespace

PlanGrid::PlanGrid(std::span<const frontend::OpenChoice> choices) {
  for (const frontend::OpenChoice& choice : choices) {
    const std::string unit = unitOf(choice);
    const auto known = support::parseUnit(unit);
    const double to_si = known ? known->to_si : 1;
    const double lowest = choice.lowest / to_si, highest = choice.highest / to_si;
    std::vector<double> values = choice.step > 0 ? byStep(lowest, highest, choice.step / to_si)
                                                 : roundValues(lowest, highest);
    for (double& value : values) {
      value = readable(value, to_si, choice);
    }
    rows_.push_back({choice.name, unit, std::move(values)});
  }
}

double PlanGrid::count() const {
  double product = 1;
  for (const Row& row : rows_) {
    product *= static_cast<double>(row.values.size());
  }
  return product;
}

std::vector<compiler::ChosenValue> PlanGrid::at(size_t number) const {
  std::vector<compiler::ChosenValue> values(rows_.size());
  for (size_t i = rows_.size(); i > 0; --i) {
    const Row& row = rows_[i - 1];
    values[i - 1] = {row.name, row.values[number % row.values.size()], row.unit};
    number /= row.values.size();
  }
  return values;
}

}  // namespace glider::analysis
