// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"
#include "hooks/transport/clock.h"
#include "runtime/front_seat/network.h"

#include <stdint.h>

namespace glider::runtime::imc {

/// The connection to the vehicle's port for a back seat. It is opened again whenever it has ended:
/// the vehicle may not be up yet, may restart, or may close it. Uses only what Linux 2.4 has; never
/// blocks; no heap.
class TcpLine {
 public:
  /// From the begin of an attempt to that of the next, s.
  static constexpr double kRetrySecs = 2;
  /// An attempt that takes longer is given up, and so is a connection on which nothing has arrived
  /// for so long, s: a vehicle reports several times a second, and one that has lost its power
  /// closes nothing.
  static constexpr double kPatienceSecs = 10;
  /// Called when there is a connection, and when there is none.
  using Report = void (*)(bool connected);

  /// `clock` is the SBC's own. `report` may be null.
  TcpLine(const NetworkAddress& address, const GliderClock& clock, Report report)
      : address_(address), clock_(clock), report_(report) {}
  TcpLine(const TcpLine&) = delete;
  TcpLine& operator=(const TcpLine&) = delete;
  ~TcpLine() { close(); }

  /// Reads and writes kGliderStreamClosed while there is no connection; each read opens it again
  /// when that is due. Points into this object.
  [[nodiscard]] GliderByteStream stream() { return {this, read, write}; }
  /// Ends the connection, so that a read opens another.
  void renew() { close(); }
  /// For poll(2); -1 while there is no connection. Points into this object.
  [[nodiscard]] const int* descriptor() const { return &fd_; }

 private:
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count);
  void open(double now_s);
  void lookAtAttempt(double now_s);
  void tell(bool connected);
  void close();

  NetworkAddress address_;
  GliderClock clock_;
  Report report_;
  int fd_ = -1;
  bool connected_ = false;
  bool told_ = false;             ///< the newest report
  bool has_told_ = false;         ///< there was a report
  double began_s_ = -kRetrySecs;  ///< the newest attempt
  double heard_s_ = 0;            ///< the newest byte, or the connection
};

}  // namespace glider::runtime::imc
