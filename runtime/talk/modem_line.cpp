// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/modem_line.h"

#include "hooks/transport/descriptor.h"
#include "hooks/transport/termios.h"
#include "runtime/board/files.h"
#include "runtime/board/kernel.h"
#include "runtime/board/line.h"
#include "runtime/board/own_line.h"
#include "runtime/board/port.h"
#include "runtime/talk/talker.h"

#include <new>
#include <poll.h>
#include <string.h>

extern "C" const GliderTalk gliderTalk;

namespace glider::runtime {
namespace {

using talk::Talker;

struct ModemOptions {
  const char* path = nullptr;
  uint32_t baud = 19200;
  uint32_t address = 0;   ///< 0: not given
  uint32_t vehicles = 0;  ///< the same
};

ModemOptions options;
GliderByteStream modem;
int descriptor = -1;  ///< for poll(2)
Talker* talker = nullptr;

/// A whole number from `lowest` to `highest`.
bool readWhole(const char* text, uint32_t lowest, uint32_t highest, uint32_t& number) {
  uint32_t value = 0;
  const char* c = text;
  for (; *c >= '0' && *c <= '9' && value <= highest; ++c) {
    value = value * 10 + static_cast<uint32_t>(*c - '0');
  }
  if (c == text || *c != '\0' || value < lowest || value > highest) {
    return false;
  }
  number = value;
  return true;
}

/// Whether it is one of the options, with a value that makes sense.
bool takeOption(const char* name, const char* value) {
  constexpr uint32_t kMostBaud = 4000000;
  constexpr uint32_t kMost = hooks::micro_modem::kMostAddress;
  if (strcmp(name, "--modem") == 0) {
    options.path = value;
    return true;
  }
  return (strcmp(name, "--modem-baud") == 0 && readWhole(value, 1, kMostBaud, options.baud)) ||
         (strcmp(name, "--address") == 0 && readWhole(value, 1, kMost, options.address)) ||
         (strcmp(name, "--vehicles") == 0 && readWhole(value, 1, kMost, options.vehicles));
}

int32_t readOpen(void* self, uint8_t* bytes, uint32_t capacity) {
  return hooks::readDescriptor(*static_cast<const int*>(self), bytes, capacity);
}

int32_t writeOpen(void* self, const uint8_t* bytes, uint32_t count) {
  return hooks::writeDescriptor(*static_cast<const int*>(self), bytes, count);
}

/// A descriptor that whoever started the program has opened: `fd:3`. Returns why it cannot be used,
/// or null.
const char* takeOpen(const char* number) {
  constexpr uint32_t kMostDescriptor = 65535;
  uint32_t open = 0;
  if (!readWhole(number, 0, kMostDescriptor, open)) {
    return "it is not the number of a descriptor";
  }
  const int flags = controlFile(static_cast<int>(open), F_GETFL, 0);
  if (flags < 0 || controlFile(static_cast<int>(open), F_SETFL, flags | O_NONBLOCK) != 0) {
    return "it is not open";
  }
  descriptor = static_cast<int>(open);
  modem = {&descriptor, readOpen, writeOpen};
  return nullptr;
}

const char* openDevice() {
  // It lives as long as the program: no exit handler.
  alignas(hooks::SerialDevice) static uint8_t memory[sizeof(hooks::SerialDevice)];
  auto* const device = ::new (memory) hooks::SerialDevice;
  const int error = device->open(options.path, options.baud);
  if (error != 0) {
    return portProblem(error);
  }
  descriptor = device->descriptor();
  modem = device->stream();
  return nullptr;
}

}  // namespace

int takeModemOptions(int argc, char** argv) {
  int kept = 0;
  for (int i = 0; i < argc; ++i) {
    if (i + 1 < argc && takeOption(argv[i], argv[i + 1])) {
      ++i;
    } else {
      argv[kept++] = argv[i];
    }
  }
  return kept;
}

void tellModemOptions() {
  tell(
      "to share values with other vehicles:\n"
      "  --modem PATH  the line to the acoustic modem, or fd:N, which is open already\n"
      "  --modem-baud N  its speed (19200)\n"
      "  --address N  of this vehicle, 1 to 15\n"
      "  --vehicles N  how many take turns to send");
}

int openModemLine(const Options& program) {
  if (options.path == nullptr) {
    tell("without --modem, nothing is shared with other vehicles");
    return kDone;
  }
  if (options.address == 0 || options.vehicles == 0) {
    tell("error: --modem needs --address and --vehicles; see --help");
    return kWrongUse;
  }
  if (!Talker::isAddress(options.address, options.vehicles)) {
    tell("error: --address is greater than --vehicles");
    return kWrongUse;
  }
  if (gliderTalk.vehicle_count != 0 && options.address > gliderTalk.vehicle_count) {
    tell("error: no vehicle of the mission has this --address");
    return kWrongUse;
  }
  const bool serial = !program.stdio && ownDescriptor() == nullptr;
  if (serial && strcmp(options.path, portOf(program)) == 0) {
    tell("error: --modem and the line to the vehicle are both `", options.path, "`");
    return kWrongUse;
  }
  constexpr char kOpen[] = "fd:";
  constexpr uint32_t kOpenSize = sizeof kOpen - 1;
  const char* problem = strncmp(options.path, kOpen, kOpenSize) == 0
                            ? takeOpen(options.path + kOpenSize)
                            : openDevice();
  if (problem != nullptr) {  // the mission must not depend on it, above all not after a restart
    tell("warning: cannot open `", options.path, "`: ", problem,
         "; nothing is shared with other vehicles");
    return kDone;
  }
  alignas(Talker) static uint8_t memory[sizeof(Talker)];
  talker = ::new (memory) Talker(gliderTalk, options.address, options.vehicles);
  return kDone;
}

void serveModem(const GliderRuntime& runtime, const GliderClock& clock) {
  if (talker == nullptr) {
    return;
  }
  auto* context = runtime.context() != nullptr
                      ? reinterpret_cast<GliderContext*>(gliderContextMemory)
                      : nullptr;
  talker->poll(modem, context, runtime.ownTime(clock));
  if (talker->isClosed()) {
    tell("the line to the modem is closed: nothing more is shared with other vehicles");
    talker = nullptr;
  }
}

bool waitForBoth(int line) {
  if (talker == nullptr) {
    return false;
  }
  pollfd wanted[] = {{line, POLLIN, 0}, {descriptor, POLLIN, 0}};
  if (poll(wanted, 2, kNapMs) < 0) {
    (void)poll(nullptr, 0, 10);  // never spin, for any error that poll reports for the lines
  }
  return true;
}

}  // namespace glider::runtime
