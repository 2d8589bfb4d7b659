// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_files/header.h"

#include "vehicles/slocum/data_files/text_lines.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <chrono>
#include <map>

namespace glider::slocum {
namespace {

constexpr uint32_t kMostTags = 100;
constexpr uint32_t kMostSensors = 50000;  // some twenty times as many as vehicles have
constexpr uint32_t kEncoding = 5;         // the only version whose layout is public

using Tags = std::map<std::string, std::string, std::less<>>;

/// Reads tags by name; the first one that is missing or invalid is what is wrong with the header.
class TagReader {
 public:
  TagReader(const Tags& tags, size_t end) : tags_(tags), end_(end) {}

  std::string text(std::string_view key) {
    const auto found = tags_.find(key);
    if (found == tags_.end()) {
      fail(fmt::format("the header has no `{}`", key));
      return "";
    }
    return found->second;
  }
  uint32_t number(std::string_view key, uint32_t most, int base = 10) {
    const std::string word = text(key);
    uint32_t value = 0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value, base);
    if (error != std::errc() || rest != word.data() + word.size() || value > most) {
      fail(fmt::format("`{}` of the header cannot be `{}`", key, word));
    }
    return value;
  }
  void fail(std::string what) {
    if (!wrong_) {
      wrong_ = Damage{end_, std::move(what)};
    }
  }
  [[nodiscard]] const std::optional<Damage>& wrong() const { return wrong_; }

 private:
  const Tags& tags_;
  size_t end_;
  std::optional<Damage> wrong_;
};

/// The lines `key: value`, as many as `num_ascii_tags` says.
std::expected<Tags, Damage> readTags(TextLines& lines) {
  Tags tags;
  uint32_t count = 14;
  for (uint32_t i = 0; i < count; ++i) {
    const auto line = lines.next();
    if (!line) {
      return std::unexpected(line.error());
    }
    const size_t colon = line->find(':');
    if (colon == std::string::npos || (i == 0 && !line->starts_with("dbd_label:"))) {
      return std::unexpected(Damage{lines.lineBegin(), "expected a line of the header"});
    }
    const size_t value = line->find_first_not_of(" \t", colon + 1);
    const std::string key = line->substr(0, colon);
    tags[key] = value == std::string::npos ? "" : line->substr(value);
    if (key == "num_ascii_tags") {
      TagReader reader(tags, lines.lineBegin());
      count = reader.number(key, kMostTags);
      if (reader.wrong()) {
        return std::unexpected(*reader.wrong());
      }
    }
  }
  return tags;
}

}  // namespace

std::expected<ParsedHeader, Damage> parseHeader(std::string_view content) {
  TextLines lines(content, 0);
  const auto tags = readTags(lines);
  if (!tags) {
    return std::unexpected(tags.error());
  }
  TagReader reader(*tags, lines.position());
  ParsedHeader parsed{{}, lines.position()};
  DataHeader& header = parsed.header;
  header.label = reader.text("dbd_label");
  header.name_8x3 = reader.text("the8x3_filename");
  header.full_name = reader.text("full_filename");
  header.extension = reader.text("filename_extension");
  header.mission = reader.text("mission_name");
  header.opened = reader.text("fileopen_time");
  header.total_sensors = reader.number("total_num_sensors", kMostSensors);
  header.sensors = reader.number("sensors_per_cycle", header.total_sensors);
  header.state_bytes = reader.number("state_bytes_per_cycle", kMostSensors);
  header.list_crc = reader.number("sensor_list_crc", UINT32_MAX, 16);
  header.list_factored = reader.number("sensor_list_factored", 1) == 1;
  if (const uint32_t encoding = reader.number("encoding_ver", UINT32_MAX); encoding != kEncoding) {
    reader.fail(
        fmt::format("its encoding is version {}, and only {} can be read", encoding, kEncoding));
  }
  if (header.sensors == 0) {
    reader.fail("it contains no sensors");
  }
  if (header.state_bytes != (header.sensors + 3) / 4) {
    reader.fail(fmt::format("{} sensors need {} state bytes, and the header says {}",
                            header.sensors, (header.sensors + 3) / 4, header.state_bytes));
  }
  if (reader.wrong()) {
    return std::unexpected(*reader.wrong());
  }
  return parsed;
}

std::optional<double> timeOf(std::string_view opened) {
  constexpr std::array<std::string_view, 12> kMonths = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                        "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  if (opened.size() != 24) {
    return std::nullopt;
  }
  const auto number = [&](size_t begin, size_t size) {
    std::string_view word = opened.substr(begin, size);
    word.remove_prefix(word.starts_with('_') ? 1U : 0U);  // the day of the month is padded
    int value = -1;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && rest == word.data() + word.size() ? value : -1;
  };
  unsigned month = 0;
  while (month < kMonths.size() && kMonths[month] != opened.substr(4, 3)) {
    ++month;
  }
  const int hour = number(11, 2), minute = number(14, 2), second = number(17, 2);
  const std::chrono::year_month_day day{std::chrono::year{number(20, 4)},
                                        std::chrono::month{month + 1},
                                        std::chrono::day{static_cast<unsigned>(number(8, 2))}};
  if (!day.ok() || hour < 0 || hour > 23 || minute < 0 || minute > 59 || second < 0 ||
      second > 60) {
    return std::nullopt;
  }
  const auto days = std::chrono::sys_days(day).time_since_epoch().count();
  return 86400.0 * static_cast<double>(days) + 3600.0 * hour + 60.0 * minute + second;
}

std::string vehicleOf(std::string_view full_name) {
  size_t end = full_name.size();
  for (int part = 0; part < 4; ++part) {  // year, day, mission, segment
    end = end == 0 ? std::string_view::npos : full_name.rfind('-', end - 1);
    if (end == std::string_view::npos) {
      return std::string(full_name);
    }
  }
  return std::string(full_name.substr(0, end));
}

}  // namespace glider::slocum
