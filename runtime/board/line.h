// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/runtime.h"
#include "runtime/board/options.h"
#include "runtime/board/port.h"

/// What every program on a board does before and between polls.
namespace glider::runtime {

/// Exit statuses.
inline constexpr int kDone = 0;
inline constexpr int kWrongUse = 1;
inline constexpr int kNoLink = 2;
inline constexpr int kBadParameters = 2;

/// Answers --help (but for the parameters), --version and what is neither; returns the exit status.
int tellWish(const Options& options, const char* mission_name);

/// False, and says so, if log and checkpoints would be written into the same file.
bool areFilesApart(const Options& options);

/// Opens the line that the options name; says on standard error why it cannot.
OpenPort openLine(const Options& options);

/// Opens the log that the options name, if any. One that cannot be opened earns a warning: the
/// mission flies without.
GliderLogSink openLogOf(const Options& options);

/// Sleeps until there are bytes, or the clock may have something to say.
void waitForLine(int descriptor);

}  // namespace glider::runtime
