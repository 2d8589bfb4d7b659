// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/front_seat/network.h"

#include "runtime/board/kernel.h"

#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

namespace glider::runtime {
namespace {

/// Reads a number up to `most` and moves `text` past it; false if there is none.
bool readNumber(const char*& text, uint32_t most, uint32_t& number) {
  const char* const begin = text;
  number = 0;
  for (; *text >= '0' && *text <= '9' && number <= most; ++text) {
    number = number * 10 + static_cast<uint32_t>(*text - '0');
  }
  return text != begin && number <= most;
}

}  // namespace

bool readAddress(const char* text, uint16_t usual_port, NetworkAddress& address) {
  NetworkAddress read;
  uint32_t number = 0;
  for (uint32_t i = 0; i < 4; ++i) {
    if ((i > 0 && *text++ != '.') || !readNumber(text, 255, number)) {
      return false;
    }
    read.host[i] = static_cast<uint8_t>(number);
  }
  number = usual_port;
  if (*text == ':' && !readNumber(++text, 65535, number)) {
    return false;
  }
  if (number == 0 || *text != '\0') {
    return false;
  }
  read.port = static_cast<uint16_t>(number);
  address = read;
  return true;
}

sockaddr_in socketAddress(const NetworkAddress& address) {
  sockaddr_in made{};
  made.sin_family = AF_INET;
  memcpy(&made.sin_addr, address.host, sizeof address.host);
  const uint8_t port[2] = {static_cast<uint8_t>(address.port >> 8U),
                           static_cast<uint8_t>(address.port & 0xFFU)};
  memcpy(&made.sin_port, port, sizeof port);
  return made;
}

int makeSocket(int type) {
  const int made = socket(AF_INET, type, 0);
  if (made >= 0 && controlFile(made, F_SETFL, O_RDWR | O_NONBLOCK) != 0) {
    close(made);
    return -1;
  }
  return made;
}

int NetworkOption::take(int argc, char** argv) {
  int kept = 0;
  for (int i = 0; i < argc; ++i) {
    if (i + 1 < argc && strcmp(argv[i], name) == 0 &&
        readAddress(argv[i + 1], usual_port, address)) {
      text = argv[++i];
    } else {
      argv[kept++] = argv[i];
    }
  }
  return kept;
}

}  // namespace glider::runtime
