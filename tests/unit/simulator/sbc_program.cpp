// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The fake pilot as a program over a serial port: simulator_sbc_program PORT [hang|exit
// SECONDS-OF-TICKS]

#include "hooks/transport/host/serial_port.h"
#include "hooks/transport/system_clock.h"
#include "tests/unit/simulator/fake_sbc.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <poll.h>
#include <unistd.h>

int main(int argc, char** argv) {
  if (argc < 2) {
    return 2;
  }
  auto port = glider::hooks::SerialPort::open(argv[1], 115200);
  if (!port) {
    std::fprintf(stderr, "%s\n", port.error().message.c_str());
    return 3;
  }
  const bool hangs = argc > 3 && std::strcmp(argv[2], "hang") == 0;
  const int most_ticks = argc > 3 ? std::atoi(argv[3]) : 1 << 30;
  glider::simulator::FakePilot pilot({});
  const GliderByteStream stream = port->stream();
  glider::hooks::SystemClock clock;
  while (!pilot.closed() && pilot.ticks() < most_ticks) {
    pilot.poll(stream, clock.clock());
    ::usleep(200);
  }
  while (hangs) {
    ::pause();
  }
  return pilot.closed() ? 0 : 7;
}
