// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_traces/samples.h"

#include "vehicles/slocum/data_tables/log_units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace glider::slocum {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
// The vehicle's own value for a position or a time that was never set; a float has only 7 digits.
constexpr double kUnset = 69696960;

/// The angle `part` of the way from `from` to `to`, the shorter way round.
double angleBetween(double from, double to, double part) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double way = std::remainder(to - from, kTurn);
  const double angle = std::fmod(from + part * way, kTurn);
  return angle < 0 ? angle + kTurn : angle;
}

/// The quantity between samples `i - 1` and `i`, of which either may not exist.
double between(const Samples& samples, size_t i, double time_s, Between kind, double longest_s) {
  const bool has_before = i > 0, has_after = i < samples.times_s.size();
  const double before = has_before ? samples.times_s[i - 1] : kNoValue;
  const double after = has_after ? samples.times_s[i] : kNoValue;
  if (has_before && has_after && after - before <= longest_s) {
    const double part = (time_s - before) / (after - before);
    const double from = samples.values[i - 1], to = samples.values[i];
    return kind == Between::Angle ? angleBetween(from, to, part) : from + part * (to - from);
  }
  // At the end of what is known, a record of the other computer may be a little later or earlier.
  if (has_before && time_s - before <= kNear) {
    return samples.values[i - 1];
  }
  return has_after && after - time_s <= kNear ? samples.values[i] : kNoValue;
}

}  // namespace

size_t Samples::countUntil(double time_s) const {
  return static_cast<size_t>(std::ranges::upper_bound(times_s, time_s) - times_s.begin());
}

double Samples::at(double time_s) const {
  const size_t count = countUntil(time_s);
  return count > 0 && times_s[count - 1] == time_s ? values[count - 1] : kNoValue;
}

Samples samplesOf(const Merged& merged, std::string_view name, std::string_view unit) {
  const auto column = std::ranges::find_if(
      merged.columns, [&](const MergedColumn& one) { return isSameName(one.name, name); });
  if (column == merged.columns.end()) {
    return {};
  }
  const double factor = unit.empty() ? 1 : factorBetween(column->sensor.unit, unit).value_or(1);
  std::vector<std::pair<uint32_t, double>> updates;
  merged.forEachUpdateOf(static_cast<size_t>(column - merged.columns.begin()),
                         [&](uint32_t row, double value) { updates.emplace_back(row, value); });
  std::ranges::sort(updates, {}, &std::pair<uint32_t, double>::first);
  Samples samples;
  for (const auto& [row, value] : updates) {
    const double time = merged.rows[row].time;
    if (std::isnan(time)) {
      continue;
    }
    if (samples.empty() || samples.times_s.back() != time) {
      samples.times_s.push_back(time);
      samples.values.emplace_back();
    }
    const bool known = std::isfinite(value) && std::fabs(value) < kUnset;
    samples.values.back() = known ? value * factor : kNoValue;
  }
  return samples;
}

std::vector<double> resampled(const Samples& samples, const std::vector<double>& times_s,
                              Between kind, double longest_gap_s) {
  std::vector<double> values;
  values.reserve(times_s.size());
  for (const double time : times_s) {
    const size_t count = samples.countUntil(time);
    const double before = count > 0 ? samples.times_s[count - 1] : kNoValue;
    if (before == time) {
      values.push_back(samples.values[count - 1]);
    } else if (kind == Between::Nothing) {
      values.push_back(kNoValue);
    } else if (kind == Between::Hold) {
      values.push_back(time - before <= longest_gap_s ? samples.values[count - 1] : kNoValue);
    } else {
      values.push_back(between(samples, count, time, kind, longest_gap_s));
    }
  }
  return values;
}

}  // namespace glider::slocum
