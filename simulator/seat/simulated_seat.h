// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/seat/seat.h"
#include "simulator/flight_observer.h"
#include "simulator/journal.h"
#include "simulator/link/serial_line.h"
#include "simulator/scenario/scenario.h"
#include "simulator/seat/columns.h"
#include "simulator/vehicle/vehicle.h"
#include "simulator/world/world.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace glider::simulator {

/// What a seat is made from; all of it outlives the seat.
struct SeatSetup {
  const platforms::Platform& platform;
  const Scenario& scenario;
  const World& world;
  uint64_t seed;
  bool real_time;  ///< the SBC keeps its own time
  Journal& journal;
};

/// The computers of a vehicle, simulated: they read its sensors, steer it and serve the SBC, which
/// is given the seat of the pilot. Each family of vehicles has a class of them. The simulated
/// vehicle calls begin at each step of its model, then, when they are due, cycle and serve.
class SimulatedSeat {
 public:
  SimulatedSeat() = default;
  SimulatedSeat(const SimulatedSeat&) = delete;
  SimulatedSeat& operator=(const SimulatedSeat&) = delete;
  virtual ~SimulatedSeat() = default;

  /// The speed of the line to the SBC, bits/s.
  [[nodiscard]] virtual double sbcBaud() const { return 115200; }
  /// The vehicle starts at its place in the world.
  virtual void startAt(const Vehicle& vehicle) = 0;
  /// A step begins: faults of its computers and sensors act from now on.
  virtual void begin(double now_s, SerialLine& sbc) = 0;
  /// True while the computer that steers restarts; call it once when a control cycle is due.
  virtual bool isDown(double now_s) = 0;
  /// The operator, or another program on board, sets a sensor.
  virtual void put(const std::string& sensor, double value) = 0;
  /// A step of the model begins, of a vehicle that steers between its cycles too.
  virtual void steer(double /*now_s*/, Vehicle& /*vehicle*/) {}
  /// The control cycle at `now_s`; `sbc_gone`: the SBC will not come back.
  virtual void cycle(double now_s, bool sbc_gone, Vehicle& vehicle) = 0;
  /// Serves the SBC, which is at the right end of `sbc`: once a second. False if it cannot now.
  virtual bool serve(double now_s, const Vehicle& vehicle, SerialLine& sbc) = 0;

  /// What has happened on the link to the SBC, oldest first; Kind::None after the last.
  virtual hooks::SeatEvent nextEvent() = 0;
  /// What the SBC has last said of its mission.
  [[nodiscard]] virtual hooks::SbcView sbc() const = 0;
  /// The vehicle does not expect the SBC to read its line now.
  [[nodiscard]] virtual bool sbcMaySleep() const { return false; }
  /// The SBC controls the vehicle.
  [[nodiscard]] virtual bool inControl() const = 0;
  /// The SBC's mission has changed state.
  virtual void noteTransition() = 0;

  /// The newest reading of a sensor by its number; NaN before the first.
  [[nodiscard]] virtual double reading(uint16_t id) const = 0;
  /// The same for the trace: NaN while the instrument is off.
  [[nodiscard]] virtual double recorded(uint16_t id) const = 0;
  /// Its clock when the flight begins, s since 1970.
  [[nodiscard]] virtual double clockAtStart() const { return 0; }
  /// What it knows of the cycle that has just been run; the rest is the vehicle's and the world's.
  [[nodiscard]] virtual CycleView view(double now_s) const = 0;
  /// How the vehicle's mission ended; none while it is not over.
  [[nodiscard]] virtual const std::optional<News>& end() const = 0;

  /// The columns of its traces, in order: those before and after the columns of the instruments
  /// that every vehicle has. The first three are time, missiontime and state.
  [[nodiscard]] virtual std::span<const Column> firstColumns() const = 0;
  [[nodiscard]] virtual std::span<const Column> secondColumns() const = 0;
};

}  // namespace glider::simulator
