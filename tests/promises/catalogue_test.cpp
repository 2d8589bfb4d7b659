// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// docs/promises.md: each promise in its tables is decided as its column says, each proof passes the
// second check, and each counterexample is replayed on an emulated board.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

/// A row of a table, with the mission above it.
struct Row {
  std::string mission;
  std::string name;
  std::string proved;
  std::string refuted;
  friend void PrintTo(const Row& row, std::ostream* out) { *out << row.name; }
};

/// What stands between the first two backticks of a cell.
std::string inBackticks(const std::string& cell) {
  const size_t begin = cell.find('`');
  const size_t end = cell.find('`', begin + 1);
  return end == std::string::npos ? "" : cell.substr(begin + 1, end - begin - 1);
}

std::vector<Row> rows() {
  std::ifstream page(GLIDER_SOURCE_DIR "/docs/promises.md");
  std::vector<Row> all;
  std::string mission;
  bool in_mission = false;
  for (std::string line; std::getline(page, line);) {
    if (line == "```mission") {
      mission.clear();
    } else if (in_mission && line != "```") {
      mission += line + "\n";
    }
    in_mission = line == "```mission" || (in_mission && line != "```");
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; line.starts_with("| ") && std::getline(in, cell, '|');) {
      cells.push_back(cell);
    }
    if (cells.size() >= 5 && !inBackticks(cells[3]).empty()) {
      all.push_back({mission, cells[1] + cells[2], inBackticks(cells[3]), inBackticks(cells[4])});
    }
  }
  return all;
}

class Catalogue : public testing::TestWithParam<Row> {
 protected:
  /// Writes the row's mission with this requirement, and runs the command in its folder.
  Outcome run(const std::string& requirement, const std::string& arguments) const {
    (void)folder_.write("m.mission", GetParam().mission + "\nrequire " + requirement + "\n");
    return runShell("cd '" + folder_.path().string() + "' && $GLIDERCC " + arguments + " 2>&1");
  }

 private:
  TemporaryFolder folder_;
};

TEST_P(Catalogue, IsProvedAndPassesTheSecondCheck) {
  const std::string& requirement = GetParam().proved;
  const Outcome check = run(requirement, "check --report --certificates certificates m.mission");
  EXPECT_EQ(check.status, 0) << check.out;
  EXPECT_NE(check.out.find("proved: require " + requirement), std::string::npos) << check.out;
  const Outcome again = run(requirement, "check --recheck certificates m.mission");
  EXPECT_EQ(again.status, 0) << again.out;
  EXPECT_NE(again.out.find("accepted: "), std::string::npos) << again.out;
}

TEST_P(Catalogue, IsRefutedAndReplayedOnABoard) {
  const std::string& requirement = GetParam().refuted;
  const Outcome check = run(requirement, "check --traces traces m.mission");
  EXPECT_EQ(check.status, 1) << check.out;
  EXPECT_NE(check.out.find("requirement violated: "), std::string::npos) << check.out;
  const Outcome replay =
      run(requirement,
          "sim m.mission --board ts5500 --replay traces/requirement-1/trace.json -o flight");
  EXPECT_EQ(replay.status, 1) << replay.out;
  EXPECT_NE(replay.out.find("violat"), std::string::npos) << replay.out;
}

std::string nameOf(const testing::TestParamInfo<Row>& info) {
  std::string name = std::to_string(info.index);
  for (const char c : info.param.name) {
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? std::string(1, c) : "";
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Page, Catalogue, testing::ValuesIn(rows()), nameOf);

TEST(CataloguePage, HasAllPatterns) {
  size_t patterns = 0;
  for (const Row& row : rows()) {
    patterns += row.name.find_first_of("0123456789") != std::string::npos ? 1U : 0U;
  }
  EXPECT_EQ(patterns, 22U);
}

}  // namespace
}  // namespace glider::tests
