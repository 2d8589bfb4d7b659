// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/flight_science_link/flight_science_link.h"
#include "hooks/hookprog/cycle_watch.h"
#include "hooks/protocol/values.h"
#include "hooks/seat/seat.h"
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

/// The seat of the SBC on a Slocum: what the seat reads and writes is the flight controller's, over
/// the flight-science link.
class Hookprog {
 public:
  /// `dictionary` outlives this, and has all required roles.
  explicit Hookprog(const GliderDictionary& dictionary, const SeatOptions& options = {});
  /// One science cycle (1 s): takes the flight controller's updates, serves the SBC, forwards its
  /// writes.
  void run(double science_time_s, const ScienceSensors& own, const GliderByteStream& sbc,
           const GliderByteStream& flight);
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

 private:
  void takeFlight(const GliderByteStream& flight);
  void takeUpdate(const SensorUpdate& update);
  void watchHookbeh();
  void forwardPressure();
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
  FlightScienceLink flight_science_link_;
  Seat seat_;
  const ScienceSensors* own_ = nullptr;  // during run

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
};

}  // namespace glider::hooks
