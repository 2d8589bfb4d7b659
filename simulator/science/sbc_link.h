// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/journal.h"
#include "simulator/sbc_port.h"
#include "simulator/science/serial_line.h"

#include <vector>

namespace glider::simulator {

/// Joins the SBC to its end of the serial line, in lockstep, and notes how it ends.
class SbcLink {
 public:
  /// `port` may be null: a line with nobody at its other end.
  SbcLink(SbcPort* port, SerialLine& line, Journal& journal)
      : port_(port), end_(line.right()), journal_(journal) {}

  /// Hands over what has arrived by `now_s` and puts the answers on the line.
  void pump(double now_s);
  /// Cuts the SBC's power.
  void kill(double now_s);
  [[nodiscard]] bool alive() const { return port_ != nullptr && port_->alive(); }

 private:
  void noteDeath(double now_s);

  SbcPort* port_;
  GliderByteStream end_;
  Journal& journal_;
  std::vector<uint8_t> waiting_;  ///< answers that the line had no room for yet
  bool death_noted_ = false;
};

}  // namespace glider::simulator
