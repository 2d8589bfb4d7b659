// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_files/sensor_list.h"

#include "vehicles/slocum/data_files/text_lines.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>

namespace glider::slocum {
namespace {

constexpr size_t kMostLines = 50000;

/// One line of the list.
struct Line {
  bool transmitted = false;
  int index = -1;  ///< its place among the values; -1: not in the files
  Sensor sensor;
};

std::string_view nextWord(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
  rest.remove_prefix(word.size());
  return word;
}

std::optional<int> nextNumber(std::string_view& rest) {
  const std::string_view word = nextWord(rest);
  int value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() ? std::optional(value)
                                                                  : std::nullopt;
}

std::optional<Line> parseLine(std::string_view text) {
  Line line;
  if (nextWord(text) != "s:") {
    return std::nullopt;
  }
  const std::string_view transmitted = nextWord(text);
  const auto number = nextNumber(text);
  const auto index = nextNumber(text);
  const auto width = nextNumber(text);
  line.sensor.name = nextWord(text);
  line.sensor.unit = nextWord(text);
  if ((transmitted != "T" && transmitted != "F") || !number || !index || !width ||
      line.sensor.name.empty() || (*width != 1 && *width != 2 && *width != 4 && *width != 8)) {
    return std::nullopt;
  }
  line.transmitted = transmitted == "T";
  line.index = *index;
  line.sensor.width = static_cast<uint8_t>(*width);
  return line;
}

constexpr std::array<uint32_t, 256> crcTable() {
  std::array<uint32_t, 256> table{};
  for (uint32_t byte = 0; byte < 256; ++byte) {
    uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) {
      crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    table[byte] = crc;
  }
  return table;
}

}  // namespace

uint32_t sensorListCrc(std::string_view text) {
  static constexpr std::array<uint32_t, 256> kTable = crcTable();
  uint32_t crc = 0xFFFFFFFFU;
  for (const char c : text) {
    crc = crc >> 8U ^ kTable[(crc ^ static_cast<unsigned char>(c)) & 0xFFU];
  }
  return crc;
}

std::expected<SensorList, Damage> parseSensorList(std::string_view content, size_t begin,
                                                  size_t count) {
  SensorList list;
  TextLines lines(content, begin);
  while (count > 0 ? list.lines < count : lines.position() < content.size()) {
    const auto text = lines.next();
    if (!text) {
      return std::unexpected(text.error());
    }
    auto line = parseLine(*text);
    if (!line || ++list.lines > kMostLines) {
      return std::unexpected(Damage{lines.lineBegin(), "expected a line of the sensor list"});
    }
    if (!line->transmitted) {
      continue;
    }
    // The values come in the order of the lines; the index only repeats that.
    if (line->index != static_cast<int>(list.sensors.size())) {
      return std::unexpected(Damage{
          lines.lineBegin(), fmt::format("sensor `{}` has index {} instead of {}",
                                         line->sensor.name, line->index, list.sensors.size())});
    }
    list.sensors.push_back(std::move(line->sensor));
  }
  list.end = lines.position();
  list.crc = sensorListCrc(content.substr(begin, list.end - begin));
  return list;
}

}  // namespace glider::slocum
