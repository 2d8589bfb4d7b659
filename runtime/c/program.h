// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/abi/runtime.h"
#include "runtime/c/water_column.h"
#include "runtime/core/control.h"
#include "runtime/core/mission_clock.h"
#include "runtime/log/mission_log.h"

/// The one mission of a C program: what GliderRuntime is for a compiled one, but the program's own
/// code runs between a tick and its answer.
namespace glider::runtime {

struct Link {
  GliderByteStream stream{};
  GliderClock clock{};
  int (*wait)(void) = nullptr;
  const char* mission_name = "";
  GliderLogSink log{};
};

/// The depths and pitches of dive() and climb().
struct Limits {
  double shallowest = 3;
  double deepest = 30;
  double dive = 0.454;
  double climb = 0.454;
};

class Program {
 public:
  static Program& instance();

  void attach(const Link& link) { link_ = link; }
  /// True when the vehicle said that its time is virtual: it waits for every answer.
  [[nodiscard]] bool virtualTime() const { return client_ != nullptr && client_->virtualTime(); }
  /// False if the sensor is no sensor, or not subscribed and it is too late for that.
  bool use(uint32_t sensor);
  /// Answers the tick under way and waits for the next in which the mission runs; false when it is
  /// over.
  bool nextTick();

  /// The commands in force; may be changed at any time.
  GliderContext& context() { return *context_; }
  Limits& limits() { return limits_; }
  void giveBack() { finished_ = true; }
  [[nodiscard]] bool released() const { return control_.released(); }
  /// A dive or climb begins.
  void beginLeg();
  [[nodiscard]] const WaterColumn& column() const { return column_; }
  [[nodiscard]] double legBegan() const { return leg_began_; }

 private:
  Program();
  void open();
  void answer();
  bool takeTick();
  void start(double vehicle_time, double sbc_time);
  void record();

  static constexpr uint32_t kMost = hooks::kMostSubscriptions;
  struct Memory {
    GliderContext context;
    GliderReading readings[kMost];
    GliderNote notes[GLIDER_MOST_NOTES];
    double note_values[GLIDER_MOST_NOTE_VALUES];
    double
        gaps[3];  ///< the layout aligns what some boards would not (runtime/abi/context_layout.h)
  };

  Link link_;
  Limits limits_;
  GliderStateInfo state_{};
  const GliderStateInfo* const states_[1] = {&state_};
  GliderMission mission_{};
  GliderSensorInfo sensors_[kMost] = {};
  hooks::Subscription subscription_[kMost] = {};
  GliderUpdate updates_[kMost] = {};
  Memory memory_{};
  GliderContext* context_ = &memory_.context;
  alignas(hooks::Client) uint8_t client_memory_[sizeof(hooks::Client)] = {};
  hooks::Client* client_ = nullptr;  ///< made when the sensors are known: at the first tick
  Control control_;
  MissionClock clock_;
  alignas(MissionLog) uint8_t log_memory_[sizeof(MissionLog)] = {};
  MissionLog* log_ = nullptr;
  WaterColumn column_;
  double leg_began_ = 0;
  bool started_ = false;
  bool finished_ = false;
  bool must_answer_ = false;
};

}  // namespace glider::runtime
