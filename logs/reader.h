// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/log/records.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Reads the mission log of an SBC (runtime/README.md, "The mission log").
namespace glider::logs {

/// One entry of the log, with the names that the log defines.
struct LogEntry {
  runtime::LogRecord kind = runtime::LogRecord::Start;
  double time = 0;                 ///< mission time, s; 0 for Start and Begin
  std::string name;                ///< the mission, the transition, the text of a note, the event
  std::string detail;              ///< of an event; for a transition the state left
  std::string to;                  ///< for a transition: the state entered; empty after exit
  uint32_t number = 0;             ///< for a transition: its case, from 1
  bool unknown_set = false;        ///< a note that a `set` changed nothing
  double value = 0;                ///< of an event; NaN: none
  std::string value_words = "{}";  ///< its words, as in runtime/log/records.def
  /// Items of Values, parameters of Begin, values of a note (without names); for a transition
  /// statetime, resumetime and every sensor's reading; NaN: unknown.
  std::vector<std::pair<std::string, double>> values;
  std::vector<std::string> units = {};  ///< of the values; the log has none: empty
};

/// How much of a log was damaged.
struct LogDamage {
  uint32_t starts = 0;      ///< how often a program began to write
  uint32_t records = 0;     ///< valid ones
  uint32_t bad = 0;         ///< stretches without a valid record: torn writes, damage
  uint32_t missing = 0;     ///< missing records, counted by the gap in their numbers, modulo 256
  uint32_t unreadable = 0;  ///< records of another version, or without a valid meaning
};

/// Reads `bytes`, which may be any bytes, and passes the valid records to `take`, in order.
LogDamage readLog(std::string_view bytes, const std::function<void(const LogEntry&)>& take);

}  // namespace glider::logs
