// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/commands.h"

namespace glider::simulator {

const char* abortName(Abort abort) {
  switch (abort) {
    case Abort::None:
      return "none";
    case Abort::StackIdle:
      return "MS_ABORT_STACK_IS_IDLE";
    case Abort::HeadingIdle:
      return "MS_ABORT_HEADING_IS_IDLE";
    case Abort::PitchIdle:
      return "MS_ABORT_PITCH_IS_IDLE";
    case Abort::PumpIdle:
      return "MS_ABORT_BPUMP_IS_IDLE";
    case Abort::Overdepth:
      return "MS_ABORT_OVERDEPTH";
    case Abort::Overtime:
      return "MS_ABORT_OVERTIME";
    case Abort::Undervolts:
      return "MS_ABORT_UNDERVOLTS";
    case Abort::SameDepth:
      return "MS_ABORT_SAMEDEPTH";
    case Abort::NoTickle:
      return "MS_ABORT_NO_TICKLE";
    case Abort::DeviceError:
      return "MS_ABORT_DEVICE_ERROR";
    case Abort::WaypointTooFar:
      return "MS_ABORT_WPT_TOOFAR";
    case Abort::OutOfBand:
      return "out of band";
  }
  return "unknown";
}

uint8_t Commands::maskedFor(int of_layer) const {
  return static_cast<uint8_t>((heading_layer != of_layer ? hooks::kMaskedHeading : 0) |
                              (pitch_layer != of_layer ? hooks::kMaskedPitch : 0) |
                              (pump_layer != of_layer ? hooks::kMaskedPump : 0));
}

Abort Commands::idleAbort() const {
  if (!heading && !pitch && !pump_cc) {
    return Abort::StackIdle;
  }
  if (!heading) {
    return Abort::HeadingIdle;
  }
  if (!pitch) {
    return Abort::PitchIdle;
  }
  return pump_cc ? Abort::None : Abort::PumpIdle;
}

}  // namespace glider::simulator
