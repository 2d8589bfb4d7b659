// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/slocum/data_bench.h"
#include "vehicles/slocum/data_files/blocks.h"
#include "vehicles/slocum/data_files/header.h"

#include <algorithm>
#include <cctype>

namespace glider::slocum {
namespace {

using second::Draft;

support::Result<DataFile> decode(const std::string& bytes, const std::string& name = "a.sbd") {
  SensorLists lists({"no_such_folder"});
  return decodeDataFile(name, bytes, lists);
}

std::string failureOf(const support::Result<DataFile>& file) {
  return file ? "" : support::code(file.error().id) + " " + file.error().message;
}

TEST(DataFile, GivesEveryKindOfValueInBothByteOrders) {
  for (const bool big : {false, true}) {
    Draft draft = smallDraft();
    draft.big_endian = big;
    const auto file = decode(write(draft));
    ASSERT_TRUE(file) << failureOf(file);  // accepts: GL5200 GL5201 GL5203
    EXPECT_EQ(file->order, big ? ByteOrder::Big : ByteOrder::Little);
    EXPECT_TRUE(file->damage.empty());
    EXPECT_TRUE(file->end_mark);
    EXPECT_FALSE(file->compressed);
    EXPECT_EQ(difference(cellsOf(*file), draft.rows), "");
    ASSERT_EQ(file->columns.size(), 6U);
    EXPECT_EQ(file->columns[2].sensor.name, "m_gps_status") << "u_unused is not in the file";
    EXPECT_EQ(file->columns[2].sensor.unit, "enum");
    EXPECT_EQ(file->columns[2].sensor.width, 1);
    EXPECT_EQ(file->columns[5].values, (std::vector<double>{127, -128, 1}));
  }
}

TEST(DataFile, TellsTheKindsOfUpdatesApart) {
  const auto file = decode(write(smallDraft()));
  ASSERT_TRUE(file);
  EXPECT_EQ(file->update(1, 0), Update::New);
  EXPECT_EQ(file->update(1, 1), Update::Same);
  EXPECT_EQ(file->update(1, 2), Update::None);
  EXPECT_TRUE(file->beginsWithInitialValues());
}

TEST(DataFile, ARepeatedValueThatWasNeverGivenIsNaN) {
  Draft draft = smallDraft();
  draft.rows.erase(draft.rows.begin());
  const auto file = decode(write(draft));
  ASSERT_TRUE(file);
  EXPECT_FALSE(file->beginsWithInitialValues());
  const auto cells = cellsOf(*file);
  EXPECT_EQ(cells[0][1].state, '=');
  EXPECT_TRUE(std::isnan(cells[0][1].value));
}

TEST(DataFile, ReadsTheHeader) {
  Draft draft = smallDraft();
  draft.extension = "tbd";
  const auto file = decode(write(draft));
  ASSERT_TRUE(file);
  EXPECT_EQ(file->header.mission, "TEST.MI");
  EXPECT_EQ(file->header.full_name, "unit-2024-183-2-7");
  EXPECT_EQ(file->header.total_sensors, 7U);
  EXPECT_EQ(file->computer, Computer::Science);
  EXPECT_EQ(vehicleOf("unit-2024-183-2-7"), "unit");
  EXPECT_EQ(vehicleOf("sea-cow-2024-183-2-7"), "sea-cow");
  EXPECT_EQ(vehicleOf("1-2-3"), "1-2-3");
  EXPECT_EQ(vehicleOf(""), "");
  EXPECT_EQ(timeOf("Tue_Jul__2_18:55:27_2024"), 1719946527);
  EXPECT_EQ(timeOf("Thu_Feb_29_00:00:00_2024"), 1709164800);
  EXPECT_EQ(timeOf("Thu_Feb_30_00:00:00_2024"), std::nullopt);
  EXPECT_EQ(timeOf("Tue_Jul__2_24:55:27_2024"), std::nullopt);
  EXPECT_EQ(timeOf("Tue_Jux__2_18:55:27_2024"), std::nullopt);
  EXPECT_EQ(timeOf(""), std::nullopt);
}

TEST(DataFile, IgnoresWhatFollowsTheEndMark) {
  const std::string bytes = write(smallDraft());
  const auto file = decode(bytes +
                           "\x1a\x1a"
                           "d");
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->damage.empty());
  EXPECT_EQ(file->records, 5U);
  const auto packed = decode(second::pack(bytes) +
                             "\x1a\x1a"
                             "d");
  ASSERT_TRUE(packed);
  EXPECT_TRUE(packed->damage.empty());
}

TEST(DataFile, NewerVehiclesWriteNoEndMark) {
  Draft draft = smallDraft();
  draft.end_mark = false;
  const auto file = decode(write(draft));
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->damage.empty());
  EXPECT_FALSE(file->end_mark);
  EXPECT_EQ(file->records, 5U);
}

TEST(DataFile, CompressedAndPlainGiveTheSame) {
  const std::string bytes = write(smallDraft());
  for (const size_t block : {1U, 9U, 14U, 15U, 270U, 32768U}) {
    const auto file = decode(second::pack(bytes, block), "a.scd");
    if (block < 10) {
      continue;  // the beginning is spread over several blocks, which no vehicle does
    }
    ASSERT_TRUE(file) << failureOf(file);
    EXPECT_TRUE(file->compressed);
    EXPECT_TRUE(file->damage.empty());
    EXPECT_EQ(difference(cellsOf(*file), smallDraft().rows), "") << block;
  }
}

TEST(DataFile, NamesDamageWithItsPlaceAndKeepsWhatIsBeforeIt) {
  std::string bytes = write(smallDraft());
  const size_t last = bytes.size() - 1;
  bytes[last] = 'Y';
  const auto file = decode(bytes);
  ASSERT_TRUE(file);
  ASSERT_EQ(file->damage.size(), 1U);
  EXPECT_EQ(file->damage[0].offset, last);
  EXPECT_EQ(file->damage[0].what, "expected a record, found byte 0x59");
  EXPECT_EQ(file->records, 5U);
  const auto packed = decode(second::pack(bytes));
  ASSERT_EQ(packed->damage.size(), 1U);
  EXPECT_EQ(packed->damage[0].offset, last);
  EXPECT_NE(packed->damage[0].what.find("decompressed"), std::string::npos);
}

TEST(DataFile, AListThatDoesNotMatchItsCrcIsDamage) {
  std::string bytes = write(smallDraft());
  bytes.replace(bytes.find("m_depth"), 7, "m_dexth");
  const auto file = decode(bytes);
  ASSERT_TRUE(file);
  ASSERT_EQ(file->damage.size(), 1U);
  EXPECT_EQ(file->damage[0].offset, bytes.find("s: T    0"));
  EXPECT_EQ(difference(cellsOf(*file), smallDraft().rows), "");
}

/// What decode says when `from` in the small file is replaced by `to`.
std::string refusal(const std::string& from, const std::string& to) {
  std::string bytes = write(smallDraft());
  const size_t at = bytes.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return failureOf(decode(bytes.replace(at, from.size(), to)));
}

TEST(DataFile, SaysWhatIsWrongWithAHeader) {
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_TRUE(text.starts_with("GL5200 `a.sbd` is not a data file of the vehicle: byte "))
        << text;
  };
  has(refusal("dbd_label", "dbx_label"), "byte 0: expected a line of the header");
  has(refusal("encoding_ver:    5", "encoding_ver:    6"), "its encoding is version 6");
  has(refusal("num_ascii_tags:    14", "num_ascii_tags:    13"), "no `sensor_list_factored`");
  has(refusal("num_ascii_tags:    14", "num_ascii_tags:    999999"), "cannot be `999999`");
  has(refusal("sensors_per_cycle:    6", "sensors_per_cycle:    8"), "cannot be `8`");
  has(refusal("sensors_per_cycle:    6", "sensors_per_cycle:    5"), "6 sensors, and the header");
  has(refusal("sensors_per_cycle:    6", "sensors_per_cycle:    0"), "no sensors");
  has(refusal("state_bytes_per_cycle:    2", "state_bytes_per_cycle:    3"), "need 2 state bytes");
  has(refusal("total_num_sensors:    7", "total_num_sensors:    -7"), "cannot be `-7`");
  has(refusal("total_num_sensors:    7", "total_num_sensors:    8"), "expected text");
  has(refusal("s: T    1    1 4", "s: T    1    2 4"), "`m_depth` has index 2 instead of 1");
  has(refusal("s: T    1    1 4", "s: T    1    1 3"), "expected a line of the sensor list");
  has(refusal("sa", "as"), "known bytes");
  has(refusal("TEST.MI", "TE\x1b[31m"), "expected text");
  has(failureOf(decode("")), "the file ends");
  has(failureOf(decode(std::string(100000, 'a'))), "does not end");
}

TEST(DataFile, DoesNotDecompressWithoutBound) {
  // One block of 64 KiB of zeros, from 263 bytes.
  std::string block("\x1f\0\1\0", 4);
  block += std::string(256, '\xff') + std::string(
                                          "\xe6\x50"
                                          "12345",
                                          7);
  std::string bytes;
  for (int i = 0; i < 5000; ++i) {
    bytes += static_cast<char>(block.size() >> 8);
    bytes += static_cast<char>(block.size());
    bytes += block;
  }
  const Decompressed opened = decompress(bytes);
  ASSERT_EQ(opened.damage.size(), 1U);
  EXPECT_NE(opened.damage[0].what.find("too large"), std::string::npos) << opened.damage[0].what;
  EXPECT_LE(opened.content.size(), kLargestContent);
  EXPECT_GT(opened.content.size(), kLargestContent - 65536);
}

}  // namespace
}  // namespace glider::slocum
