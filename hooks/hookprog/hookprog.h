// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/flight_science_link/flight_science_link.h"
#include "hooks/hookprog/events.h"
#include "hooks/hookprog/reporter.h"
#include "hooks/hookprog/watches.h"
#include "hooks/protocol/frame_reader.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/send_queue.h"
#include "hooks/protocol/values.h"
#include "hooks/transport/byte_stream.h"

#include <stdint.h>

/// The proglet `hookprog` on the science computer: proxy of the SBC (115200 baud) for the flight
/// controller's data memory (9600 baud). Portable: no heap, no libc. It forwards nothing to the
/// flight controller until the flight controller reports a hookbeh.
namespace glider::hooks {

/// The science computer's own sensors, as hookprog sees them.
struct ScienceSensors {
  void* self;
  /// The newest value of sensor `id`; NaN if never set. Sets `fresh` if it was updated since the
  /// last call for this sensor.
  double (*get)(void* self, uint16_t id, bool* fresh);
};

struct HookprogOptions {
  bool virtual_time = false;  ///< the SBC must offer it
};

class Hookprog {
 public:
  /// `dictionary` outlives this, and has all required roles.
  explicit Hookprog(const GliderDictionary& dictionary, const HookprogOptions& options = {});
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
    MissionPhase phase = MissionPhase::Waiting;
  };
  [[nodiscard]] SbcView sbc() const { return view_; }

  /// Science seconds without an answer after which the SBC is lost.
  static constexpr double kLostSecs = 12;
  /// Complete flight cycles in a row without x_hook_state after which the vehicle's mission has no
  /// hookbeh: hookbeh reports in each cycle, but lines lose frames.
  static constexpr uint32_t kMostCyclesWithoutHookbeh = 6;
  /// The same after mission time and cycle number have gone back, as they do when another mission
  /// starts.
  static constexpr uint32_t kMostCyclesOfAnotherMission = 2;

 private:
  void begin();
  void takeFlight(const GliderByteStream& flight);
  void takeUpdate(const SensorUpdate& update);
  void serveSbc(const GliderByteStream& sbc);
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
  template <typename Message, void (Hookprog::*kHandler)(const Message&)>
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
  void watchInstruction();
  void watchHookbeh();
  void sendCycle(const ScienceSensors& own);
  void forwardPressure(const ScienceSensors& own);
  void sendBeacon();
  void sendTick(const ScienceSensors& own);
  bool readingFor(uint16_t id, const ScienceSensors& own, double* value);
  [[nodiscard]] TickHead tickHead() const;
  void send(Frame& frame);
  void loseSbc();
  void countBadFrames();
  void event(HookprogEvent::Kind kind, uint32_t a = 0, uint32_t b = 0, uint32_t c = 0);
  [[nodiscard]] uint16_t sensor(GliderRole role) const { return sensorOf(*dictionary_, role); }
  /// Of a required role.
  [[nodiscard]] double newest(GliderRole role) const { return values_[sensor(role)]; }
  /// 0 when unknown, negative or too large.
  [[nodiscard]] uint32_t newestWhole(GliderRole role) const;
  [[nodiscard]] HookState hookState() const;
  [[nodiscard]] double missionTime() const;

  const GliderDictionary* dictionary_;
  HookprogOptions options_;
  FlightScienceLink flight_science_link_;
  FrameReader reader_;
  SendQueue out_;
  uint8_t out_sequence_ = 0;
  double now_s_ = 0;
  bool started_ = false;

  // The flight controller's data memory, as far as it has been reported.
  double values_[GLIDER_MOST_SENSORS];
  bool fresh_[GLIDER_MOST_SENSORS] = {};
  bool time_is_new_ = false;
  bool cycle_is_new_ = false;
  CycleWatch cycles_;
  double cycle_time_s_ = 0;    // mission time of the newest complete cycle
  uint32_t cycle_number_ = 0;  // its number
  double pressure_ = 0;        // of the CTD, in this cycle
  bool pressure_is_new_ = false;
  uint32_t cycles_without_hookbeh_ = 0;
  uint32_t most_without_hookbeh_ = kMostCyclesWithoutHookbeh;

  uint32_t link_ = 0;     // 0: none
  bool waiting_ = false;  // for an answer
  Since waits_;
  Reporter reporter_;
  uint32_t newest_session_ = 0;
  double told_s_ = 0;      // newest mission time that the SBC has reported in this link
  uint32_t stale_ = 0;     // repeated frames and reports in this science cycle
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
