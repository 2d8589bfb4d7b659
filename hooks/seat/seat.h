// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_SEAT_SEAT_H
#define GLIDER_HOOKS_SEAT_SEAT_H

#include "hooks/protocol/frame_reader.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/send_queue.h"
#include "hooks/protocol/sensor_list.h"
#include "hooks/protocol/values.h"
#include "hooks/seat/events.h"
#include "hooks/seat/nap.h"
#include "hooks/seat/reporter.h"
#include "hooks/seat/watches.h"
#include "hooks/transport/byte_stream.h"

GLIDER_HOOKS_BEGIN

/// What a vehicle says of itself in each Tick; the fields but the last are those of HookTickHead.
typedef struct HookSeatState {
  double vehicle_time_s GLIDER_IS(0);
  uint32_t cycle GLIDER_IS(0);
  HookState hook_state GLIDER_IS(HookState::Absent);
  HookAnswer answer GLIDER_IS(HookAnswer::None);
  uint32_t answered_sequence GLIDER_IS(0);
  uint32_t session GLIDER_IS(0);  ///< in control, 0 for none
  uint32_t clock_s GLIDER_IS(0);
  /// The longest nap that the SBC may take, with its time to wake, s; 0 or NaN: none.
  double nap_secs GLIDER_IS(0);
} HookSeatState;

/// What the seat asks of the vehicle around it.
typedef struct HookSeatVehicle {
  void* self;
  /// The value of a sensor that was reported in this cycle; false if it was not.
  bool (*reading)(void* self, uint16_t id, double* value);
  /// The SBC's next instruction, a list of instruction sensors only.
  void (*write)(void* self, const HookSensorList* instruction);
  /// The SBC steers on: a number that differs from the last. `asleep`: it sleeps, and the seat
  /// gives the number in its place, once in each control cycle.
  void (*beat)(void* self, uint32_t heartbeat, bool asleep);
} HookSeatVehicle;

typedef struct HookSeatOptions {
  bool virtual_time GLIDER_IS(false);  ///< the SBC must offer it
  /// Features that this vehicle offers: commands that it obeys, and naps of the SBC.
  uint16_t obeys GLIDER_IS(0);
} HookSeatOptions;

/// What the SBC has last said of its mission: valid when `known`.
typedef struct HookSbcView {
  bool known GLIDER_IS(false);
  double mission_time_s GLIDER_IS(0);
  uint32_t state GLIDER_IS(0);
  uint8_t stack_depth GLIDER_IS(0);
  HookMissionPhase phase GLIDER_IS(HookMissionPhase::Waiting);
} HookSbcView;

enum {
  /// Seconds without an answer after which the SBC is lost.
  kHookSeatLostSecs = 12,
  /// The same without an answer of the vehicle to an instruction: its own lines may need 8 s, and
  /// two control cycles pass.
  kHookSeatUnansweredSecs = 24
};

/// The vehicle's end of the line to an SBC, to which it offers the seat of its pilot, for any
/// vehicle that speaks the hook protocol: link, subscription, Ticks, heartbeat, and what can be
/// seen to go wrong. Portable: no heap, no libc; every queue and loop is bounded. Once a second:
/// hookSeatServe, -Watch, -Tick if a control cycle is complete, -Finish.
typedef struct HookSeat {
  const GliderDictionary* dictionary;
  HookSeatOptions options;
  HookFrameReader reader;
  HookSendQueue out;
  uint8_t out_sequence;
  double now_s;
  bool started;
  HookSeatState state;             ///< the newest
  const HookSeatVehicle* vehicle;  ///< while it is served

  uint32_t link;  ///< 0: none
  bool waiting;   ///< for an answer
  HookSince waits;
  HookReporter reporter;
  uint32_t newest_session;
  double told_s;      ///< newest mission time that the SBC has reported in this link
  uint32_t stale;     ///< repeated frames and reports since the last finish
  uint32_t old_told;  ///< the instruction that an event has reported as old, 0 for none
  uint32_t heartbeat;
  HookProgressWatch progress;
  HookAnswerWatch answers;
  uint8_t refused_version;  ///< reported already
  uint32_t refused_dictionary;
  uint16_t refused_features;
  uint32_t malformed;
  uint32_t bad_frames_told;
  HookSbcView view;  ///< what the SBC has last said of its mission
  HookNaps naps;
  HookEventQueue events;
} HookSeat;

/// `dictionary` outlives it, and has all required roles.
void hookSeatInit(HookSeat* seat, const GliderDictionary* dictionary,
                  const HookSeatOptions* options);

/// Takes what the SBC has sent until `now_s`, s by a clock that may be set back.
void hookSeatServe(HookSeat* seat, double now_s, const HookSeatState* state,
                   const HookSeatVehicle* vehicle, const GliderByteStream* sbc);
/// Reports instructions that the vehicle does not answer, or refuses as old.
void hookSeatWatch(HookSeat* seat, const HookSeatState* state);
/// A control cycle is complete: sends its Tick, or a Beacon while there is no link. While the SBC
/// sleeps, the Tick is kept.
void hookSeatTick(HookSeat* seat, const HookSeatState* state, const HookSeatVehicle* vehicle);
/// A report of the vehicle repeats an earlier one: it is counted, not sent.
void hookSeatPassOverStaleReport(HookSeat* seat);
/// Sends what the line takes and notices a lost SBC. `bad_frames`: discarded on the vehicle's own
/// lines since it started.
void hookSeatFinish(HookSeat* seat, const GliderByteStream* sbc, uint32_t bad_frames);

/// False while the SBC sleeps: it may be without power until this is true again. It then has as
/// many seconds as it has asked for until its line is used.
bool hookSeatWantsSbc(const HookSeat* seat);

/// Takes the oldest event. False, and an event without a kind, when there is none.
bool hookSeatNextEvent(HookSeat* seat, HookSeatEvent* event);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using SeatState = HookSeatState;
using SeatVehicle = HookSeatVehicle;
using SeatOptions = HookSeatOptions;
using SbcView = HookSbcView;

/// HookSeat.
class Seat {
 public:
  explicit Seat(const GliderDictionary& dictionary, const SeatOptions& options = {}) {
    hookSeatInit(&seat_, &dictionary, &options);
  }
  void serve(double now_s, const SeatState& state, const SeatVehicle& vehicle,
             const GliderByteStream& sbc) {
    hookSeatServe(&seat_, now_s, &state, &vehicle, &sbc);
  }
  void watch(const SeatState& state) { hookSeatWatch(&seat_, &state); }
  void tick(const SeatState& state, const SeatVehicle& vehicle) {
    hookSeatTick(&seat_, &state, &vehicle);
  }
  void finish(const GliderByteStream& sbc, uint32_t bad_frames) {
    hookSeatFinish(&seat_, &sbc, bad_frames);
  }
  SeatEvent nextEvent() {
    SeatEvent event;
    (void)hookSeatNextEvent(&seat_, &event);
    return event;
  }
  [[nodiscard]] const SbcView& sbc() const { return seat_.view; }
  [[nodiscard]] bool wantsSbc() const { return hookSeatWantsSbc(&seat_); }

 private:
  HookSeat seat_;
};

}  // namespace glider::hooks
#endif

#endif
