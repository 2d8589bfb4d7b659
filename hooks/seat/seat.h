// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame_reader.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/send_queue.h"
#include "hooks/protocol/sensor_list.h"
#include "hooks/protocol/values.h"
#include "hooks/seat/events.h"
#include "hooks/seat/reporter.h"
#include "hooks/seat/watches.h"
#include "hooks/transport/byte_stream.h"

#include <stdint.h>

namespace glider::hooks {

/// What a vehicle says of itself in each Tick; the fields are those of TickHead.
struct SeatState {
  double vehicle_time_s = 0;
  uint32_t cycle = 0;
  HookState hook_state = HookState::Absent;
  HookAnswer answer = HookAnswer::None;
  uint32_t answered_sequence = 0;
  uint32_t session = 0;  ///< in control, 0 for none
  uint32_t clock_s = 0;
};

/// What the seat asks of the vehicle around it.
struct SeatVehicle {
  void* self;
  /// The value of a sensor that was reported in this cycle; false if it was not.
  bool (*reading)(void* self, uint16_t id, double* value);
  /// The SBC's next instruction, a list of instruction sensors only.
  void (*write)(void* self, const SensorList& instruction);
  /// The SBC steers on: a number that differs from the last.
  void (*beat)(void* self, uint32_t heartbeat);
};

struct SeatOptions {
  bool virtual_time = false;  ///< the SBC must offer it
  uint16_t obeys = 0;         ///< features that are commands which this vehicle obeys
};

/// What the SBC has last said of its mission: valid when `known`.
struct SbcView {
  bool known = false;
  double mission_time_s = 0;
  uint32_t state = 0;
  uint8_t stack_depth = 0;
  MissionPhase phase = MissionPhase::Waiting;
};

/// The vehicle's end of the line to an SBC, to which it offers the seat of its pilot, for any
/// vehicle that speaks the hook protocol: link, subscription, Ticks, heartbeat, and what can be
/// seen to go wrong. Portable: no heap, no libc; every queue and loop is bounded. Once a second:
/// serve, watch, tick if a control cycle is complete, finish.
class Seat {
 public:
  /// `dictionary` outlives this, and has all required roles.
  explicit Seat(const GliderDictionary& dictionary, const SeatOptions& options = {});

  /// Takes what the SBC has sent until `now_s`, s by a clock that may be set back.
  void serve(double now_s, const SeatState& state, const SeatVehicle& vehicle,
             const GliderByteStream& sbc);
  /// Reports instructions that the vehicle does not answer, or refuses as old.
  void watch(const SeatState& state);
  /// A control cycle is complete: sends its Tick, or a Beacon while there is no link.
  void tick(const SeatState& state, const SeatVehicle& vehicle);
  /// A report of the vehicle repeats an earlier one: it is counted, not sent.
  void passOverStaleReport() { ++stale_; }
  /// Sends what the line takes and notices a lost SBC. `bad_frames`: discarded on the vehicle's own
  /// lines since it started.
  void finish(const GliderByteStream& sbc, uint32_t bad_frames);

  /// Takes the oldest event; Kind::None when there is none.
  SeatEvent nextEvent() { return events_.next(); }
  [[nodiscard]] SbcView sbc() const { return view_; }

  /// Seconds without an answer after which the SBC is lost.
  static constexpr double kLostSecs = 12;
  /// The same without an answer of the vehicle to an instruction: its own lines may need 8 s, and
  /// two control cycles pass.
  static constexpr double kUnansweredSecs = 24;

 private:
  void begin();
  void handle(const Frame& frame);
  template <typename Message>
  bool read(const Frame& frame, Message& message) {
    return decode(frame, message);
  }
  bool read(const Frame& frame, Subscribe& subscribe) {
    return decode(*dictionary_, frame, subscribe);
  }
  bool read(const Frame& frame, SensorList& list) { return decodeList(*dictionary_, frame, list); }
  /// False when the frame is none of those that an SBC with a link sends.
  bool handleOfLink(const Frame& frame);
  /// Decodes a Message and passes it on; false when it is not one.
  template <typename Message, void (Seat::*kHandler)(const Message&)>
  bool take(const Frame& frame);
  void handleHello(const Hello& hello);
  [[nodiscard]] Features features() const;
  void refuse(const Hello& hello, uint16_t missing);
  void handleSubscribe(const Subscribe& subscribe) { reporter_.serve(subscribe); }
  void handleWrite(const SensorList& list);
  void handleTransition(const TransitionNotice& notice);
  void handleNote(const MissionNote& note);
  void handleDone(const Done& done);
  bool isStale(double mission_time_s);
  void beat();
  bool noteProgress(const Done& done);
  void sendBeacon();
  void sendTick(const SeatVehicle& vehicle);
  [[nodiscard]] TickHead tickHead() const;
  void send(Frame& frame);
  void loseSbc();
  void countBadFrames(uint32_t of_vehicle);
  void event(SeatEvent::Kind kind, uint32_t a = 0, uint32_t b = 0, uint32_t c = 0);
  [[nodiscard]] uint16_t sensor(GliderRole role) const { return sensorOf(*dictionary_, role); }

  const GliderDictionary* dictionary_;
  SeatOptions options_;
  FrameReader reader_;
  SendQueue out_;
  uint8_t out_sequence_ = 0;
  double now_s_ = 0;
  bool started_ = false;
  SeatState state_;                       // the newest
  const SeatVehicle* vehicle_ = nullptr;  // while it is served

  uint32_t link_ = 0;     // 0: none
  bool waiting_ = false;  // for an answer
  Since waits_;
  Reporter reporter_;
  uint32_t newest_session_ = 0;
  double told_s_ = 0;      // newest mission time that the SBC has reported in this link
  uint32_t stale_ = 0;     // repeated frames and reports since the last finish
  uint32_t old_told_ = 0;  // the instruction that an event has reported as old, 0 for none
  uint32_t heartbeat_ = 0;
  ProgressWatch progress_;
  AnswerWatch answers_;
  uint8_t refused_version_ = 0;  // reported already
  uint32_t refused_dictionary_ = 0;
  uint16_t refused_features_ = 0;
  uint32_t malformed_ = 0;
  uint32_t bad_frames_told_ = 0;
  SbcView view_;
  EventQueue events_;
};

}  // namespace glider::hooks
