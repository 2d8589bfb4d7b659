// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_tables/doubts.h"

#include "support/diagnostics/ids/vehicle.h"
#include "support/utc.h"
#include "vehicles/slocum/data_tables/dddmm.h"
#include "vehicles/slocum/data_tables/log_units.h"
#include "vehicles/slocum/data_tables/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>

namespace glider::slocum {
namespace {

using support::Failure;

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
// UTC, s: a clock before it was not set, one after it is damaged.
constexpr double kYear2000 = 946684800, kYear2100 = 4102444800;
constexpr double kFurthest = 60 * 86400.0;  // s from the middle of a file

/// Whether a time can be written as a date.
bool isOfUtc(double time) {
  return std::fabs(time) < kYear2100;
}

bool isOfThisCentury(double time) {
  return time > kYear2000 && time < kYear2100;
}

/// The middle one of the times that may be right; NaN if there is none.
double middleOf(const std::vector<double>& times) {
  std::vector<double> good;
  std::ranges::copy_if(times, std::back_inserter(good), isOfThisCentury);
  if (good.empty()) {
    return kNotKnown;
  }
  const auto middle = good.begin() + static_cast<ptrdiff_t>(good.size() / 2);
  std::ranges::nth_element(good, middle);
  return *middle;
}

void leaveOutTimesOf(LogFile& file, std::vector<Failure>& warnings) {
  const double middle = middleOf(file.times);
  size_t count = 0;
  double first = kNotKnown;
  file.left_out.assign(file.times.size(), false);
  for (size_t i = file.first; i < file.times.size(); ++i) {
    const double time = file.times[i];
    const bool wild =
        !std::isnan(time) && !(isOfThisCentury(time) && std::fabs(time - middle) <= kFurthest);
    file.left_out[i] = wild;
    first = wild && count == 0 ? time : first;
    count += wild ? 1U : 0U;
  }
  if (count > 0) {
    warnings.push_back(support::fail(support::diagnostics::timesLeftOut, file.path.string(), count,
                                     file.times.size() - file.first,
                                     isOfUtc(first) ? support::utcText(first)
                                                    : fmt::format("{} s since 1970", first))
                           .error());
  }
}

/// A place at a time, by the GPS or by dead reckoning.
struct Place {
  double time = 0, lat = 0, lon = 0;
  size_t file = 0;
  uint32_t record = 0;
};

constexpr double kMetresPerDegree = 111195;

double distance(const Place& a, const Place& b) {
  const double north = (b.lat - a.lat) * kMetresPerDegree;
  const double east = std::remainder(b.lon - a.lon, 360) * kMetresPerDegree *
                      std::cos((a.lat + b.lat) / 2 * std::numbers::pi / 180);
  return std::hypot(north, east);
}

size_t columnOf(const DataFile& data, std::string_view name) {
  const auto found = std::ranges::find_if(
      data.columns, [&](const Column& column) { return isSameName(column.sensor.name, name); });
  return static_cast<size_t>(found - data.columns.begin());
}

/// Where both of a pair of sensors were updated, by time. A position that the vehicle itself calls
/// unset is none; one that is nowhere on Earth has NaN.
std::vector<Place> placesOf(std::span<const LogFile> files, const char* lat, const char* lon) {
  constexpr double kUnset = 69696960;
  std::vector<Place> places;
  for (size_t i = 0; i < files.size(); ++i) {
    const LogFile& file = files[i];
    const size_t north = columnOf(file.data, lat), east = columnOf(file.data, lon);
    const size_t count = file.data.columns.size();
    if (file.data.computer != Computer::Flight || north == count || east == count) {
      continue;
    }
    std::map<uint32_t, double> longitudes;
    forEachUpdate(file.data, east,
                  [&](uint32_t record, Update, double value) { longitudes[record] = value; });
    forEachUpdate(file.data, north, [&](uint32_t record, Update, double value) {
      const auto found = longitudes.find(record);
      const bool known = found != longitudes.end() && std::fabs(value) < kUnset &&
                         std::fabs(found->second) < kUnset && std::isfinite(file.times[record]);
      if (known && record >= file.first && !file.isLeftOut(record)) {
        const double at_lat = degreesOf(value), at_lon = degreesOf(found->second);
        const bool on_earth = std::fabs(at_lat) <= 90 && std::fabs(at_lon) <= 180;
        places.push_back({file.times[record], on_earth ? at_lat : kNotKnown,
                          on_earth ? at_lon : kNotKnown, i, record});
      }
    });
  }
  std::ranges::stable_sort(places, {}, &Place::time);
  return places;
}

/// How many of the places around a fix it agrees with, less those that it does not.
class Votes {
 public:
  explicit Votes(const Place& fix) : fix_(fix) {}

  void ask(const Place& other, double slack_m) {
    constexpr double kFastest = 15;  // m/s: also aboard a ship
    const double far = distance(fix_, other);
    if (!std::isnan(far)) {
      sum_ += far <= slack_m + kFastest * std::fabs(other.time - fix_.time) ? 1 : -1;
    }
  }
  [[nodiscard]] bool against() const { return sum_ < 0; }

 private:
  const Place& fix_;
  int sum_ = 0;
};

/// Whether fix `i` cannot be right.
bool isWild(const std::vector<Place>& fixes, size_t i, const std::vector<Place>& reckoned) {
  constexpr size_t kAround = 3;
  constexpr double kFixSlack = 1000, kReckonedSlack = 20000;  // m
  constexpr double kLongest = 3600;                           // s
  const Place& fix = fixes[i];
  if (std::isnan(fix.lat)) {
    return true;
  }
  Votes votes(fix);
  const size_t from = i - std::min(i, kAround), to = std::min(fixes.size(), i + kAround + 1);
  for (size_t other = from; other < to; ++other) {
    if (other != i) {
      votes.ask(fixes[other], kFixSlack);
    }
  }
  const auto after = std::ranges::upper_bound(reckoned, fix.time, {}, &Place::time);
  if (after != reckoned.begin() && fix.time - std::prev(after)->time < kLongest) {
    votes.ask(*std::prev(after), kReckonedSlack);
  }
  if (after != reckoned.end() && after->time - fix.time < kLongest) {
    votes.ask(*after, kReckonedSlack);
  }
  return votes.against();
}

void warnOfFixes(const LogFile& file, size_t fixes, const std::string& first,
                 std::vector<Failure>& warnings) {
  warnings.push_back(support::fail(support::diagnostics::fixesLeftOut, file.path.string(),
                                   file.wild_fixes.size(), fixes, first)
                         .error());
}

}  // namespace

double degreesOf(double dddmm) {
  const double size = std::fabs(dddmm), degrees = std::floor(size / 100);
  const double minutes = size - 100 * degrees;
  return minutes < 60 ? std::copysign(degrees + minutes / 60, dddmm) : kNotKnown;
}

void leaveOutTimes(std::span<LogFile> files, std::vector<Failure>& warnings) {
  const auto has_clock = [](const LogFile& file) { return !std::isnan(middleOf(file.times)); };
  if (std::ranges::any_of(files, has_clock)) {
    for (LogFile& file : files) {
      leaveOutTimesOf(file, warnings);
    }
  }
}

void leaveOutFixes(std::span<LogFile> files, std::vector<Failure>& warnings) {
  const std::vector<Place> fixes = placesOf(files, "m_gps_lat", "m_gps_lon");
  std::vector<Place> reckoned = placesOf(files, "m_lat", "m_lon");
  std::erase_if(reckoned, [](const Place& place) { return std::isnan(place.lat); });
  std::vector<size_t> counts(files.size());
  std::vector<double> first(files.size(), kNotKnown);
  for (size_t i = 0; i < fixes.size(); ++i) {
    const Place& fix = fixes[i];
    ++counts[fix.file];
    if (isWild(fixes, i, reckoned)) {
      first[fix.file] = std::isnan(first[fix.file]) ? fix.time : first[fix.file];
      files[fix.file].wild_fixes.push_back(fix.record);
    }
  }
  for (size_t i = 0; i < files.size(); ++i) {
    std::ranges::sort(files[i].wild_fixes);
    if (!files[i].wild_fixes.empty()) {
      warnOfFixes(files[i], counts[i], support::utcText(first[i]), warnings);
    }
  }
}

void warnOfUnits(std::span<const LogFile> files, std::vector<Failure>& warnings) {
  for (const MergedColumn& column : columnsOf(files)) {
    if (!column.of_other_unit) {
      continue;
    }
    std::string where;
    std::string main_unit;
    for (const LogFile& file : files) {
      const size_t at = columnOf(file.data, column.sensor.name);
      if (file.data.computer == column.computer && at < file.data.columns.size()) {
        const Sensor& sensor = file.data.columns[at].sensor;
        main_unit = main_unit.empty() ? sensor.unit : main_unit;
        if (plainUnit(sensor.unit) == plainUnit(column.sensor.unit) && where.empty()) {
          where = file.path.filename().string();
        }
      }
    }
    warnings.push_back(support::fail(support::diagnostics::unitDiffers, column.sensor.name,
                                     files[0].vehicle,
                                     fmt::format("`{}` at first, and `{}` from `{}` on", main_unit,
                                                 column.sensor.unit, where),
                                     "`" + column.sensor.unit + "`", column.name)
                           .error());
  }
}

}  // namespace glider::slocum
