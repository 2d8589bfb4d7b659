// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/line_reader.h"
#include "hooks/recon/messages.h"
#include "simulator/remus100/autopilot.h"
#include "simulator/remus100/override.h"
#include "simulator/seat/dead_reckoning.h"
#include "simulator/seat/sbc_story.h"
#include "simulator/seat/sensor_array.h"
#include "simulator/seat/simulated_seat.h"
#include "simulator/sensors/sensor_list.h"

#include <optional>
#include <string>
#include <string_view>

namespace glider::simulator {

/// The computer of a REMUS 100: it lets an SBC, which speaks RECON with it, override its own
/// mission. That has nothing left to do: without the override the propeller stops, and the vehicle
/// floats up.
class RemusSeat final : public SimulatedSeat {
 public:
  explicit RemusSeat(const SeatSetup& setup);

  [[nodiscard]] double sbcBaud() const override { return kLineBaud; }
  void startAt(const Vehicle& vehicle) override { reckoning_.startAt({vehicle.x(), vehicle.y()}); }
  void begin(double now_s, SerialLine& sbc) override;
  bool isDown(double now_s) override;
  void put(const std::string& sensor, double value) override;
  void steer(double now_s, Vehicle& vehicle) override;
  void cycle(double now_s, bool sbc_gone, Vehicle& vehicle) override;
  bool serve(double now_s, const Vehicle& vehicle, SerialLine& sbc) override;

  hooks::SeatEvent nextEvent() override { return story_.nextEvent(); }
  [[nodiscard]] hooks::SbcView sbc() const override { return story_.view(); }
  [[nodiscard]] bool inControl() const override { return override_.isOn(); }
  void noteTransition() override {}

  [[nodiscard]] double reading(uint16_t id) const override { return array_.get(id); }
  [[nodiscard]] double recorded(uint16_t id) const override { return array_.get(id); }
  [[nodiscard]] double clockAtStart() const override;
  [[nodiscard]] CycleView view(double now_s) const override;
  [[nodiscard]] const std::optional<News>& end() const override { return end_; }

  [[nodiscard]] std::span<const Column> firstColumns() const override;
  [[nodiscard]] std::span<const Column> secondColumns() const override;

  /// Where the vehicle takes itself to be, m from the world's origin.
  [[nodiscard]] Planar reckoned() const { return reckoning_.sinceStart(); }
  /// The newest value of the sensor with that source in the platform file; NaN before the first.
  [[nodiscard]] double newest(std::string_view source) const;
  /// What it is given now; empty: nothing.
  [[nodiscard]] std::optional<remus100::Given> given() const { return override_.given(); }

 private:
  /// Of a network that is not a serial line: nothing waits for it.
  static constexpr double kLineBaud = 1e7;

  [[nodiscard]] const Faults& faults() const { return scenario_.faults; }
  void hear(const GliderByteStream& sbc);
  void take(const hooks::recon::Line& line);
  void noteEnd(bool sbc_gone);
  void set(const char* source, double value);
  void readSensors(const Vehicle& vehicle);
  template <typename Message>
  void send(const Message& message);
  void sendAll(const Vehicle& vehicle);
  [[nodiscard]] hooks::recon::State stateOf(const Vehicle& vehicle) const;
  void flush(const GliderByteStream& sbc);

  const platforms::Platform& platform_;
  const Scenario& scenario_;
  const World& world_;
  Journal& journal_;
  bool virtual_time_;
  SensorArray array_;
  DepthSensor depth_sensor_;
  AttitudeSensor attitude_;
  Altimeter altimeter_;
  Gps gps_;
  Ctd ctd_;
  remus100::Override override_;
  remus100::Autopilot autopilot_;
  DeadReckoning reckoning_;
  SbcStory story_;
  hooks::recon::LineReader lines_;
  std::string out_;
  double now_s_ = 0;
  double depth_m_ = 0;
  std::optional<double> altitude_m_;
  std::optional<Ctd::Reading> water_;
  bool asked_time_ = false;
  bool over_ = false;  ///< the override was ended by the SBC
  bool lost_ = false;  ///< it ended otherwise
  std::optional<News> end_;
};

}  // namespace glider::simulator
