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

/// The mission log of an SBC (runtime/README.md, "The mission log"), read back.
namespace glider::logs {

/// One thing that the log tells, with the names that it gives itself.
struct LogEntry {
  runtime::LogRecord kind = runtime::LogRecord::Start;
  double time = 0;           ///< mission time, s; 0 of Start and Begin
  std::string name;          ///< the mission, the transition, the text of a note, the event
  std::string detail;        ///< of an event; of a transition the state left
  std::string to;            ///< of a transition: the state entered; empty after exit
  uint32_t number = 0;       ///< of a transition: its case, from 1
  bool unknown_set = false;  ///< a note that a `set` changed nothing
  double value = 0;          ///< of an event; NaN: none
  /// Items of Values, parameters of Begin, values of a note (without names), of a transition
  /// statetime, resumetime and every sensor's reading; NaN: unknown.
  std::vector<std::pair<std::string, double>> values;
};

/// How much of a log was no good.
struct LogDamage {
  uint32_t starts = 0;      ///< how often a program began to write
  uint32_t records = 0;     ///< good ones
  uint32_t bad = 0;         ///< stretches that are no record: torn writes, damage
  uint32_t missing = 0;     ///< records of which only the gap in the numbers is left, modulo 256
  uint32_t unreadable = 0;  ///< records of another version, or that make no sense
};

/// Reads `bytes`, any bytes, and hands on what is good in them, in order.
LogDamage readLog(std::string_view bytes, const std::function<void(const LogEntry&)>& take);

}  // namespace glider::logs
