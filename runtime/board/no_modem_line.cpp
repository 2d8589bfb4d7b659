// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/line.h"
#include "runtime/board/modem_line.h"

namespace glider::runtime {

int takeModemOptions(int argc, char** /*argv*/) {
  return argc;
}

void tellModemOptions() {}

int openModemLine(const Options& /*program*/) {
  return kDone;
}

void serveModem(const GliderRuntime& /*runtime*/, const GliderClock& /*clock*/) {}

bool waitForBoth(int /*line*/) {
  return false;
}

}  // namespace glider::runtime
