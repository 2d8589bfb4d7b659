// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// The numbers of the mission log's format: runtime/README.md, "The mission log".
namespace glider::runtime {

inline constexpr uint8_t kLogVersion = 1;

enum class LogRecord : uint8_t {
#define LOG_RECORD(name, number) name = number,
#include "runtime/log/records.def"
};

enum class LogNamed : uint8_t {
#define LOG_NAMED(name, number) name = number,
#include "runtime/log/records.def"
};

enum class LogEvent : uint8_t {
#define LOG_EVENT(name, number, text, value) name = number,
#include "runtime/log/records.def"
};

enum class LogDetail : uint8_t {
#define LOG_DETAIL(name, number, text) name = number,
#include "runtime/log/records.def"
};

/// The checks of the program's own memory: details of CheckFailed.
enum class Check : uint8_t {
  None = 0,
#define LOG_CHECK(name, number, text) name = number,
#include "runtime/log/checks.def"
};

}  // namespace glider::runtime
