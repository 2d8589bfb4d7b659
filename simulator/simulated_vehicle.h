// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/acoustics/channel.h"
#include "simulator/acoustics/simulated_modem.h"
#include "simulator/bottom_contact.h"
#include "simulator/link/sbc_link.h"
#include "simulator/link/serial_line.h"
#include "simulator/mission_story.h"
#include "simulator/recorder.h"
#include "simulator/seat/cycle_times.h"
#include "simulator/seat/simulated_seat.h"
#include "simulator/simulator.h"
#include "simulator/vehicle/true_place.h"
#include "simulator/world/world.h"
#include "support/trace/row_spool.h"

#include <cstdint>
#include <memory>

namespace glider::simulator {

/// A vehicle in a world: its body, its computers, the serial line and the SBC at its end.
class SimulatedVehicle {
 public:
  /// It starts where `setup.scenario` does, when the world begins; the water of that scenario is
  /// not used. `world` outlives it. `number` counts the vehicles of a world from 0: each has random
  /// numbers of its own. Its modem, if it is in use, talks through `channel`; null: it has none.
  /// Fails as simulate does.
  static support::Result<std::unique_ptr<SimulatedVehicle>> make(
      SimulationSetup setup, const World& world, uint32_t number,
      std::shared_ptr<Channel> channel = nullptr);
  SimulatedVehicle(const SimulatedVehicle&) = delete;  // its parts refer to each other
  SimulatedVehicle& operator=(const SimulatedVehicle&) = delete;

  /// False once its mission has ended, it is at the surface after an abort, or its time is over.
  [[nodiscard]] bool flying() const { return !over_ && step_ <= most_steps_; }
  /// Tells the channel where it is: all vehicles of a world do, before any of them advances.
  void placeModem();
  /// Flies until `time_s` of the world.
  void advance(double time_s);
  /// Where it truly is.
  [[nodiscard]] TruePlace place() const { return {vehicle_.x(), vehicle_.y(), vehicle_.depth()}; }
  /// The trace of its flight; ends it.
  support::Trace finish();

 private:
  SimulatedVehicle(SimulationSetup setup, const World& world, uint32_t number,
                   std::shared_ptr<Channel> channel);

  [[nodiscard]] const Faults& faults() const { return setup_.scenario.faults; }
  [[nodiscard]] LineDamage damageOf(LineWay way, double baud) const {
    return {faults().lines, way, seed_, baud};
  }
  void step(double now);
  bool controlCycle(double now);
  [[nodiscard]] CycleView view(double now, bool over) const;
  void putSensors(double before_s, double now);
  void serveSbc(double now);
  void serveModem(double now);
  void completeRow();
  [[nodiscard]] std::vector<support::Consumer> consumers() const;

  SimulationSetup setup_;
  const World& world_;
  bool real_time_;  ///< the SBC has its own clock, and its time-outs run
  uint64_t seed_;
  double duration_s_;
  CycleTimes cycles_;
  int64_t next_cycle_ = 0;  ///< the step in which it begins
  int64_t cycle_count_ = 0;
  double scheduled_s_ = -1;  ///< when the previous cycle was due, whether or not it ran
  int64_t most_steps_;
  int64_t step_ = 0;
  bool over_ = false;
  support::Trace trace_;
  support::RowSpool spool_;
  Journal journal_;
  Vehicle vehicle_;
  std::unique_ptr<SimulatedSeat> seat_;
  SerialLine sbc_line_;
  SbcLink link_;
  uint32_t number_;
  std::shared_ptr<Channel> channel_;
  std::unique_ptr<SimulatedModem> modem_;  ///< null: none is in use
  MissionStory story_;
  Recorder recorder_;
  BottomContact bottom_;
  double cycle_s_ = 0;
  double start_J_ = 0;
};

}  // namespace glider::simulator
