// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/seat/simulated_seat.h"
#include "simulator/slocum/clock.h"
#include "simulator/slocum/flight/flight_controller.h"
#include "simulator/slocum/science/science_computer.h"

#include <memory>
#include <string>
#include <vector>

namespace glider::simulator {

/// The two computers of a Slocum and the line between them: the flight controller with its
/// mission file and hookbeh, the science computer with hookprog, to which the SBC is connected.
class SlocumSeat final : public SimulatedSeat {
 public:
  explicit SlocumSeat(const SeatSetup& setup);

  [[nodiscard]] double sbcBaud() const override;
  void startAt(const Vehicle& vehicle) override { flight_.startAt(vehicle.x(), vehicle.y()); }
  void begin(double now_s, SerialLine& sbc) override;
  bool isDown(double now_s) override;
  void put(const std::string& sensor, double value) override { flight_.put(sensor, value); }
  void cycle(double now_s, bool sbc_gone, Vehicle& vehicle) override;
  bool serve(double now_s, const Vehicle& vehicle, SerialLine& sbc) override;

  hooks::SeatEvent nextEvent() override { return science_.nextEvent(); }
  [[nodiscard]] hooks::SbcView sbc() const override { return science_.sbc(); }
  [[nodiscard]] bool sbcMaySleep() const override { return science_.sbcMaySleep(); }
  [[nodiscard]] bool inControl() const override { return flight_.hookActive(); }
  void noteTransition() override { flight_.noteTransition(); }

  [[nodiscard]] double reading(uint16_t id) const override;
  [[nodiscard]] double recorded(uint16_t id) const override { return science_.recorded(id); }
  [[nodiscard]] double clockAtStart() const override { return kStartOfMission; }
  [[nodiscard]] CycleView view(double now_s) const override;
  [[nodiscard]] const std::optional<News>& end() const override { return flight_.end(); }

  [[nodiscard]] std::span<const Column> firstColumns() const override;
  [[nodiscard]] std::span<const Column> secondColumns() const override;

  [[nodiscard]] const FlightController& flight() const { return flight_; }

 private:
  [[nodiscard]] const Faults& faults() const { return scenario_.faults; }
  [[nodiscard]] std::vector<SensorFault> faultsOf(bool science) const;
  void failDevices(double now_s, SerialLine& sbc);
  MakeProglet progletFor(const SeatSetup& setup);
  [[nodiscard]] double valueOf(const std::string& sensor) const;

  const platforms::Platform& platform_;
  const Scenario& scenario_;
  const World& world_;
  Journal& journal_;
  double now_s_ = 0;
  FlightController flight_;
  ScienceComputer science_;
  SensorDamage damage_;          ///< of the flight controller's sensors
  SensorDamage science_damage_;  ///< of those that the science computer reads
  FlightScienceLine line_;       ///< between the two
  bool science_down_ = false;
  const FlightRestart* flight_down_ = nullptr;
};

}  // namespace glider::simulator
