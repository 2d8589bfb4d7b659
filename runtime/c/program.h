// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/abi/runtime.h"
#include "runtime/c/kept_state.h"
#include "runtime/c/water_column.h"
#include "runtime/core/assert.h"
#include "runtime/core/control.h"
#include "runtime/core/link_log.h"
#include "runtime/core/mission_clock.h"
#include "runtime/core/persistence.h"
#include "runtime/log/mission_log.h"

/// The one mission of a C program: what GliderRuntime is for a compiled one, but the program's own
/// code runs between a tick and its answer.
namespace glider::runtime {

struct Link {
  GliderByteStream stream{};
  GliderClock clock{};
  int (*wait)(void) = nullptr;
  const char* mission_name = "";  ///< not null
  GliderLogSink log{};
  GliderStore checkpoints{};
  uint32_t program = 0;  ///< as in GliderRuntimeOptions
};

/// The depths and pitches of dive() and climb().
struct Limits {
  double shallowest = 3;
  double deepest = 30;
  double dive = 0.454;
  double climb = 0.454;
};

class Program {
  static constexpr uint32_t kMost = hooks::kMostSubscriptions;
  /// The water, from the newest readings.
  struct Water {
    double leg_began = 0;
    WaterColumn column{};
  };

 public:
  /// The greatest size of its context, and so of a checkpoint. Arrays begin at multiples of 8
  /// (runtime/abi/context_layout.h), so each needs at most 7 bytes of padding.
  static constexpr uint32_t kMostContextBytes =
      sizeof(GliderContext) + kMost * sizeof(GliderReading) + sizeof(Limits) +
      KeptState::kMostBytes + sizeof(Water) + GLIDER_MOST_NOTES * sizeof(GliderNote) +
      GLIDER_MOST_NOTE_VALUES * sizeof(double) + 10 * 7;

  static Program& instance();

  /// The part of the C program's own state that its checkpoints keep; fixed before attach().
  KeptState& kept() { return kept_; }
  /// The longest outage after which the mission continues, s.
  void resumeWithin(double seconds) { mission_.resume_within = seconds; }
  /// The mission does not continue if the vehicle has restarted its own mission meanwhile.
  void newAfterRestart() { mission_.new_after_restart = 1; }
  /// The declination used for headings while the vehicle has not reported a variation: rad, east
  /// positive.
  void declination(double east) { compass_.declination = east; }
  void attach(const Link& link) { link_ = link; }
  [[nodiscard]] bool isAttached() const { return link_.wait != nullptr; }
  /// True when the vehicle reported that its time is virtual: it waits for every answer.
  [[nodiscard]] bool virtualTime() const { return client_ != nullptr && client_->virtualTime(); }
  /// False if the sensor does not exist, or is not subscribed and it is too late to do so.
  bool use(uint32_t sensor);
  /// Answers the current tick and waits for the next in which the mission runs; false when it is
  /// over.
  bool nextTick();
  /// True once: the tick that nextTick() took is the first after a power cut. The program's own
  /// state is what the checkpoint kept; it may choose again what it waits for, and the next
  /// nextTick() gives this tick again.
  bool takeResume();
  /// True if the mission continues from a checkpoint.
  [[nodiscard]] bool resumed() const { return resumed_; }

  /// The commands in force; may be changed at any time.
  GliderContext& context() { return *context_; }
  Limits& limits() { return limits_; }
  void releaseControl() { finished_ = true; }
  /// Sends a note to the logs of SBC and vehicle; dropped before the mission has begun.
  void note(const char* text, const double* values, uint32_t count);
  [[nodiscard]] bool released() const { return control_.released(); }
  /// True if `holds`; else the check is noted, and the mission is over.
  bool require(bool holds, Check check);
  /// The number of the first check of the program's memory that failed; 0: none.
  [[nodiscard]] uint32_t failedCheck() const { return firstFailedCheck(*context_); }
  /// A dive or climb begins.
  void beginLeg();
  [[nodiscard]] const WaterColumn& column() const { return water_.column; }
  [[nodiscard]] double legBegan() const { return water_.leg_began; }

 private:
  Program();
  void open();
  void answer();
  bool takeTick();
  bool tickOfClockAlone();
  void tryToGoOn(const hooks::VehicleTick& tick, double sbc_time);
  void start(double vehicle_time, double sbc_time, uint32_t updates);
  void record();
  void tellNow();
  bool isBroken();
  void save();
  void restore();

  Link link_;
  Limits limits_;
  GliderStateInfo state_{};
  const GliderStateInfo* const states_[1] = {&state_};
  GliderMission mission_{};
  GliderCompass compass_;
  double variation_;  ///< that the vehicle reported; NaN: none yet
  GliderSensorInfo sensors_[kMost] = {};
  hooks::Subscription subscription_[kMost] = {};
  GliderUpdate updates_[kMost] = {};
  KeptState kept_;
  alignas(double) uint8_t memory_[kMostContextBytes] = {};
  const GliderMission nothing_{};  ///< what is subscribed before the first tick
  GliderContext wanted_{};         ///< the commands before the mission began
  GliderContext* context_ = &wanted_;
  alignas(hooks::Client) uint8_t client_memory_[sizeof(hooks::Client)] = {};
  hooks::Client* client_ = nullptr;  ///< made when the sensors are known: at the first tick
  Control control_;
  MissionClock clock_;
  alignas(MissionLog) uint8_t log_memory_[sizeof(MissionLog)] = {};
  MissionLog* log_ = nullptr;
  alignas(LinkLog) uint8_t link_log_memory_[sizeof(LinkLog)] = {};
  LinkLog* link_log_ = nullptr;
  alignas(Persistence) uint8_t persistence_memory_[sizeof(Persistence)] = {};
  Persistence* persistence_ = nullptr;
  Water water_;
  bool started_ = false;
  bool finished_ = false;
  bool ticked_ = false;  ///< the program has processed a tick that is not yet committed
  bool must_answer_ = false;
  bool resumed_ = false;
  bool just_resumed_ = false;
  bool look_again_ = false;  ///< at the tick of the resume
  bool silent_ = false;      ///< a check failed: no frame is answered any more
};

}  // namespace glider::runtime
