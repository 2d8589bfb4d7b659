// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/slocum/second_reader.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace glider::slocum::second {
namespace {

unsigned byteAt(const std::string& bytes, size_t at) {
  return static_cast<unsigned char>(bytes.at(at));
}

/// The `width` bytes at `at` as one integer, put together byte by byte.
uint64_t gather(const std::string& bytes, size_t at, size_t width, bool big_endian) {
  uint64_t bits = 0;
  for (size_t i = 0; i < width; ++i) {
    bits = bits * 256 + byteAt(bytes, at + (big_endian ? i : width - 1 - i));
  }
  return bits;
}

double valueAt(const std::string& bytes, size_t at, int width, bool big_endian) {
  const uint64_t bits = gather(bytes, at, static_cast<size_t>(width), big_endian);
  if (width == 1) {
    return bits >= 128 ? static_cast<double>(bits) - 256 : static_cast<double>(bits);
  }
  if (width == 2) {
    return bits >= 32768 ? static_cast<double>(bits) - 65536 : static_cast<double>(bits);
  }
  if (width == 4) {
    const auto low = static_cast<uint32_t>(bits);
    float value = 0;
    std::memcpy(&value, &low, 4);
    return value;
  }
  double value = 0;
  std::memcpy(&value, &bits, 8);
  return value;
}

std::vector<SensorLine> sensorsOf(const std::string& text) {
  std::vector<SensorLine> sensors;
  std::istringstream lines(text);
  for (std::string s, flag, number, index; lines >> s >> flag >> number >> index;) {
    SensorLine sensor;
    lines >> sensor.width >> sensor.name >> sensor.unit;
    if (flag == "T") {
      sensors.push_back(sensor);
    }
  }
  return sensors;
}

/// Takes one line from `at` on.
std::string takeLine(const std::string& bytes, size_t& at) {
  const size_t end = bytes.find('\n', at);
  if (end == std::string::npos) {
    throw std::runtime_error("no line");
  }
  std::string line = bytes.substr(at, end - at);
  at = end + 1;
  return line;
}

/// Reads one record at `at`; throws when it is not a whole one.
std::vector<Cell> takeRecord(const std::string& bytes, size_t& at, const Table& table,
                             std::vector<double>& last) {
  const size_t count = table.sensors.size();
  const size_t state_bytes = count / 4 + (count % 4 > 0 ? 1 : 0);
  size_t value_at = at + 1 + state_bytes;
  std::vector<Cell> row(count);
  const std::vector<double> before = last;
  try {
    for (size_t i = 0; i < state_bytes * 4; ++i) {
      const unsigned state = byteAt(bytes, at + 1 + i / 4) /
                             (i % 4 == 0   ? 64U
                              : i % 4 == 1 ? 16U
                              : i % 4 == 2 ? 4U
                                           : 1U) %
                             4;
      if (state == 3 || (i >= count && state != 0)) {
        throw std::runtime_error("state");
      }
      if (state == 2) {
        last[i] = valueAt(bytes, value_at, table.sensors[i].width, table.big_endian);
        value_at += static_cast<size_t>(table.sensors[i].width);
      }
      if (i < count && state != 0) {
        row[i] = {state == 2 ? '*' : '=', last[i]};
      }
    }
  } catch (const std::exception&) {
    last = before;
    throw;
  }
  at = value_at;
  return row;
}

void takeRecords(const std::string& bytes, size_t& at, Table& table) {
  std::vector<double> last(table.sensors.size(), std::nan(""));
  while (at < bytes.size()) {
    if (bytes[at] == 'X') {
      table.end_mark = true;
      return;
    }
    if (bytes[at] != 'd') {
      throw std::runtime_error("tag");
    }
    table.rows.push_back(takeRecord(bytes, at, table, last));
  }
}

void append(std::string& out, uint64_t bits, int width, bool big_endian) {
  for (int i = 0; i < width; ++i) {
    const int shift = 8 * (big_endian ? width - 1 - i : i);
    out += static_cast<char>(bits >> shift & 0xff);
  }
}

uint64_t bitsOf(double value, int width) {
  if (width == 8) {
    uint64_t bits = 0;
    std::memcpy(&bits, &value, 8);
    return bits;
  }
  if (width == 4) {
    const auto narrow = static_cast<float>(value);
    uint32_t bits = 0;
    std::memcpy(&bits, &narrow, 4);
    return bits;
  }
  return static_cast<uint64_t>(static_cast<int64_t>(value));
}

size_t inFile(const Draft& draft) {
  size_t count = 0;
  for (const SensorLine& sensor : draft.sensors) {
    count += sensor.in_file ? 1 : 0;
  }
  return count;
}

void appendRecord(std::string& out, const Draft& draft, const std::vector<Cell>& row) {
  std::vector<int> widths;
  for (const SensorLine& sensor : draft.sensors) {
    if (sensor.in_file) {
      widths.push_back(sensor.width);
    }
  }
  std::string states((row.size() + 3) / 4, '\0');
  std::string values;
  for (size_t i = 0; i < row.size(); ++i) {
    const unsigned state = row[i].state == '*' ? 2 : row[i].state == '=' ? 1 : 0;
    states[i / 4] = static_cast<char>(byteAt(states, i / 4) | state << (6 - 2 * (i % 4)));
    if (state == 2) {
      append(values, bitsOf(row[i].value, widths[i]), widths[i], draft.big_endian);
    }
  }
  out += 'd' + states + values;
}

}  // namespace

Table read(const std::string& bytes, const std::function<std::string(std::string)>& list_of) {
  Table table;
  size_t& at = table.stopped;
  try {
    for (int i = 0; i < 14; ++i) {
      const std::string line = takeLine(bytes, at);
      const size_t colon = line.find(':');
      const size_t value = line.find_first_not_of(' ', colon + 1);
      table.tags[line.substr(0, colon)] = value == std::string::npos ? "" : line.substr(value);
    }
    std::string list;
    if (table.tags["sensor_list_factored"] == "1") {
      std::string crc = table.tags["sensor_list_crc"];
      for (char& c : crc) {
        c = static_cast<char>(std::tolower(c));
      }
      list = list_of(crc);
    } else {
      for (int i = std::stoi(table.tags["total_num_sensors"]); i > 0; --i) {
        list += takeLine(bytes, at) + "\n";
      }
    }
    table.sensors = sensorsOf(list);
    table.big_endian = byteAt(bytes, at + 2) == 0x12;
    at += 16;
    takeRecords(bytes, at, table);
  } catch (const std::exception& problem) {
    table.problem = problem.what();
  }
  return table;
}

std::string unpack(const std::string& bytes) {
  std::string out;
  for (size_t at = 0; at + 2 <= bytes.size();) {
    const size_t end = at + 2 + gather(bytes, at, 2, true);
    at += 2;
    const auto length = [&](unsigned nibble) {
      size_t sum = nibble;
      for (unsigned more = nibble == 15 ? 255 : 0; more == 255;) {
        more = byteAt(bytes, at++);
        sum += more;
      }
      return sum;
    };
    while (at < end) {
      const unsigned token = byteAt(bytes, at++);
      const size_t literals = length(token / 16);
      out += bytes.substr(at, literals);
      at += literals;
      if (at < end) {  // the last sequence has no match
        const size_t back = gather(bytes, at, 2, false);
        at += 2;
        for (size_t left = length(token % 16) + 4; left > 0; --left) {
          out += out.at(out.size() - back);
        }
      }
    }
  }
  return out;
}

std::string pack(const std::string& content, size_t block) {
  std::string out;
  for (size_t at = 0; at < content.size(); at += block) {
    const std::string literals = content.substr(at, block);
    std::string packed;
    if (literals.size() < 15) {
      packed += static_cast<char>(literals.size() * 16);
    } else {
      packed += '\xf0';
      size_t left = literals.size() - 15;
      for (; left >= 255; left -= 255) {
        packed += '\xff';
      }
      packed += static_cast<char>(left);
    }
    packed += literals;
    append(out, packed.size(), 2, true);
    out += packed;
  }
  return out;
}

std::string listText(const Draft& draft) {
  std::string text;
  int number = 0, index = 0;
  for (const SensorLine& sensor : draft.sensors) {
    char line[200];
    std::snprintf(line, sizeof line, "s: %c %4d %4d %d %s %s\n", sensor.in_file ? 'T' : 'F',
                  number++, sensor.in_file ? index++ : -1, sensor.width, sensor.name.c_str(),
                  sensor.unit.c_str());
    text += line;
  }
  return text;
}

std::string crcOf(const std::string& list) {
  uint32_t crc = 0xffffffff;
  for (const char c : list) {
    for (int bit = 0; bit < 8; ++bit) {
      const unsigned in = static_cast<unsigned char>(c) >> bit & 1U;
      crc = (crc & 1U) != in ? (crc >> 1) ^ 0xedb88320U : crc >> 1;
    }
  }
  char text[9];
  std::snprintf(text, sizeof text, "%08x", crc);
  return text;
}

std::string write(const Draft& draft) {
  const size_t count = inFile(draft);
  const std::string list = listText(draft);
  std::string out =
      "dbd_label:    DBD(dinkum_binary_data)file\nencoding_ver:    5\n"
      "num_ascii_tags:    14\nall_sensors:    F\nthe8x3_filename:    00070007\n"
      "full_filename:    " +
      draft.full_name + "\nfilename_extension:    " + draft.extension +
      "\nmission_name:    TEST.MI\nfileopen_time:    " + draft.opened +
      "\ntotal_num_sensors:    " + std::to_string(draft.sensors.size()) +
      "\nsensors_per_cycle:    " + std::to_string(count) +
      "\nstate_bytes_per_cycle:    " + std::to_string((count + 3) / 4) +
      "\nsensor_list_crc:    " + crcOf(list) +
      "\nsensor_list_factored:    " + (draft.factored ? "1" : "0") + "\n" +
      (draft.factored ? "" : list) + "sa";
  append(out, 0x1234, 2, draft.big_endian);
  append(out, bitsOf(123.456, 4), 4, draft.big_endian);
  append(out, bitsOf(123456789.12345, 8), 8, draft.big_endian);
  for (const auto& row : draft.rows) {
    appendRecord(out, draft, row);
  }
  return out + (draft.end_mark ? "X" : "");
}

}  // namespace glider::slocum::second
