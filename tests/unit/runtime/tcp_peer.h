// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <arpa/inet.h>
#include <cstdint>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

/// The other end of a TCP connection, on this computer.
namespace glider::runtime::testing {

class TcpPeer {
 public:
  /// Has a port, at which it does not listen yet.
  TcpPeer() : listener_(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    (void)bind(listener_, reinterpret_cast<const sockaddr*>(&address), size);
    (void)getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
  }
  TcpPeer(const TcpPeer&) = delete;
  TcpPeer& operator=(const TcpPeer&) = delete;
  ~TcpPeer() {
    hangUp();
    close(listener_);
  }

  [[nodiscard]] uint16_t port() const { return port_; }
  void listen(int backlog = 8) const { (void)::listen(listener_, backlog); }
  /// Takes the newest connection that waits, in place of the one that it has. True if one waited.
  bool accept() {
    bool any = false;
    for (int made = 0; (made = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK)) >= 0;) {
      hangUp();
      connection_ = made;
      const int at_once = 1;  // not when what was sent before has been confirmed
      (void)setsockopt(made, IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once);
      ++accepted_;
      any = true;
    }
    return any;
  }
  [[nodiscard]] bool isConnected() const { return connection_ >= 0; }
  [[nodiscard]] int accepted() const { return accepted_; }
  void send(const std::vector<uint8_t>& bytes) const {
    (void)!::send(connection_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }
  /// What has arrived; waits a moment for it. Hangs up when the other end has.
  std::vector<uint8_t> receive(int wait_ms = 0) {
    std::vector<uint8_t> all;
    uint8_t some[4096];
    for (int waits_ms = wait_ms; isConnected(); waits_ms = 0) {
      pollfd wanted{connection_, POLLIN, 0};
      (void)poll(&wanted, 1, waits_ms);
      const ssize_t count = recv(connection_, some, sizeof some, 0);
      if (count > 0) {
        all.insert(all.end(), some, some + count);
      } else if (count == 0) {
        hangUp();
      } else {
        break;
      }
    }
    return all;
  }
  void hangUp() {
    if (connection_ >= 0) {
      close(connection_);
    }
    connection_ = -1;
  }
  /// Ends the connection as a computer does that has restarted.
  void reset() {
    const linger none{1, 0};
    (void)setsockopt(connection_, SOL_SOCKET, SO_LINGER, &none, sizeof none);
    hangUp();
  }

 private:
  int listener_;
  int connection_ = -1;
  int accepted_ = 0;
  uint16_t port_ = 0;
};

/// Connections that wait at a port: while they do, the kernel drops what would be one too many for
/// a listener with a backlog of 0.
class Crowd {
 public:
  explicit Crowd(uint16_t port) {
    for (int& one : all_) {
      one = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
      sockaddr_in address{};
      address.sin_family = AF_INET;
      address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
      address.sin_port = htons(port);
      (void)connect(one, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    }
  }
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;
  ~Crowd() {
    for (const int one : all_) {
      close(one);
    }
  }

 private:
  int all_[4];
};

}  // namespace glider::runtime::testing
