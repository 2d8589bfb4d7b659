// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/modem.h"
#include "simulator/acoustics/acoustic_frame.h"

#include <cstdint>

namespace glider::simulator {

/// The numbers of a simulated modem.
struct ModemSettings {
  double range_m = 0;         ///< beyond this, no frame is received
  double interference_m = 0;  ///< up to here it destroys other frames
  double cycle_init_s = 0;    ///< the packet that announces a frame
  double frame_s = 0;
  uint32_t frame_bytes = 0;  ///< that a frame holds
  double send_J = 0;         ///< for a frame
  double receive_J = 0;      ///< for a frame
  double send_mini_J = 0;    ///< for a mini packet
  double receive_mini_J = 0;
  double listen_W = 0;

  [[nodiscard]] double lengthOf(const AcousticFrame& frame) const {
    return frame.is_mini ? cycle_init_s : cycle_init_s + frame_s;
  }
};

inline ModemSettings modemSettings(const platforms::Modem& modem) {
  return {.range_m = modem.range_m,
          .interference_m = modem.interference_m,
          .cycle_init_s = modem.cycle_init_s,
          .frame_s = modem.frame_s,
          .frame_bytes = static_cast<uint32_t>(modem.frame_bytes),
          .send_J = modem.send_j_byte * modem.frame_bytes,
          .receive_J = modem.receive_j_byte * modem.frame_bytes,
          .send_mini_J = platforms::miniJ(modem, modem.send_j_byte),
          .receive_mini_J = platforms::miniJ(modem, modem.receive_j_byte),
          .listen_W = modem.listen_W};
}

}  // namespace glider::simulator
