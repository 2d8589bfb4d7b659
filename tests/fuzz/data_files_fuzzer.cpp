// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// libFuzzer feeds bytes to the reader of the vehicle's data files, with the promises that must hold
// for any bytes. The first byte chooses what the others are: a whole file, compressed blocks, a
// sensor list, or the records after a valid header.

#include "support/check.h"
#include "vehicles/slocum/data_files/blocks.h"
#include "vehicles/slocum/data_files/read.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace {

using namespace glider;

/// A file with the sensors of `list`, whose `count` lines are all in the file, and these records.
std::string withHeader(const std::string& list, size_t count, std::string_view records) {
  return fmt::format(
             "dbd_label: DBD\nencoding_ver: 5\nnum_ascii_tags: 14\nall_sensors: T\n"
             "the8x3_filename: 1\nfull_filename: a-1-2-3-4\nfilename_extension: dbd\n"
             "mission_name: M\nfileopen_time: x\ntotal_num_sensors: {0}\nsensors_per_cycle: {0}\n"
             "state_bytes_per_cycle: {1}\nsensor_list_crc: {2:08x}\nsensor_list_factored: 0\n{3}",
             count, (count + 3) / 4, slocum::sensorListCrc(list), list) +
         std::string("sa\x34\x12\x79\xe9\xf6\x42\xad\x69\x7e\x54\x34\x6f\x9d\x41") +
         std::string(records);
}

void check(const slocum::DataFile& file) {
  CHECK(file.states.size() == size_t{file.records} * file.header.state_bytes,
        "every record has its states");
  for (size_t column = 0; column < file.columns.size(); ++column) {
    size_t fresh = 0;
    slocum::forEachUpdate(file, column, [&](uint32_t, slocum::Update update, double) {
      fresh += update == slocum::Update::New ? 1U : 0U;
    });
    CHECK(fresh == file.columns[column].values.size(), "every new value has its record");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) {
    return 0;
  }
  const std::string rest(reinterpret_cast<const char*>(data + 1), size - 1);
  slocum::SensorLists lists({"no_such_folder"});
  std::string bytes = rest;
  if (data[0] % 4 == 1) {
    bytes = slocum::decompress(rest).content;
  } else if (data[0] % 4 == 2) {
    (void)slocum::parseSensorList(rest, 0, 0);
  } else if (data[0] % 4 == 3) {
    const std::string list =
        "s: T 0 0 1 a x\ns: T 1 1 2 b x\ns: T 2 2 4 c x\ns: T 3 3 8 d x\ns: T 4 4 4 e x\n";
    bytes = withHeader(list, 5, rest);
  }
  const auto file = slocum::decodeDataFile("fuzz.sbd", bytes, lists);
  CHECK(data[0] % 4 != 3 || file.has_value(), "records after a valid header can always be read");
  if (file) {
    check(*file);
  }
  return 0;
}
