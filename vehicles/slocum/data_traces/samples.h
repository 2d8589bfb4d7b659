// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_tables/merge.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace glider::slocum {

/// The updates of one sensor, by time. NaN: the vehicle says that the value is not known.
struct Samples {
  std::vector<double> times_s;  ///< since 1970
  std::vector<double> values;

  [[nodiscard]] bool empty() const { return times_s.empty(); }
  /// The number of samples at or before `time_s`.
  [[nodiscard]] size_t countUntil(double time_s) const;
  /// The value at exactly `time_s`; NaN if there is none.
  [[nodiscard]] double at(double time_s) const;
};

/// The updates of the sensor `name` in `unit`, or as they are if it is "" or not related to the
/// sensor's; none if it was not logged. Values by which the vehicle marks a sensor as unset
/// (69696969) are NaN.
Samples samplesOf(const Merged& merged, std::string_view name, std::string_view unit = "");

/// Two records of a vehicle that follow each other are closer than this, s.
inline constexpr double kNear = 10;
/// Longer than this, s, nothing is known about a quantity that changes continuously, and without a
/// record nothing about the vehicle. It is five times the interval of records in the sparsest logs
/// of real vehicles (64 s in comet's .sbd): one that is missing, or the change of segments at the
/// surface (up to 250 s there), does not count.
inline constexpr double kLongestGap = 300;

/// What a quantity is between two samples.
enum class Between : uint8_t {
  Line,     ///< on the straight line from one to the next
  Angle,    ///< as Line, the shorter way round, from 0 to 2 pi
  Hold,     ///< as the last one
  Nothing,  ///< it is known only at the time of a sample
};

/// The quantity at `times_s`; NaN where it is not known, and at more than `longest_gap_s` from a
/// sample on either side (Hold: from the last one).
std::vector<double> resampled(const Samples& samples, const std::vector<double>& times_s,
                              Between between, double longest_gap_s = kLongestGap);

}  // namespace glider::slocum
