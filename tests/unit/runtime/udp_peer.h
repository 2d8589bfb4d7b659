// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <arpa/inet.h>
#include <cstdint>
#include <ctime>
#include <netinet/in.h>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

/// Datagrams between addresses of this computer: the program is at 127.0.0.1, the vehicle at
/// 127.0.0.2, both at the same port.
namespace glider::runtime::testing {

inline sockaddr_in loopback(uint8_t last, uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(0x7F000000U + last);
  address.sin_port = htons(port);
  return address;
}

struct Datagram {
  std::string bytes;
  double time_s = 0;  ///< when it was sent
};

class UdpPeer {
 public:
  /// At 127.0.0.`last`. `port` 0: one that is free there and at 127.0.0.1.
  explicit UdpPeer(uint16_t port = 0, uint8_t last = 2) : port_(port), last_(last) {
    if (port != 0) {
      open(port);
      return;
    }
    while (!open(0) || !isFree()) {
      close();
    }
  }
  UdpPeer(const UdpPeer&) = delete;
  UdpPeer& operator=(const UdpPeer&) = delete;
  ~UdpPeer() { close(); }

  [[nodiscard]] uint16_t port() const { return port_; }
  [[nodiscard]] bool isOpen() const { return socket_ >= 0; }
  void close() {
    if (socket_ >= 0) {
      ::close(socket_);
    }
    socket_ = -1;
  }
  /// Again at its port.
  bool open() { return open(port_); }
  /// To 127.0.0.1 at `port`; 0: its own.
  void send(const std::string& bytes, uint16_t port = 0) const {
    const sockaddr_in to = loopback(1, port == 0 ? port_ : port);
    (void)!sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to),
                  sizeof to);
  }
  /// What has arrived; waits so long for the first.
  [[nodiscard]] std::vector<Datagram> receive(int wait_ms) const {
    std::vector<Datagram> all;
    pollfd wanted{socket_, POLLIN, 0};
    for (int waits_ms = wait_ms; socket_ >= 0 && poll(&wanted, 1, waits_ms) > 0; waits_ms = 0) {
      char bytes[4096];
      alignas(cmsghdr) char control[128];
      iovec part{bytes, sizeof bytes};
      msghdr message{};
      message.msg_iov = &part;
      message.msg_iovlen = 1;
      message.msg_control = control;
      message.msg_controllen = sizeof control;
      const ssize_t size = recvmsg(socket_, &message, 0);
      const cmsghdr* const stamp = CMSG_FIRSTHDR(&message);
      if (size < 0 || stamp == nullptr) {
        break;
      }
      timespec time{};
      std::copy_n(CMSG_DATA(stamp), sizeof time, reinterpret_cast<unsigned char*>(&time));
      all.push_back({std::string(bytes, static_cast<size_t>(size)),
                     static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9});
    }
    return all;
  }

 private:
  bool open(uint16_t port) {
    socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const int on = 1;
    (void)setsockopt(socket_, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
    sockaddr_in address = loopback(last_, port);
    socklen_t size = sizeof address;
    if (bind(socket_, reinterpret_cast<const sockaddr*>(&address), size) != 0) {
      close();
      return false;
    }
    (void)getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    return true;
  }
  [[nodiscard]] bool isFree() const {
    const int probe = socket(AF_INET, SOCK_DGRAM, 0);
    const sockaddr_in address = loopback(1, port_);
    const bool free = bind(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    ::close(probe);
    return free;
  }

  int socket_ = -1;
  uint16_t port_;
  uint8_t last_;
};

}  // namespace glider::runtime::testing
