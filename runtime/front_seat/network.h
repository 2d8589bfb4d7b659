// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <netinet/in.h>
#include <stdint.h>

/// What lines to a vehicle over a network share. Uses only what Linux 2.4 has.
namespace glider::runtime {

/// An IPv4 address and a port of TCP or UDP.
struct NetworkAddress {
  uint8_t host[4] = {};
  uint16_t port = 0;
};

/// Reads an address as "127.0.0.1:6006", or without the port, which then is `usual_port`; if that
/// is 0, the text must have one. False, with `address` unchanged, if the text is anything else.
bool readAddress(const char* text, uint16_t usual_port, NetworkAddress& address);

/// As the kernel has it.
sockaddr_in socketAddress(const NetworkAddress& address);

/// A socket (SOCK_STREAM, SOCK_DGRAM) that never blocks; -1 if there is none.
int makeSocket(int type);

/// An option of the command line whose value is an address.
struct NetworkOption {
  const char* name;             ///< "--tcp"
  uint16_t usual_port = 0;      ///< of readAddress
  const char* text = nullptr;   ///< its value; null: it was not there
  NetworkAddress address = {};  ///< the same, read

  /// Takes it, if its value is an address, out of the arguments; returns how many are left.
  int take(int argc, char** argv);
};

}  // namespace glider::runtime
