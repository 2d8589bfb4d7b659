// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/clothesline/clothesline.h"
#include "hooks/protocol/values.h"
#include "hooks/transport/byte_stream.h"

#include <stdint.h>

/// The proglet `hookprog` on the science computer: proxy of the SBC (115200 baud) for the flight
/// controller's data memory (9600 baud). Portable: no heap, no libc. It forwards nothing to the
/// flight controller until that reports a hookbeh.
namespace glider::hooks {

/// The science computer's own sensors, as hookprog sees them.
struct ScienceSensors {
  void* self;
  /// The newest value of sensor `id` and, in `fresh`, whether it is newer than the last call for
  /// it; NaN if never set.
  double (*get)(void* self, uint16_t id, bool* fresh);
};

struct HookprogOptions {
  bool virtual_time = false;  ///< told to the SBC
};

/// Things worth a line in the vehicle's log or the simulator's trace.
struct HookprogEvent {
  enum class Kind : uint8_t { None, SbcHello, SbcLost, SbcTransition, BadFrame } kind = Kind::None;
  double mission_time_s = 0;
  uint32_t a = 0, b = 0, c = 0, d = 0;  ///< SbcTransition: transition, from, to, fired case
  char text[48] = {};                   ///< SbcHello: the mission's name
};

class Hookprog {
 public:
  explicit Hookprog(const HookprogOptions& options);
  /// One science cycle (1 s): takes the flight controller's updates, serves the SBC, forwards its
  /// writes.
  void run(double science_time_s, const ScienceSensors& own, const GliderByteStream& sbc,
           const GliderByteStream& flight);
  /// Takes the oldest event; Kind::None when there is none.
  HookprogEvent nextEvent();
  /// The mission's last heartbeat, for the trace: valid when `known`.
  struct SbcView {
    bool known = false;
    double mission_time_s = 0;
    uint32_t state = 0;
    uint8_t stack_depth = 0;
    uint8_t phase = 0;
  };
  [[nodiscard]] SbcView sbc() const;
};

}  // namespace glider::hooks
