// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/clock.h"
#include "runtime/board/options.h"
#include "runtime/core/runtime.h"

/// The line to an acoustic modem, of the program of a mission with shares. It is chosen when the
/// program is linked: runtime/talk/modem_line.cpp has one, no_modem_line.cpp has none. Only
/// main.cpp calls these, which is compiled together with either: a program without such a line does
/// not grow by them.
namespace glider::runtime {

/// Takes the line's options, if their values make sense, out of the arguments; returns how many are
/// left.
int takeModemOptions(int argc, char** argv);

/// Prints its part of --help.
void tellModemOptions();

/// Opens the line if its options name one. A line that cannot be opened is reported, and nothing
/// more: the mission flies without it. Returns kDone, or, with the reason on standard error, the
/// exit status. `program`: what its other options say.
int openModemLine(const Options& program);

/// Does what the modem needs now; never blocks. To be called between polls of the runtime.
void serveModem(const GliderRuntime& runtime, const GliderClock& clock);

/// Sleeps as waitForLine, also until the modem has bytes. False, without having slept, if there is
/// no modem.
bool waitForBoth(int line);

}  // namespace glider::runtime
