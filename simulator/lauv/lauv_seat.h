// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/codec.h"
#include "hooks/imc/packet_reader.h"
#include "simulator/lauv/autopilot.h"
#include "simulator/lauv/plan_server.h"
#include "simulator/seat/dead_reckoning.h"
#include "simulator/seat/sbc_story.h"
#include "simulator/seat/sensor_array.h"
#include "simulator/seat/simulated_seat.h"
#include "simulator/sensors/sensor_list.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::simulator {

/// The computer of a LAUV: it flies the plan of a back seat, which speaks IMC with it. Without a
/// plan the propeller stops and the vehicle floats up.
class LauvSeat final : public SimulatedSeat {
 public:
  explicit LauvSeat(const SeatSetup& setup);

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
  [[nodiscard]] bool inControl() const override { return plans_.executes(); }
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
  /// What it is given now; null: nothing.
  [[nodiscard]] const hooks::imc::Reference* reference() const { return plans_.reference(); }

 private:
  /// Of a connection that is not a serial line: nothing waits for it.
  static constexpr double kLineBaud = 1e7;

  [[nodiscard]] const Faults& faults() const { return scenario_.faults; }
  void hear(const GliderByteStream& sbc);
  void takeStory(const hooks::imc::Packet& packet);
  void noteEnd(bool sbc_gone);
  void set(const char* source, double value);
  void readSensors(const Vehicle& vehicle);
  template <typename Message>
  void send(const Message& message);
  void sendAll(const Vehicle& vehicle);
  [[nodiscard]] hooks::imc::EstimatedState stateOf(const Vehicle& vehicle) const;
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
  lauv::PlanServer plans_;
  lauv::Autopilot autopilot_;
  DeadReckoning reckoning_;
  SbcStory story_;
  hooks::imc::PacketReader packets_;
  std::vector<uint8_t> out_;
  double now_s_ = 0;
  double depth_m_ = 0, altitude_m_ = -1;
  std::optional<Ctd::Reading> water_;
  std::optional<GeoPosition> fix_;
  uint8_t doing_ = 0;  ///< FollowState
  bool over_ = false;  ///< the plan was ended by a back seat or an operator
  bool lost_ = false;  ///< by its time-out
  std::optional<News> end_;
};

}  // namespace glider::simulator
