// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The fake pilot as a program over a serial port: simulator_sbc_program PORT [MODE TICKS]. After so
// many ticks it ends (exit), ends 1.5 s after it has closed the port (linger), hangs (hang),
// or hangs with its port closed (close).

#include "hooks/transport/host/serial_port.h"
#include "hooks/transport/system_clock.h"
#include "tests/unit/simulator/fake_sbc.h"

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <poll.h>
#include <string_view>
#include <unistd.h>
#include <utility>

int main(int argc, char** argv) {
  if (argc < 2) {
    return 2;
  }
  auto opened = glider::hooks::SerialPort::open(argv[1], 115200);
  if (!opened) {
    std::fprintf(stderr, "%s\n", opened.error().message.c_str());
    return 3;
  }
  std::optional port(std::move(*opened));
  const std::string_view mode = argc > 3 ? argv[2] : "";
  const int most_ticks = argc > 3 ? std::atoi(argv[3]) : 1 << 30;
  glider::simulator::FakePilot pilot({});
  const GliderByteStream stream = port->stream();
  glider::hooks::SystemClock clock;
  while (!pilot.closed() && pilot.ticks() < most_ticks) {
    pilot.poll(stream, clock.clock(), most_ticks);
    ::usleep(200);
  }
  if (mode == "linger" || mode == "close") {
    port.reset();
  }
  while (mode == "hang" || mode == "close") {
    ::pause();
  }
  if (mode == "linger") {
    ::usleep(1'500'000);
  }
  return pilot.closed() ? 0 : 7;
}
