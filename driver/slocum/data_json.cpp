// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/slocum/data_json.h"

#include "vehicles/slocum/data_tables/merge.h"

#include <cmath>
#include <cstdint>

namespace glider::driver {
namespace {

const char* wordFor(slocum::Computer computer) {
  return computer == slocum::Computer::Flight ? "flight" : "science";
}

Json filesOf(const std::vector<slocum::LogFile>& files) {
  Json all = Json::array();
  for (const slocum::LogFile& file : files) {
    const auto [begin, end] = file.span();
    all.push_back({{"file", file.path.string()},
                   {"computer", wordFor(file.data.computer)},
                   {"mission", file.data.header.mission},
                   {"segment", file.data.header.full_name},
                   {"begin_s", numberOrNull(begin)},
                   {"end_s", numberOrNull(end)},
                   {"records", file.data.records}});
  }
  return all;
}

Json sensorsOf(const std::vector<slocum::LogFile>& files,
               const std::vector<std::string>& patterns) {
  Json all = Json::array();
  const slocum::Merged merged = slocum::merge(files, patterns);
  for (size_t column = 0; column < merged.columns.size(); ++column) {
    uint64_t updates = 0;
    double least = NAN;
    double greatest = NAN;
    double last = slocum::initialValue(merged, column);
    merged.forEachUpdateOf(column, [&](uint32_t, double value) {
      ++updates;
      last = value;
      least = std::fmin(least, value);  // a NaN counts as missing
      greatest = std::fmax(greatest, value);
    });
    const slocum::MergedColumn& one = merged.columns[column];
    all.push_back({{"name", one.name},
                   {"unit", one.sensor.unit},
                   {"computer", wordFor(one.computer)},
                   {"updates", updates},
                   {"min", numberOrNull(least)},
                   {"max", numberOrNull(greatest)},
                   {"last", numberOrNull(last)}});
  }
  return all;
}

}  // namespace

void putVehicles(Json& document, const std::vector<std::vector<slocum::LogFile>>& vehicles,
                 const std::vector<std::string>& patterns) {
  document["vehicles"] = Json::array();
  for (const auto& files : vehicles) {
    document["vehicles"].push_back({{"vehicle", files[0].vehicle},
                                    {"files", filesOf(files)},
                                    {"sensors", sensorsOf(files, patterns)}});
  }
}

}  // namespace glider::driver
