// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "logs/render.h"

#include "report/text.h"
#include "support/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace glider::logs {

using runtime::LogRecord;

namespace {

std::string number(double value) {
  return std::isnan(value) ? "" : fmt::format("{:.12g}", value);
}

std::string known(double value) {
  return std::isnan(value) ? "unknown" : fmt::format("{:.9g}", value);
}

/// In quotes only where it must be.
std::string field(const std::string& name) {
  return name.find_first_of(",\"\n\r") == std::string::npos ? name : support::csvQuoted(name);
}

/// With `unit` after it where there are units.
std::string line(const LogEntry& entry, const char* record, const std::string& name,
                 const std::string& value, const std::string& from = "", const std::string& to = "",
                 const std::string& unit = "") {
  return fmt::format("{},{},{},{},{},{}{}\n", number(entry.time), record, field(name), value,
                     field(from), field(to), unit);
}

/// ",degC" of value `i` of an entry with units.
std::string unitOf(const LogEntry& entry, size_t i) {
  return i < entry.units.size() ? "," + field(entry.units[i]) : "";
}

std::string valueLines(const LogEntry& entry, const char* record) {
  std::string lines;
  for (size_t i = 0; i < entry.values.size(); ++i) {
    const auto& [name, value] = entry.values[i];
    lines += line(entry, record, name, number(value), "", "", unitOf(entry, i));
  }
  return lines;
}

std::string noteLines(const LogEntry& entry) {
  if (entry.unknown_set) {
    return line(entry, "event", "unknown set", "", entry.name);
  }
  std::string lines = entry.values.empty() ? line(entry, "log", entry.name, "") : "";
  for (size_t i = 0; i < entry.values.size(); ++i) {
    lines +=
        line(entry, "log", entry.name, number(entry.values[i].second), "", "", unitOf(entry, i));
  }
  return lines;
}

/// "3 times", "1 time": the words of an event's value.
std::string valueText(const LogEntry& entry) {
  std::string text = entry.value_words;
  const auto place = text.find("{}");
  text.replace(place, place == std::string::npos ? 0 : 2, known(entry.value));
  for (auto plural = text.find("(s)"); plural != std::string::npos; plural = text.find("(s)")) {
    text.replace(plural, 3, entry.value == 1 ? "" : "s");
  }
  return text;
}

std::string withList(std::string text, const std::string& list) {
  return list.empty() ? text : text + ": " + list;
}

std::string story(const LogEntry& entry, const WriteValues& values) {
  switch (entry.kind) {
    case LogRecord::Start:
      return "the program of mission " + report::plain(entry.name) + " starts";
    case LogRecord::Begin:
      return withList("the mission begins", values(entry));
    case LogRecord::Transition:
      return withList(
          fmt::format("{} → {} ({}, case {})", report::plain(entry.detail),
                      entry.to.empty() ? "end" : report::plain(entry.to), entry.name, entry.number),
          values(entry));
    case LogRecord::Note:
      return entry.unknown_set ? "unknown set: " + report::plain(entry.name)
                               : withList("log " + report::plain(entry.name), values(entry));
    case LogRecord::Event:
      return entry.name + (entry.detail.empty() ? "" : ": " + entry.detail) +
             (std::isnan(entry.value) ? "" : fmt::format(" ({})", valueText(entry)));
    case LogRecord::Values:
    case LogRecord::Name:
      break;
  }
  return values(entry);
}

std::string plainLines(const LogEntry& entry) {
  switch (entry.kind) {
    case LogRecord::Start:
      return line(entry, "start", entry.name, "");
    case LogRecord::Begin:
      return line(entry, "begin", "", "") + valueLines(entry, "parameter");
    case LogRecord::Values:
      return valueLines(entry, "value");
    case LogRecord::Transition:
      return line(entry, "transition", entry.name, std::to_string(entry.number), entry.detail,
                  entry.to) +
             valueLines(entry, "fired");
    case LogRecord::Note:
      return noteLines(entry);
    case LogRecord::Event:
      return line(entry, "event", entry.name, number(entry.value), entry.detail);
    case LogRecord::Name:
      break;
  }
  return "";
}

}  // namespace

std::string valuesAsLogged(const LogEntry& entry) {
  std::string list;
  for (const auto& [name, value] : entry.values) {
    list +=
        (list.empty() ? "" : ", ") + (name.empty() ? "" : report::plain(name) + " ") + known(value);
  }
  return list;
}

std::string csvHead(bool with_units) {
  return fmt::format("time_s,record,name,value,from,to{}\n", with_units ? ",unit" : "");
}

/// A line without a value has an empty unit.
std::string csvLines(const LogEntry& entry, bool with_units) {
  constexpr std::ptrdiff_t kCommas = 5;
  std::string lines = plainLines(entry);
  for (size_t at = 0; with_units && at < lines.size();) {
    const size_t end = lines.find('\n', at);
    const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(at);
    const auto stop = lines.begin() + static_cast<std::ptrdiff_t>(end);
    const bool lacks = entry.units.empty() || std::count(begin, stop, ',') == kCommas;
    lines.insert(end, lacks ? "," : "");
    at = end + (lacks ? 2 : 1);
  }
  return lines;
}

std::string textLine(const LogEntry& entry, const WriteValues& values) {
  return fmt::format("{:10.1f} s  {}\n", entry.time, story(entry, values));
}

}  // namespace glider::logs
