// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/diagnostic.h"
#include "tests/unit/slocum/second_reader.h"
#include "vehicles/slocum/data_files/read.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace glider::slocum {

/// A folder for the files of one test.
class TestFolder {
 public:
  TestFolder()
      : path_(std::filesystem::path(testing::TempDir()) /
              ("data_files_" +
               std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Every width, sensors that are not in the file, and a last state byte with padding.
inline second::Draft smallDraft() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  second::Draft draft;
  draft.sensors = {{"m_present_time", "timestamp", 8, true},
                   {"m_depth", "m", 4, true},
                   {"u_unused", "nodim", 4, false},
                   {"m_gps_status", "enum", 1, true},
                   {"x_short", "nodim", 2, true},
                   {"m_lat", "lat", 8, true},
                   {"m_leak", "bool", 1, true}};
  draft.rows = {
      {{'*', 1.7e9}, {'*', 1.5}, {'*', -1}, {'*', -2}, {'*', -7032.064}, {'*', 127}},
      {{'*', 1.7e9 + 4.25}, {'=', 1.5}, {}, {}, {'*', 3910.5}, {'*', -128}},
      {{'*', 1.7e9 + 8.5}, {'*', -0.25}, {'*', 69}, {'*', 0x1234}, {}, {'=', -128}},
      {{'*', 1.7e9 + 12.5}, {'*', kNan}, {}, {}, {}, {}},
      {{'*', 1.7e9 + 16.5}, {}, {'=', 69}, {'*', -32768}, {'=', 3910.5}, {'*', 1}},
  };
  return draft;
}

/// All cells of a file as the second reader shows them.
inline std::vector<std::vector<second::Cell>> cellsOf(const DataFile& file) {
  std::vector<std::vector<second::Cell>> rows(file.records,
                                              std::vector<second::Cell>(file.columns.size()));
  for (size_t column = 0; column < file.columns.size(); ++column) {
    forEachUpdate(file, column, [&](uint32_t record, Update update, double value) {
      rows[record][column] = {update == Update::New ? '*' : '=', value};
    });
  }
  return rows;
}

/// The first difference between two tables; empty: there is none. Values are compared bit by bit,
/// but any NaN is equal to any other.
inline std::string difference(const std::vector<std::vector<second::Cell>>& a,
                              const std::vector<std::vector<second::Cell>>& b) {
  if (a.size() != b.size()) {
    return std::to_string(a.size()) + " and " + std::to_string(b.size()) + " records";
  }
  for (size_t row = 0; row < a.size(); ++row) {
    if (a[row].size() != b[row].size()) {
      return "other sensors in record " + std::to_string(row);
    }
    for (size_t i = 0; i < a[row].size(); ++i) {
      const second::Cell &x = a[row][i], &y = b[row][i];
      const bool same = (std::isnan(x.value) && std::isnan(y.value)) ||
                        std::bit_cast<uint64_t>(x.value) == std::bit_cast<uint64_t>(y.value);
      if (x.state != y.state || !same) {
        return "record " + std::to_string(row) + ", sensor " + std::to_string(i) + ": " + x.state +
               std::to_string(x.value) + " and " + y.state + std::to_string(y.value);
      }
    }
  }
  return "";
}

}  // namespace glider::slocum
