// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_tables/log_files.h"

#include "support/counted.h"
#include "support/diagnostics/ids/vehicle.h"
#include "vehicles/slocum/data_files/header.h"
#include "vehicles/slocum/data_files/read.h"
#include "vehicles/slocum/data_tables/doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <tuple>

namespace glider::slocum {
namespace {

namespace fs = std::filesystem;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// The column of the computer's clock; as many as there are columns if there is none.
size_t clockColumn(const DataFile& data) {
  const char* names[] = {"m_present_time", "sci_m_present_time"};
  if (data.computer == Computer::Science) {
    std::swap(names[0], names[1]);
  }
  for (const char* name : names) {
    for (size_t i = 0; i < data.columns.size(); ++i) {
      if (isSameName(data.columns[i].sensor.name, name)) {
        return i;
      }
    }
  }
  return data.columns.size();
}

/// The time of each record: that of the last record which has one.
std::vector<double> timesOf(const DataFile& data) {
  std::vector<double> times(data.records, kUnknown);
  if (const size_t clock = clockColumn(data); clock < data.columns.size()) {
    forEachUpdate(data, clock, [&](uint32_t record, Update, double time) { times[record] = time; });
  }
  for (size_t i = 1; i < times.size(); ++i) {
    times[i] = std::isfinite(times[i]) ? times[i] : times[i - 1];
  }
  return times;
}

LogFile logFile(const fs::path& path, DataFile data) {
  LogFile file;
  file.path = path;
  file.vehicle = vehicleOf(data.header.full_name);
  file.times = timesOf(data);
  file.first = data.beginsWithInitialValues() ? 1 : 0;
  file.data = std::move(data);
  return file;
}

/// Reads paths into a LogFiles.
class Collector {
 public:
  explicit Collector(SensorLists& lists) : lists_(lists) {}

  void add(const fs::path& path) {
    auto data = readDataFile(path, lists_);
    if (data) {
      take(path, std::move(*data));
    } else if (data.error().id == support::diagnostics::sensorListMissing) {
      waiting_.push_back(path);
    } else {
      out.failures.push_back(data.error());
    }
  }

  /// Reads again what waits for a sensor list, which a later file may have brought.
  void finish() {
    for (const fs::path& path : waiting_) {
      if (auto data = readDataFile(path, lists_)) {
        take(path, std::move(*data));
      } else {
        out.failures.push_back(data.error());
      }
    }
  }

  LogFiles out;

 private:
  void take(const fs::path& path, DataFile data) {
    for (const Damage& damage : data.damage) {
      out.failures.push_back(support::fail(support::diagnostics::dataFileDamaged, path.string(),
                                           damage.offset, damage.what,
                                           support::counted(data.records, "record") +
                                               (data.records == 1 ? " was read" : " were read"))
                                 .error());
    }
    out.files.push_back(logFile(path, std::move(data)));
  }

  SensorLists& lists_;
  std::vector<fs::path> waiting_;
};

/// Leaves one file of each computer and segment.
void dropDuplicates(LogFiles& logs) {
  const auto rank = [](const LogFile& file) {
    return std::tuple(file.data.columns.size(), file.data.records, !file.data.compressed);
  };
  std::map<std::pair<std::string, Computer>, size_t> best;
  std::vector<bool> dropped(logs.files.size());
  for (size_t i = 0; i < logs.files.size(); ++i) {
    const DataFile& data = logs.files[i].data;
    const auto [entry, fresh] = best.try_emplace({data.header.full_name, data.computer}, i);
    if (fresh) {
      continue;
    }
    size_t loser = i;
    if (rank(logs.files[i]) > rank(logs.files[entry->second])) {
      std::swap(loser, entry->second);
    }
    dropped[loser] = true;
    const fs::path &left_out = logs.files[loser].path, &kept = logs.files[entry->second].path;
    std::error_code ignored;
    logs.skipped.push_back(fs::equivalent(left_out, kept, ignored)
                               ? fmt::format("`{}` is given twice", left_out.string())
                               : fmt::format("`{}` is left out: `{}` has the same segment",
                                             left_out.string(), kept.string()));
  }
  size_t index = 0;
  std::erase_if(logs.files, [&](const LogFile&) { return dropped[index++]; });
}

/// The computers' clocks differ by up to minutes: a segment begins when the first of its files was
/// opened.
void sortBySegment(std::vector<LogFile>& files) {
  std::map<std::string, double> begin;
  for (const LogFile& file : files) {
    const double opened = timeOf(file.data.header.opened).value_or(0);
    const auto [entry, fresh] = begin.try_emplace(file.data.header.full_name, opened);
    entry->second = std::min(entry->second, opened);
  }
  std::ranges::stable_sort(files, {}, [&](const LogFile& file) {
    const std::string& segment = file.data.header.full_name;
    return std::tuple(file.vehicle, begin[segment], segment, file.data.computer);
  });
}

/// Finds what cannot be right in the files, vehicle by vehicle.
void findDoubts(LogFiles& logs) {
  for (LogFile& file : logs.files) {
    if (file.data.as_text) {
      logs.warnings.push_back(
          support::fail(support::diagnostics::textTransfer, file.path.string()).error());
    }
  }
  const std::span<LogFile> all = logs.files;
  for (size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].vehicle == all[begin].vehicle) {
      ++end;
    }
    const std::span<LogFile> files = all.subspan(begin, end - begin);
    leaveOutTimes(files, logs.warnings);
    leaveOutFixes(files, logs.warnings);
    warnOfUnits(files, logs.warnings);
  }
}

}  // namespace

std::pair<double, double> LogFile::span() const {
  std::pair<double, double> span(kUnknown, kUnknown);
  for (size_t i = first; i < times.size(); ++i) {
    if (std::isfinite(times[i]) && !isLeftOut(i)) {
      span.first = std::isnan(span.first) ? times[i] : std::min(span.first, times[i]);
      span.second = std::isnan(span.second) ? times[i] : std::max(span.second, times[i]);
    }
  }
  return span;
}

LogFiles readLogFiles(const std::vector<fs::path>& paths, SensorLists& lists) {
  Collector collector(lists);
  for (const fs::path& path : paths) {
    if (const auto files = findDataFiles(path)) {
      std::ranges::for_each(*files, [&](const fs::path& file) { collector.add(file); });
    } else {
      collector.out.failures.push_back(files.error());
    }
  }
  collector.finish();
  LogFiles logs = std::move(collector.out);
  dropDuplicates(logs);
  sortBySegment(logs.files);
  findDoubts(logs);
  return logs;
}

std::vector<std::vector<LogFile>> byVehicle(std::vector<LogFile> files) {
  std::vector<std::vector<LogFile>> groups;
  for (LogFile& file : files) {
    if (groups.empty() || groups.back()[0].vehicle != file.vehicle) {
      groups.emplace_back();
    }
    groups.back().push_back(std::move(file));
  }
  return groups;
}

}  // namespace glider::slocum
