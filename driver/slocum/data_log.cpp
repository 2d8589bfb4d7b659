// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/slocum/data_log.h"

#include "driver/exit_code.h"
#include "driver/slocum/data_json.h"
#include "driver/slocum/log_report.h"
#include "driver/terminal.h"
#include "support/diagnostics/ids/command.h"
#include "support/diagnostics/ids/vehicle.h"
#include "support/files.h"
#include "vehicles/slocum/data_files/read.h"
#include "vehicles/slocum/data_tables/csv.h"
#include "vehicles/slocum/data_tables/netcdf.h"
#include "vehicles/slocum/data_tables/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>

namespace glider::driver {
namespace {

using slocum::LogFile;
using support::Failure;
using support::Result;

/// The first bytes of a file: enough for one compressed block. Empty if it cannot be read.
std::string beginningOf(const std::string& path) {
  std::string bytes(65538, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

/// The patterns that the names of a vehicle's sensors match; GL9364 for one that none matches.
Result<void> checkPatterns(const std::vector<std::vector<LogFile>>& vehicles,
                           const std::vector<std::string>& patterns) {
  std::vector<std::string> names;
  for (const auto& files : vehicles) {
    for (const slocum::MergedColumn& column : slocum::columnsOf(files)) {
      names.push_back(column.name);
    }
  }
  for (const std::string& pattern : patterns) {
    if (std::ranges::none_of(
            names, [&](const std::string& name) { return slocum::matches(name, pattern); })) {
      return support::fail(support::diagnostics::unknownLoggedSensor, pattern);
    }
  }
  return {};
}

bool hasTables(const DataLogOptions& options) {
  return !options.csv.empty() || !options.netcdf.empty();
}

bool hasDrawings(const DataLogOptions& options) {
  return !options.report.empty() || !options.picture.empty();
}

/// GL9365 if the files are not of one vehicle.
Result<void> checkOneVehicle(const std::vector<std::vector<LogFile>>& vehicles) {
  if (vehicles.size() > 1) {
    std::string names;
    for (const auto& files : vehicles) {
      names += (names.empty() ? "`" : ", `") + files[0].vehicle + "`";
    }
    return support::fail(support::diagnostics::severalVehicles, names);
  }
  return {};
}

Result<void> writeTables(const std::vector<LogFile>& files, const DataLogOptions& options) {
  const slocum::Merged merged = slocum::merge(files, options.sensors);
  if (!options.csv.empty()) {
    const std::string text = slocum::csvOf(merged);
    const auto written =
        options.csv == "-" ? printOut(text) : support::writeFileAtomically(options.csv, text);
    if (!written) {
      return written;
    }
  }
  return options.netcdf.empty() ? Result<void>() : slocum::writeNetcdf(merged, options.netcdf);
}

Result<void> show(const std::vector<std::vector<LogFile>>& vehicles, const DataLogOptions& options,
                  Json* document) {
  if (const auto known = checkPatterns(vehicles, options.sensors); !known) {
    return known;
  }
  if (hasTables(options) || hasDrawings(options)) {
    auto done = checkOneVehicle(vehicles);
    if (done && hasTables(options)) {
      done = writeTables(vehicles[0], options);
    }
    return done && hasDrawings(options) ? drawLog(vehicles[0], options) : done;
  }
  if (document != nullptr) {
    putVehicles(*document, vehicles, options.sensors);
    return {};
  }
  std::string text;
  for (const auto& files : vehicles) {
    text += (text.empty() ? "" : "\n") + slocum::summaryOf(files, options.sensors);
  }
  return printOut(text);
}

/// Damage ends with 1; a file that is missing or fails ends with 2.
int statusOf(const Failure& failure) {
  const bool damage = failure.id == support::diagnostics::notDataFile ||
                      failure.id == support::diagnostics::badSensorList ||
                      failure.id == support::diagnostics::dataFileDamaged;
  return damage ? kMissionHasErrors : kWorldFailed;
}

}  // namespace

bool areDataFiles(const std::vector<std::string>& files) {
  std::error_code ignored;
  return files.size() > 1 || std::filesystem::is_directory(files[0], ignored) ||
         slocum::looksLikeDataFile(files[0], beginningOf(files[0]));
}

int showDataFiles(const DataLogOptions& options, Json* document) {
  slocum::SensorLists lists({options.caches.begin(), options.caches.end()});
  slocum::LogFiles logs = slocum::readLogFiles({options.files.begin(), options.files.end()}, lists);
  for (const std::string& why : logs.skipped) {
    tell("glidercc: note: " + why + "\n");
  }
  std::ranges::for_each(logs.warnings, reportWarning);
  int status = kFine;
  if (!logs.files.empty()) {
    if (const auto shown = show(slocum::byVehicle(std::move(logs.files)), options, document);
        !shown) {
      status = reportFailure(shown.error());
    }
  }
  for (const Failure& failure : logs.failures) {
    (void)reportFailure(failure);
    status = std::max(status, statusOf(failure));
  }
  return status;
}

}  // namespace glider::driver
