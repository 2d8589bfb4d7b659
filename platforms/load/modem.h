// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace glider::platforms {

/// The acoustic modem of a vehicle: [modem].
struct Modem {
  std::string kind;           ///< "micro-modem": the sentences of hooks/micro_modem
  double frame_bytes = 0;     ///< that a frame holds
  double cycle_init_s = 0;    ///< the packet that announces a frame
  double frame_s = 0;         ///< the frame itself
  double range_m = 0;         ///< beyond this, no frame is received
  double interference_m = 0;  ///< up to here it disturbs other frames; at least range_m
  double send_j_byte = 0;     ///< the energy of a frame, for each byte that it has room for
  double receive_j_byte = 0;
  double listen_W = 0;  ///< drawn at all times while it is on
};

/// The energy of a mini packet, J: it is as long in the water as the packet that announces a frame,
/// and draws as much as data in that time.
inline double miniJ(const Modem& modem, double j_byte) {
  return j_byte * modem.frame_bytes * modem.cycle_init_s / modem.frame_s;
}

/// The control cycle of the slowest kind of vehicle, a Slocum, s: vehicles of several kinds take
/// turns together, and each begins within it.
inline constexpr double kSlowestCycle_s = 4;

/// How long the slot of a vehicle must be, in whole seconds: a control cycle of `cycle_s` by which
/// the vehicle's report of UTC is late, one within which the SBC begins, a second between two looks
/// at the modem, the dialogue with it, then the packet and the frame, and the time that sound needs
/// to where it disturbs no other frame.
double slotOf(const Modem& modem, double cycle_s);

}  // namespace glider::platforms
