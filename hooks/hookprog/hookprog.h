// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookprog/cycle_watch.h"
#include "hooks/protocol/values.h"
#include "hooks/seat/seat.h"
#include "hooks/transport/byte_stream.h"

#include <stdint.h>

/// The proglet `hookprog` on the science computer: proxy of the SBC (115200 baud) for the vehicle's
/// sensors. Portable: no heap, no libc. It writes nothing until the flight controller reports a
/// hookbeh.
namespace glider::hooks {

/// The data memory of the science computer: its own sensors, and those of the flight controller as
/// far as they have come over the vehicle's own line.
struct ScienceMemory {
  void* self;
  /// The newest value of sensor `id`; NaN if never set. Sets `fresh` if it was updated since the
  /// last call for this sensor.
  double (*get)(void* self, uint16_t id, bool* fresh);
  /// Sets a sensor of the science computer, which the vehicle takes to the flight controller: with
  /// six decimals, in its own time, and in any order.
  void (*set)(void* self, uint16_t id, double value);
};

/// The seat of the SBC on a Slocum: it reads and writes sensors of the science computer's memory.
class Hookprog {
 public:
  /// `dictionary` outlives this, and has all required roles.
  explicit Hookprog(const GliderDictionary& dictionary, const SeatOptions& options = {});
  /// One science cycle (1 s): takes the flight controller's updates, serves the SBC, writes what it
  /// instructs.
  void run(double science_time_s, const ScienceMemory& memory, const GliderByteStream& sbc);
  /// Takes the oldest event; Kind::None when there is none.
  SeatEvent nextEvent();
  /// The mission's last heartbeat, for the trace.
  [[nodiscard]] SbcView sbc() const { return seat_.sbc(); }

  /// Complete flight cycles in a row without x_hook_state after which the vehicle's mission has no
  /// hookbeh: hookbeh reports in each cycle, but lines lose frames.
  static constexpr uint32_t kMostCyclesWithoutHookbeh = 6;
  /// The same after mission time and cycle number have gone back, as they do when another mission
  /// starts.
  static constexpr uint32_t kMostCyclesOfAnotherMission = 2;
  /// s. The sensors of a flight cycle arrive in any order: a cycle is complete when its time and
  /// number are there and nothing of it has come for the first time; when something comes all the
  /// time, after the second.
  static constexpr double kSettledSecs = 1, kMostUnsettledSecs = 3;

 private:
  bool takeFlight();
  void takeAnswer();
  void takeUpdate(uint16_t id, double value);
  [[nodiscard]] bool cycleIsComplete(bool something_came, double now_s);
  void watchHookbeh();
  void forward(const SensorList& instruction);
  /// What the seat asks for: SeatVehicle.
  static bool reading(void* self, uint16_t id, double* value);
  static void write(void* self, const SensorList& instruction);
  static void beat(void* self, uint32_t heartbeat);
  [[nodiscard]] SeatState state() const;
  [[nodiscard]] uint16_t sensor(GliderRole role) const { return sensorOf(*dictionary_, role); }
  /// Of a required role.
  [[nodiscard]] double newest(GliderRole role) const { return values_[sensor(role)]; }
  /// 0 when unknown, negative or too large.
  [[nodiscard]] uint32_t newestWhole(GliderRole role) const;
  [[nodiscard]] HookState hookState() const;
  [[nodiscard]] double missionTime() const;

  const GliderDictionary* dictionary_;
  Seat seat_;
  const ScienceMemory* memory_ = nullptr;  // during run

  // The flight controller's data memory, as far as it has been reported.
  double values_[GLIDER_MOST_SENSORS];
  bool fresh_[GLIDER_MOST_SENSORS] = {};
  bool time_is_new_ = false;
  bool cycle_is_new_ = false;
  Since settled_;       // since something of the flight controller has come
  Since unsettled_;     // since time and number of a cycle are there
  bool waits_ = false;  // for the rest of that cycle
  CycleWatch cycles_;
  double cycle_time_s_ = 0;    // mission time of the newest complete cycle
  uint32_t cycle_number_ = 0;  // its number
  // hookbeh's newest answer: number and answer came in the same cycle.
  uint32_t answered_sequence_ = 0;
  HookAnswer answer_ = HookAnswer::None;
  uint32_t cycles_without_hookbeh_ = 0;
  uint32_t most_without_hookbeh_ = kMostCyclesWithoutHookbeh;
};

}  // namespace glider::hooks
