// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/values.h"
#include "hooks/transport/byte_stream.h"
#include "hooks/transport/clock.h"

#include <stdint.h>

/// The SBC's side of the 115200 line. It only ever speaks in answer to a frame of the vehicle;
/// every answer ends with a Done message, which is the heartbeat at sea and the lockstep in virtual
/// time. No heap; one object a glider.
namespace glider::hooks {

inline constexpr uint32_t kMostSubscriptions = 64;

struct Reading {
  uint16_t id = 0;   ///< number in the platform file
  double value = 0;  ///< in the vehicle's unit
};

/// One control cycle of the vehicle as its frame tells it.
struct VehicleTick {
  double vehicle_time_s = 0;  ///< since the vehicle's own mission started
  uint32_t cycle = 0;
  HookState hook_state = HookState::Absent;
  HookAnswer answer = HookAnswer::None;
  uint16_t answered_sequence = 0;
  uint32_t session = 0;  ///< in control, 0 for none
  uint32_t reading_count = 0;
  Reading readings[kMostSubscriptions];  ///< those fresh in this cycle
};

/// A transition of the mission, told to the vehicle's side for logs and the simulator's trace.
struct TransitionNotice {
  double mission_time_s = 0;
  uint8_t transition = 0;  ///< GliderTransition
  uint32_t from = 0;
  uint32_t to = 0;
  uint32_t fired_case = 0;  ///< of state `from`
};

/// What the heartbeat says of the mission.
struct MissionStatus {
  double mission_time_s = 0;
  uint32_t state = 0;
  uint8_t stack_depth = 0;
  uint8_t phase = 0;  ///< 0 waiting for control, 1 flying, 2 finished
};

struct ClientOptions {
  const char* mission_name = "";
  uint32_t session = 1;  ///< first session number; each new handshake counts up
  const uint16_t* sensors = nullptr;
  uint32_t sensor_count = 0;  ///< at most kMostSubscriptions
};

enum class ClientEvent : uint8_t {
  Nothing,     ///< no complete frame is there
  Handled,     ///< a frame was dealt with inside the client (hello, resubscription)
  Tick,        ///< tick() is new: the caller must call done()
  SilentLink,  ///< no frame for 12 s of the SBC's own clock (never in virtual time): a tick of the
               ///< clock alone
  Closed,      ///< the stream's other end is gone
};

class Client {
 public:
  explicit Client(const ClientOptions& options);

  /// Reads what is there and handles at most one frame; never blocks.
  ClientEvent poll(const GliderByteStream& stream, const GliderClock& clock);
  [[nodiscard]] const VehicleTick& tick() const { return tick_; }
  /// True when the vehicle said that its time is virtual: the SBC's clock then stands still between
  /// frames.
  [[nodiscard]] bool virtualTime() const { return virtual_time_; }

  /// Adds to the answer of this tick. `instruction`: session, sequence and check are filled in by
  /// the client (Take opens a new session); returns its sequence number.
  uint16_t instruct(Instruction instruction);
  void notify(const TransitionNotice& notice);
  /// Ends and sends the answer.
  void done(const MissionStatus& status, const GliderByteStream& stream);

 private:
  // The hooks engineer fills this in; plain arrays only.
  VehicleTick tick_;
  bool virtual_time_ = false;
};

}  // namespace glider::hooks
