// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/abi/runtime.h"
#include "runtime/core/after_tick.h"
#include "runtime/core/assert.h"
#include "runtime/core/control.h"
#include "runtime/core/link_log.h"
#include "runtime/core/mission_clock.h"
#include "runtime/core/nap_tick.h"
#include "runtime/core/persistence.h"
#include "runtime/core/start_depth.h"
#include "runtime/log/mission_log.h"

/// Joins the link to the mission: every tick of the vehicle is a step of the mission, its commands,
/// and an answer.
struct GliderRuntime {
 public:
  /// `mission` must be acceptable(). `context_memory` holds its context_bytes.
  GliderRuntime(void* context_memory, const GliderMission& mission,
                const GliderRuntimeOptions& options);
  GliderRuntime(const GliderRuntime&) = delete;
  GliderRuntime& operator=(const GliderRuntime&) = delete;

  /// True if this runtime can fly the mission.
  static bool acceptable(const GliderMission& mission);

  GliderRuntimeStatus poll(const GliderByteStream& stream, const GliderClock& clock);
  [[nodiscard]] const GliderContext* context() const { return context_; }
  /// The link as the checkpoint has it that it has found; null: none, or it is decided already
  /// whether to continue from it.
  [[nodiscard]] const glider::runtime::LinkFacts* checkpoint() const {
    return persistence_.undecided();
  }
  /// True when the vehicle reported that its time is virtual: it waits for every answer.
  [[nodiscard]] bool virtualTime() const { return client_.virtualTime(); }
  /// `clock`, s. In virtual time it says nothing about the flight: then the vehicle's clock.
  [[nodiscard]] double ownTime(const GliderClock& clock) const;
  /// The client's frames come from within the program: `damaged` counts what arrives damaged. It
  /// outlives this.
  void countDamageBy(const uint32_t* damaged) { damaged_ = damaged; }
  /// True once after an answer after which the SBC may sleep until the vehicle wakes it.
  bool fallsAsleep() {
    const bool asleep = naps_.asleep && !client_.virtualTime();
    naps_.asleep = false;
    return asleep;
  }
  void afterTick(const glider::runtime::AfterTick& after_tick) { after_tick_ = after_tick; }
  /// The number of the first check of its own memory that failed (log/checks.def); 0: none.
  [[nodiscard]] uint32_t failedCheck() const { return glider::runtime::firstFailedCheck(memory()); }

 private:
  static glider::hooks::ClientOptions subscribe(const GliderMission& mission,
                                                glider::hooks::Subscription* sensors);
  /// Of a running mission or, before it has begun, of one to come.
  [[nodiscard]] GliderContext& memory() const {
    return *static_cast<GliderContext*>(context_memory_);
  }
  bool isBroken();
  [[nodiscard]] bool hasFailed() const { return memory().failed_checks != 0; }
  double missionTimeAt(const glider::hooks::VehicleTick& tick, double sbc_time);
  bool mayBegin(const glider::hooks::VehicleTick& tick);
  void tryToGoOn(const glider::hooks::VehicleTick& tick, double sbc_time);
  void answerTick(const GliderByteStream& stream, double sbc_time);
  void tickOfClockAlone(double sbc_time);
  void startMission(uint32_t update_count);
  void stepMission(double mission_time, uint32_t update_count);
  void tellTransition(uint32_t from, const glider::runtime::StateTimes& times);
  bool command();
  uint32_t gatherUpdates();
  uint32_t convertHeadings(GliderUpdate* updates, uint32_t count);
  void endStep();
  [[nodiscard]] bool finished() const { return context_ != nullptr && context_->finished != 0; }
  [[nodiscard]] glider::hooks::MissionStatus status() const;

  void* context_memory_;
  const GliderMission& mission_;
  const double* parameters_;          ///< null: the defaults
  GliderContext* context_ = nullptr;  ///< once the mission got control
  bool silent_ = false;               ///< a check failed: no frame is answered any more
  glider::hooks::Subscription sensors_[glider::hooks::kMostSubscriptions] = {};
  glider::hooks::Client client_;
  glider::runtime::Control control_;
  glider::runtime::MissionClock clock_;
  glider::runtime::MissionLog log_;
  glider::runtime::LinkLog link_log_;
  const uint32_t* damaged_ = nullptr;  ///< null: the client counts
  glider::runtime::AfterTick after_tick_;
  GliderUpdate updates_[glider::hooks::kMostSubscriptions] = {};
  double variation_;  ///< in a mission with a compass: the last that the vehicle reported, else NaN
  glider::runtime::StartDepth start_depth_;
  glider::runtime::NapMemory naps_;
  glider::runtime::Persistence persistence_;
};
