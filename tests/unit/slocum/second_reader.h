// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

/// A second reader and a writer of the vehicle's data files, made from the description of the
/// format, slow and simple. They share no code with vehicles/slocum/data_files, so that a
/// misreading of the format shows as a difference.
namespace glider::slocum::second {

/// What one record says about one sensor: '-' nothing, '=' the old value again, '*' a new value.
struct Cell {
  char state = '-';
  double value = 0;  ///< NaN for '='  if there is no old value; 0 for '-'
};

struct SensorLine {
  std::string name;
  std::string unit;
  int width = 4;
  bool in_file = true;
};

struct Table {
  std::map<std::string, std::string> tags;
  bool big_endian = false;
  std::vector<SensorLine> sensors;      ///< those that are in the file
  std::vector<std::vector<Cell>> rows;  ///< one for each whole record
  bool end_mark = false;
  size_t stopped = 0;   ///< where reading ended
  std::string problem;  ///< why it ended there, unless it was the end
};

/// Reads an uncompressed file; `list_of` gives the text of the sensor list with a CRC (in lower
/// case).
Table read(const std::string& bytes, const std::function<std::string(std::string)>& list_of = {});

/// The content of a compressed file whose blocks are all valid.
std::string unpack(const std::string& bytes);
/// A compressed file with this content, in blocks of `block` bytes, which hold literals only.
std::string pack(const std::string& content, size_t block = 32768);

/// A file to write.
struct Draft {
  bool big_endian = false;
  bool factored = false;
  bool end_mark = true;
  std::string extension = "sbd";
  std::string full_name = "unit-2024-183-2-7";
  std::string opened = "Tue_Jul__2_18:55:27_2024";
  std::vector<SensorLine> sensors;
  std::vector<std::vector<Cell>> rows;  ///< a cell for each sensor in the file
};

std::string listText(const Draft& draft);
std::string crcOf(const std::string& list);
std::string write(const Draft& draft);

}  // namespace glider::slocum::second
