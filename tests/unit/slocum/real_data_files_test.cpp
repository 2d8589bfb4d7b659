// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Real files of gliders, both byte orders: our reader and the second one must agree on every value.

#include "support/files.h"
#include "tests/unit/slocum/data_bench.h"

#include <cctype>

namespace glider::slocum {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(GLIDER_SOURCE_DIR) / "../shared/data/dbd";

std::string slurp(const fs::path& path) {
  const auto text = support::readFile(path);
  return text ? *text : "";
}

/// The sensor list with this CRC, among all that are there.
std::string listOf(const std::string& crc) {
  for (const auto& entry : fs::recursive_directory_iterator(kFolder)) {
    if (entry.path().filename() == crc + ".cac") {
      return slurp(entry.path());
    }
  }
  return "";
}

class RealDataFiles : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kFolder)) {
      GTEST_SKIP() << "the real data files are not here: " << kFolder;
    }
  }
};

TEST_F(RealDataFiles, AreReadAsTheSecondReaderReadsThem) {
  size_t files = 0, values = 0;
  SensorLists lists;
  for (const fs::path& folder : {kFolder, kFolder / "little-endian"}) {
    const auto paths = findDataFiles(folder);
    ASSERT_TRUE(paths);
    for (const fs::path& path : *paths) {
      const auto file = readDataFile(path, lists);
      ASSERT_TRUE(file) << file.error().message;
      EXPECT_TRUE(file->damage.empty()) << path << ": " << file->damage[0].what;
      const std::string bytes = slurp(path);
      const second::Table table =
          second::read(file->compressed ? second::unpack(bytes) : bytes, listOf);
      EXPECT_EQ(table.problem, "") << path;
      EXPECT_EQ(file->order, table.big_endian ? ByteOrder::Big : ByteOrder::Little);
      EXPECT_EQ(difference(cellsOf(*file), table.rows), "") << path;
      ASSERT_EQ(file->columns.size(), table.sensors.size());
      for (size_t i = 0; i < table.sensors.size(); ++i) {
        EXPECT_EQ(file->columns[i].sensor.name, table.sensors[i].name);
        EXPECT_EQ(file->columns[i].sensor.unit, table.sensors[i].unit);
        values += file->columns[i].values.size();
      }
      ++files;
    }
  }
  EXPECT_GE(files, 18U);
  EXPECT_GT(values, 400000U);
}

TEST_F(RealDataFiles, PlainAndCompressedSegmentsAreTheSame) {
  SensorLists lists;
  for (const auto& [plain, compressed, records] : {std::tuple{"01600001.dbd", "01600001.dcd", 303U},
                                                   {"01600001.ebd", "01600001.ecd", 1344U}}) {
    const auto a = readDataFile(kFolder / "little-endian" / plain, lists);
    const auto b = readDataFile(kFolder / "little-endian" / compressed, lists);
    ASSERT_TRUE(a && b);
    EXPECT_TRUE(b->compressed && !a->compressed);
    EXPECT_EQ(a->records, records);
    EXPECT_EQ(a->header.full_name, b->header.full_name);
    EXPECT_EQ(difference(cellsOf(*a), cellsOf(*b)), "");
  }
}

}  // namespace
}  // namespace glider::slocum
