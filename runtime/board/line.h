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
inline constexpr int kCheckFailed = 3;

/// Silence is counted in seconds: the time to sleep when no byte arrives, ms.
inline constexpr int kNapMs = 1000;
/// In which the newest answer leaves the port of the slowest board.
inline constexpr int kSentMs = 200;

/// Handles --help (except for the parameters), --version and unknown arguments; returns the exit
/// status.
int tellWish(const Options& options, const char* mission_name);

/// Returns false, with a message, if log and checkpoints would be written to the same file.
bool areFilesApart(const Options& options);

/// Reports that a check of the program's own memory failed; returns the exit status.
int tellFailedCheck();

/// The serial port to the vehicle: that of the options, or the board's.
const char* portOf(const Options& options);

/// Opens the line that the options name; on failure prints the reason on standard error.
OpenPort openLine(const Options& options);

/// Opens the log that the options name, if any. If it cannot be opened, prints a warning: the
/// mission flies without it.
GliderLogSink openLogOf(const Options& options);

/// Puts the board to sleep by the file that the options name, if any; returns when it is awake.
void sleepBoard(const Options& options);

/// Sleeps until there are bytes, or until a time-out may have expired.
void waitForLine(int descriptor);

}  // namespace glider::runtime
