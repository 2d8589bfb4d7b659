// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/against/against_logs.h"
#include "ir/eval/interpreter.h"
#include "support/diagnostics/render.h"
#include "tests/support/command.h"
#include "tests/unit/slocum/second_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace glider::analysis {

/// Data files of one vehicle whose values a test states.
class LogBench {
 public:
  static constexpr double kBegin = 1719946527;  ///< the first record, 2024-07-02 18:55:27 UTC
  static constexpr double kNothing = -1e9;      ///< a record that does not update the sensor

  struct Sensor {
    std::string name;
    std::vector<double> values;  ///< one for each record
  };

  /// Writes a file with a record at each of `times_s` after kBegin.
  void write(const std::string& file, const std::string& clock, const std::vector<double>& times_s,
             const std::vector<Sensor>& sensors) {
    slocum::second::Draft draft;
    draft.extension = file.substr(file.size() - 3);
    draft.sensors.push_back({clock, "timestamp", 8, true});
    draft.rows.push_back({{'*', kBegin}});  // the record of initial values
    for (const double time : times_s) {
      draft.rows.push_back({{'*', kBegin + time}});
    }
    for (const Sensor& sensor : sensors) {
      draft.sensors.push_back({sensor.name, "x", 8, true});
      draft.rows[0].push_back({'*', 0});
      for (size_t i = 0; i < times_s.size(); ++i) {
        const double value = sensor.values.at(i);
        draft.rows[i + 1].push_back(value == kNothing ? slocum::second::Cell{}
                                                      : slocum::second::Cell{'*', value});
      }
    }
    (void)folder_.write(file, slocum::second::write(draft));
  }
  void flight(const std::vector<double>& times_s, const std::vector<Sensor>& sensors) {
    write("a.dbd", "m_present_time", times_s, sensors);
  }
  void science(const std::vector<double>& times_s, const std::vector<Sensor>& sensors) {
    write("a.ebd", "sci_m_present_time", times_s, sensors);
  }
  /// Records every 4 s with these depths.
  void dive(const std::vector<double>& depths_m, std::vector<Sensor> others = {}) {
    std::vector<double> times_s;
    for (size_t i = 0; i < depths_m.size(); ++i) {
      times_s.push_back(4.0 * static_cast<double>(i));
    }
    others.insert(others.begin(), {"m_depth", depths_m});
    flight(times_s, others);
  }

  /// The mission `text`, without its name, along the files.
  [[nodiscard]] report::AgainstLogs run(const std::string& text) {
    return runAlong(text, {folder_.path()});
  }
  /// The same along other files, whose sensor lists are in `caches`.
  [[nodiscard]] report::AgainstLogs runAlong(
      const std::string& text, const std::vector<std::filesystem::path>& files,
      const std::vector<std::filesystem::path>& caches = {}) {
    auto compiled = compiler::compileText("test.mission", "mission test\n" + text);
    EXPECT_TRUE(compiled.has_value());
    compilation_ = std::move(*compiled);
    if (!compilation_.checked) {
      ADD_FAILURE() << support::render(compilation_.diagnostics, *compilation_.sources, false);
      return {};
    }
    slocum::SensorLists lists(caches);
    const slocum::LogFiles logs = slocum::readLogFiles(files, lists);
    EXPECT_TRUE(logs.failures.empty());
    auto against = runAgainstLogs(*compilation_.checked, logs.files,
                                  ir::defaultParameters(compilation_.checked->mission()));
    EXPECT_TRUE(against.has_value());
    return against.value_or(report::AgainstLogs{});
  }
  [[nodiscard]] std::string textOf(const report::AgainstLogs& against) const {
    return report::againstText(against, *compilation_.sources);
  }

 private:
  tests::TemporaryFolder folder_;
  compiler::Compilation compilation_;
};

}  // namespace glider::analysis
