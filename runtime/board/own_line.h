// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/board/port.h"

/// A line of the dialect's own (dialect.h), beside a serial port and standard input and output. It
/// is chosen when the program is linked: runtime/imc/program.cpp and runtime/recon/program.cpp have
/// one, no_own_line.cpp has none. Only main.cpp calls these, which is compiled together with
/// either: a program without such a line does not grow by them.
namespace glider::runtime {

/// Takes the line's option, if it has a value that makes sense, out of the arguments; returns how
/// many are left.
int takeOwnLine(int argc, char** argv);

/// Prints its part of --help.
void tellOwnLine();

/// Opens the line if its option was there; otherwise false, with `line` unchanged.
bool openOwnLine(OpenPort& line);

/// The descriptor of the open line now, for poll(2): it changes when the line is opened again, and
/// is -1 meanwhile. Null: the program uses another line.
const int* ownDescriptor();

}  // namespace glider::runtime
