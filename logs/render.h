// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "logs/reader.h"

#include <functional>
#include <string>

namespace glider::logs {

/// The head of what csvLines makes.
std::string csvHead(bool with_units = false);

/// An entry as lines of comma-separated values (docs/guide.md has the columns).
std::string csvLines(const LogEntry& entry, bool with_units = false);
/// How the values of an entry are written for people.
using WriteValues = std::function<std::string(const LogEntry&)>;
/// "depth 10.2, temp unknown": as in the log, which has no units.
std::string valuesAsLogged(const LogEntry& entry);
/// An entry as one line for people.
std::string textLine(const LogEntry& entry, const WriteValues& values = valuesAsLogged);

}  // namespace glider::logs
