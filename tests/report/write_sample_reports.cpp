// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Writes one report for each sample flight into the folder given, for the browser test and for
// looking at.

#include "report/report.h"
#include "report/summary.h"
#include "tests/report/sample_trace.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <limits>
#include <string>
#include <utility>

namespace {

glider::support::Trace oneRow() {
  glider::support::Trace trace = glider::report::sampleTrace();
  trace.rows.resize(trace.columns.size());
  trace.events.resize(1);
  return trace;
}

/// The first part of the sample, on a map of a few hundred metres.
glider::support::Trace shortFlight() {
  glider::support::Trace trace = glider::report::sampleTrace();
  constexpr size_t kRows = 380;
  trace.rows.resize(trace.columns.size() * kRows);
  return trace;
}

/// The log of a vehicle without the records of its second quarter.
glider::support::Trace logWithGap() {
  glider::support::Trace trace = glider::report::logTrace();
  const size_t from = trace.rowCount() / 4, to = trace.rowCount() / 2, width = trace.columns.size();
  trace.log->gaps = {{trace.at(from, 0), trace.at(to, 0)}};
  const auto row = [&](size_t number) {
    return trace.rows.begin() + static_cast<std::ptrdiff_t>(number * width);
  };
  trace.rows.erase(row(from + 2), row(to));
  std::fill(row(from + 1) + 1, row(from + 2), std::numeric_limits<double>::quiet_NaN());
  return trace;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace glider::report;
  if (argc != 2) {
    std::cerr << "usage: write_sample_reports FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  const std::pair<const char*, glider::support::Trace> samples[] = {
      {"sample", sampleTrace()},
      {"hostile", hostileTrace()},
      {"bare", bareTrace()},
      {"one_row", oneRow()},
      {"empty", {}},
      {"short", shortFlight()},
      {"long", longTrace(100'000)},
      {"science", scienceTrace()},
      {"crowded", crowdedTrace()},
      {"log", logTrace()},
      {"log_gap", logWithGap()},
  };
  for (const auto& [name, trace] : samples) {
    const auto path = folder / (std::string(name) + ".html");
    if (auto written = writeReport(trace, path); !written) {
      std::cerr << written.error().message << '\n';
      return 1;
    }
    std::cout << path.string() << ": " << std::filesystem::file_size(path) << " bytes\n";
  }
  std::cout << summarize(sampleTrace());
}
