// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// The data files of the vehicle as plain data, one column for each sensor.
namespace glider::slocum {

enum class ByteOrder : uint8_t { Big, Little };
/// The computer that wrote the file: each has its own clock and its own sensors.
enum class Computer : uint8_t { Flight, Science };

/// Whether two names of sensors are the same: the vehicle ignores case.
bool isSameName(std::string_view a, std::string_view b);

struct Sensor {
  std::string name;
  std::string unit;
  uint8_t width = 4;  ///< bytes of a value: 1 and 2 are signed integers, 4 and 8 are floats
};

/// The lines of text at the beginning of a file.
struct DataHeader {
  std::string label;           ///< kind of file, "DBD(dinkum_binary_data)file"
  std::string name_8x3;        ///< "01930034": mission and segment as the vehicle's disk names it
  std::string full_name;       ///< "comet-2019-218-0-34"
  std::string extension;       ///< "sbd"
  std::string mission;         ///< "SPIRAL.MI"
  std::string opened;          ///< "Fri_Aug__9_12:27:06_2019", UTC
  uint32_t total_sensors = 0;  ///< in the sensor list
  uint32_t sensors = 0;        ///< those of them that are in the file
  uint32_t state_bytes = 0;    ///< at the beginning of each record
  uint32_t list_crc = 0;
  bool list_factored = false;  ///< true: the sensor list is not in this file
};

/// What a record says about one sensor; the values are those of the format.
enum class Update : uint8_t {
  None = 0,  ///< the sensor was not updated
  Same = 1,  ///< it was updated, with the value that it had before
  New = 2,   ///< it was updated, with a new value
};

struct Column {
  Sensor sensor;
  std::vector<double> values;  ///< the new values only, in the order of the records
};

/// A part of a file that could not be read.
struct Damage {
  size_t offset = 0;  ///< byte of the file; for what is inside compressed blocks, `what` reports it
  std::string what;
};

struct DataFile {
  DataHeader header;
  Computer computer = Computer::Flight;
  ByteOrder order = ByteOrder::Big;
  bool compressed = false;
  bool end_mark = false;  ///< the file says where it ends; newer vehicles do not write that
  uint32_t records = 0;
  std::vector<Column> columns;
  std::vector<uint8_t> states;  ///< header.state_bytes for each record: 2 bits for each column
  std::vector<Damage> damage;
  /// The records before which others are missing because of damage, ascending: reading began again
  /// with them.
  std::vector<uint32_t> breaks;
  bool as_text = false;  ///< a transfer had put a carriage return in front of each line feed

  [[nodiscard]] Update update(size_t record, size_t column) const {
    const uint8_t byte = states[record * header.state_bytes + column / 4];
    return static_cast<Update>(byte >> (6U - 2U * (column % 4)) & 3U);
  }
  /// True if the first record only repeats what was known when the file was opened: it has a value
  /// for every sensor.
  [[nodiscard]] bool beginsWithInitialValues() const;
};

/// Calls `take(record, update, value)` for each record that updates `column`, in order. A repeated
/// value that no record has given since the file began, or since records that are missing, is NaN.
template <typename Take>
void forEachUpdate(const DataFile& file, size_t column, Take take) {
  const std::vector<double>& values = file.columns[column].values;
  size_t used = 0, next_break = 0;
  bool known = false;
  for (uint32_t record = 0; record < file.records; ++record) {
    for (; next_break < file.breaks.size() && file.breaks[next_break] == record; ++next_break) {
      known = false;
    }
    const Update update = file.update(record, column);
    if (update == Update::None) {
      continue;
    }
    used += update == Update::New ? 1U : 0U;
    known = known || update == Update::New;
    take(record, update, known ? values[used - 1] : __builtin_nan(""));
  }
}

}  // namespace glider::slocum
