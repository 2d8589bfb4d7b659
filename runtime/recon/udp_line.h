// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/line_reader.h"
#include "hooks/transport/byte_stream.h"
#include "hooks/transport/clock.h"
#include "runtime/front_seat/network.h"

#include <stdint.h>

namespace glider::runtime::recon {

/// The port on both sides, if no other is given.
inline constexpr uint16_t kUsualPort = 23456;

/// The line to a vehicle that speaks RECON in datagrams of UDP, one line in each. Neither end knows
/// whether the other is there: a vehicle that is not up yet, or restarts, changes nothing here. A
/// write takes kPauseMs; nothing blocks for longer. Uses only what Linux 2.4 has; no heap.
class UdpLine {
 public:
  /// Before each datagram, ms: the vehicle drops those that come too fast.
  static constexpr int kPauseMs = 2;
  /// From one attempt to get the port to the next, s.
  static constexpr double kRetrySecs = 2;
  /// So many datagrams of others are passed over at once.
  static constexpr uint32_t kMostStrangersAtOnce = 64;

  enum class News : uint8_t {
    NoPort,    ///< it cannot be had: another program may have it
    Heard,     ///< the vehicle's first datagram
    Stranger,  ///< the 1st, 10th, 100th... datagram from another address
  };
  /// Called when something is new; NoPort only once. `count` is that of the strangers' datagrams.
  using Report = void (*)(News news, uint32_t count);

  /// `clock` is the SBC's own. `report` may be null.
  UdpLine(const NetworkAddress& vehicle, const GliderClock& clock, Report report)
      : vehicle_(vehicle), clock_(clock), report_(report) {}
  UdpLine(const UdpLine&) = delete;
  UdpLine& operator=(const UdpLine&) = delete;
  ~UdpLine() { close(); }

  /// Reads the vehicle's datagrams; what does not end with a line feed is given one, so that half a
  /// line is not joined with the next. Writes a line in one datagram; one that cannot be sent is
  /// lost, as any may be on its way. Points into this object.
  [[nodiscard]] GliderByteStream stream() { return {this, read, write}; }
  /// For poll(2); -1 while there is no socket. Points into this object.
  [[nodiscard]] const int* descriptor() const { return &fd_; }
  /// Datagrams from other addresses than the vehicle's.
  [[nodiscard]] uint32_t strangers() const { return strangers_; }

 private:
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count);
  bool receive();
  bool open();
  [[nodiscard]] bool bindPort() const;
  void noteStranger();
  void noteHeard();
  void tell(News news, uint32_t count) const;
  void close();

  NetworkAddress vehicle_;
  GliderClock clock_;
  Report report_;
  int fd_ = -1;
  bool heard_ = false;
  bool told_no_port_ = false;
  double began_s_ = -kRetrySecs;  ///< the newest attempt
  uint32_t strangers_ = 0;
  uint32_t tells_at_ = 1;  ///< so many strangers are reported next; 0: no more
  /// A datagram; of one that is too long as much as shows it, so that it counts as damaged.
  uint8_t in_[hooks::recon::kMostLine + 2];  // and the line feed
  uint32_t next_ = 0, end_ = 0;
};

}  // namespace glider::runtime::recon
