// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Damaged files: both readers must stop at the same byte, with the same values before it.

#include "tests/unit/slocum/data_bench.h"

#include <algorithm>
#include <cmath>

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

/// `count` records of 35 bytes or so, each with a time, a depth that is its number, and a battery
/// that only every tenth record updates; the others repeat it.
std::string longFile(uint32_t count) {
  second::Draft draft;
  draft.sensors = {{"m_present_time", "timestamp", 8, true},
                   {"m_depth", "m", 4, true},
                   {"m_lat", "lat", 8, true},
                   {"m_battery", "volts", 4, true}};
  for (uint32_t i = 0; i < count; ++i) {
    const second::Cell battery = second::Cell{i % 10 == 0 ? '*' : '=', 10.0 + i / 10};
    const double number = i;
    draft.rows.push_back(
        {{'*', 1.7e9 + 4 * number}, {'*', number}, {'*', 3900 + number * 0.01}, battery});
  }
  return write(draft);
}

DataFile damagedFile(const std::string& bytes) {
  SensorLists lists({"no_such_folder"});
  auto file = decodeDataFile("a.sbd", bytes, lists);
  EXPECT_TRUE(file);
  return file ? *file : DataFile{};
}

/// Reading goes on after damage, and no value is wrong.
TEST(DamagedDataFile, IsReadOnAfterDamageInTheMiddle) {
  const std::string whole = longFile(200);
  const size_t begin = whole.find("sa\x34") + 16;
  struct Harm {
    const char* what;
    std::string (*to)(std::string bytes, size_t at);
  };
  const Harm harms[] = {
      {"zeros", [](std::string b, size_t at) { return b.replace(at, 40, std::string(40, '\0')); }},
      {"ones", [](std::string b, size_t at) { return b.replace(at, 25, std::string(25, '\xff')); }},
      {"letters", [](std::string b, size_t at) { return b.replace(at, 60, std::string(60, 'd')); }},
      {"bytes lost", [](std::string b, size_t at) { return b.erase(at, 13); }},
      {"bytes added", [](std::string b, size_t at) { return b.insert(at, "garbage"); }},
      {"a block lost", [](std::string b, size_t at) { return b.erase(at, 512); }},
  };
  for (const Harm& harm : harms) {
    for (size_t part = 1; part <= 6; ++part) {
      const std::string about = harm.what + std::to_string(part);
      const DataFile file = damagedFile(harm.to(whole, begin + part * (whole.size() - begin) / 8));
      ASSERT_EQ(file.damage.size(), 1U) << about;
      EXPECT_NE(file.damage[0].what.find("; reading continues at byte "), std::string::npos)
          << about << file.damage[0].what;
      ASSERT_EQ(file.breaks.size(), 1U) << about;
      EXPECT_TRUE(file.end_mark) << about;
      EXPECT_GE(file.records, 174U) << about;
      for (uint32_t record = 0; record < file.records; ++record) {
        const double depth = file.columns[1].values[record];
        EXPECT_EQ(file.columns[0].values[record], 1.7e9 + 4 * depth) << about << " " << record;
        EXPECT_EQ(file.columns[2].values[record], 3900 + depth * 0.01) << about << " " << record;
      }
      EXPECT_EQ(file.columns[1].values[file.records - 1], 199) << about;
      forEachUpdate(file, 3, [&](uint32_t record, Update, double value) {
        const double true_value = 10 + std::floor(file.columns[1].values[record] / 10);
        EXPECT_TRUE(value == true_value || (std::isnan(value) && record >= file.breaks[0]))
            << about << " " << record << ": a repeated value from before the gap is not known";
      });
    }
  }
}

TEST(DamagedDataFile, IsReadOnAfterSeveralDamages) {
  std::string bytes = longFile(300);
  const size_t begin = bytes.find("sa\x34") + 16, size = bytes.size() - begin;
  for (const size_t part : {2U, 4U, 6U}) {
    bytes.replace(begin + part * size / 8, 30, std::string(30, '\0'));
  }
  const DataFile file = damagedFile(bytes);
  EXPECT_EQ(file.damage.size(), 3U);
  EXPECT_EQ(file.breaks.size(), 3U);
  EXPECT_TRUE(std::ranges::is_sorted(file.breaks));
  EXPECT_GE(file.records, 287U);
  EXPECT_EQ(file.columns[1].values.back(), 299);
}

TEST(DamagedDataFile, WhatIsNotRecordsIsNotReadAsSome) {
  const std::string whole = longFile(100);
  const size_t begin = whole.find("sa\x34") + 16, middle = (begin + whole.size()) / 2;
  std::string noise;
  for (uint32_t i = 0, x = 7; i < 20000; ++i) {
    x = x * 1664525U + 1013904223U;
    noise += static_cast<char>(x >> 24U);
  }
  for (const std::string& tail : {noise, std::string(5000, '\0')}) {
    const DataFile file = damagedFile(whole.substr(0, middle) + tail);
    EXPECT_LE(file.records, 50U);
    EXPECT_EQ(file.breaks.size(), 0U);
    for (const double depth : file.columns[1].values) {
      EXPECT_LE(depth, 50);
    }
  }
}

TEST(DamagedDataFile, ABlockThatIsLostLeavesAGap) {
  const std::string whole = longFile(200);
  std::string packed = second::pack(whole, 1000);
  size_t fourth = 0;
  for (int i = 0; i < 3; ++i) {  // each after its size
    const auto byte = [&](size_t at) { return static_cast<uint8_t>(packed[at]); };
    fourth += 2 + size_t{byte(fourth)} * 256 + byte(fourth + 1);
  }
  packed.replace(fourth + 2, 200, std::string(200, '\xff'));
  SensorLists lists({"no_such_folder"});
  const auto file = decodeDataFile("a.scd", packed, lists);
  ASSERT_TRUE(file);
  ASSERT_EQ(file->damage.size(), 1U) << file->damage.back().what;
  EXPECT_EQ(file->damage[0].what, "the compressed block is invalid");
  EXPECT_EQ(file->breaks.size(), 1U);
  EXPECT_GE(file->records, 150U);
  EXPECT_LT(file->records, 200U);
  for (uint32_t record = 0; record < file->records; ++record) {
    EXPECT_EQ(file->columns[0].values[record], 1.7e9 + 4 * file->columns[1].values[record]);
  }
  EXPECT_EQ(file->columns[1].values.back(), 199);
}

/// Each line feed became a carriage return and a line feed, also in the records.
TEST(DamagedDataFile, ATransferAsTextIsUndone) {
  const std::string whole = longFile(200);
  std::string text;
  for (const char c : whole) {
    text += c == '\n' ? "\r\n" : std::string(1, c);
  }
  ASSERT_GT(text.size(), whole.size() + 20);
  const DataFile file = damagedFile(text), right = damagedFile(whole);
  EXPECT_TRUE(file.as_text);
  EXPECT_TRUE(file.damage.empty()) << file.damage[0].what;
  EXPECT_EQ(difference(cellsOf(file), cellsOf(right)), "");
  EXPECT_FALSE(right.as_text);
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
