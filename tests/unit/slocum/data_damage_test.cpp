// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Damaged files: both readers must stop at the same byte, with the same values before it.

#include "tests/unit/slocum/data_bench.h"

namespace glider::slocum {
namespace {

/// Compares what the two readers make of `bytes`. Returns the records, if it is a data file.
std::optional<uint32_t> compare(const std::string& bytes, const std::string& about) {
  SensorLists lists({"no_such_folder"});
  const auto file = decodeDataFile("a.sbd", bytes, lists);
  if (!file) {
    return std::nullopt;
  }
  const second::Table table = second::read(bytes);
  EXPECT_EQ(difference(cellsOf(*file), table.rows), "") << about;
  EXPECT_EQ(file->end_mark, table.end_mark) << about;
  const bool records_damaged =
      !file->damage.empty() && file->damage.back().what.find("CRC") == std::string::npos;
  EXPECT_EQ(records_damaged, !table.problem.empty()) << about << ": " << table.problem;
  if (records_damaged) {
    EXPECT_EQ(file->damage.back().offset, table.stopped) << about;
  }
  return file->records;
}

TEST(DamagedDataFile, CutAtEveryLength) {
  for (const bool big : {false, true}) {
    second::Draft draft = smallDraft();
    draft.big_endian = big;
    const std::string whole = write(draft);
    uint32_t before = 0;
    size_t readable = 0;
    for (size_t size = 0; size <= whole.size(); ++size) {
      const auto records = compare(whole.substr(0, size), "cut to " + std::to_string(size));
      EXPECT_GE(records.value_or(0), before);
      before = records.value_or(0);
      readable += records ? 1U : 0U;
    }
    EXPECT_EQ(before, 5U);
    EXPECT_EQ(readable,
              whole.size() + 1 -
                  (whole.find("sa\x12") != std::string::npos ? whole.find("sa\x12") + 16
                                                             : whole.find("sa\x34") + 16));
  }
}

TEST(DamagedDataFile, EveryBitFlipped) {
  const std::string whole = write(smallDraft());
  size_t readable = 0;
  for (size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string bytes = whole;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ 1 << bit % 8);
    // A flip in the text may change what a tolerant reader accepts; from the records on, both
    // agree.
    const bool in_records = bit / 8 >= whole.find("sa\x34") + 16;
    SensorLists lists({"no_such_folder"});
    if (in_records) {
      readable += compare(bytes, "bit " + std::to_string(bit)) ? 1U : 0U;
    } else {
      (void)decodeDataFile("a.sbd", bytes, lists);
    }
  }
  EXPECT_EQ(readable, 8 * (whole.size() - whole.find("sa\x34") - 16));
}

TEST(DamagedDataFile, AStateThatDoesNotExistIsSeenAtEverySensor) {
  second::Draft draft;
  for (int i = 0; i < 71; ++i) {  // more than are looked at together, and one padding state
    draft.sensors.push_back({"x_" + std::to_string(i), "nodim", i % 2 == 0 ? 1 : 4, true});
  }
  draft.rows.assign(2, std::vector<second::Cell>(71, {'*', 5}));
  draft.rows.push_back(std::vector<second::Cell>(71));
  const std::string whole = write(draft);
  const size_t states = whole.size() - 1 - 18;  // of the last record, which has no values
  for (size_t i = 0; i < 72; ++i) {
    std::string bytes = whole;
    bytes[states + i / 4] = static_cast<char>(3U << (6 - 2 * (i % 4)));
    EXPECT_EQ(compare(bytes, "sensor " + std::to_string(i)), 2U);
  }
}

TEST(DamagedDataFile, CompressedCutAtEveryLength) {
  const std::string whole = write(smallDraft());
  const std::string packed = second::pack(whole, 300);
  uint32_t before = 0;
  for (size_t size = 0; size <= packed.size(); ++size) {
    SensorLists lists({"no_such_folder"});
    const auto file = decodeDataFile("a.scd", packed.substr(0, size), lists);
    const uint32_t records = file ? file->records : 0;
    EXPECT_GE(records, before) << size;
    EXPECT_TRUE(!file || !file->damage.empty() || file->end_mark || cellsOf(*file).size() < 5)
        << size;
    before = records;
  }
  EXPECT_EQ(before, 5U);
}

TEST(DamagedDataFile, CompressedEveryByteChanged) {
  const std::string packed = second::pack(write(smallDraft()), 300);
  for (size_t at = 0; at < packed.size(); ++at) {
    for (const int change : {1, 0x10, 0x80, 0xff}) {
      std::string bytes = packed;
      bytes[at] = static_cast<char>(bytes[at] ^ change);
      SensorLists lists({"no_such_folder"});
      (void)decodeDataFile("a.scd", bytes, lists);
    }
  }
}

TEST(DamagedDataFile, ABlockThatIsCutGivesWhatItHas) {
  const std::string whole = write(smallDraft());
  const std::string packed = second::pack(whole);  // all in one block
  SensorLists lists({"no_such_folder"});
  const auto file = decodeDataFile("a.scd", packed.substr(0, packed.size() - 3), lists);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->records, 4U);
  ASSERT_EQ(file->damage.size(), 2U);
  EXPECT_EQ(file->damage[1].offset, packed.size() - 3);
  EXPECT_EQ(file->damage[1].what, "the file ends within a compressed block");
}

}  // namespace
}  // namespace glider::slocum
