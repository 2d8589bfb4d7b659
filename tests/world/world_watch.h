// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/runtime.h"
#include "simulator/flight_observer.h"
#include "tests/world/conditions.h"
#include "tests/world/environment_check.h"

#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace glider::tests {

/// Tells EnvironmentCheck what happens in a flight of the simulator.
class WorldWatch final : public simulator::FlightObserver {
 public:
  /// Both outlive this.
  WorldWatch(const platforms::Platform& platform, const Conditions& conditions);

  void said(std::span<const uint8_t>, double) override {}
  bool cycle(const simulator::CycleView& view) override;
  /// The runtime has been polled; the newest frame that it had was of the vehicle's time `frame_s`.
  void polled(const GliderContext& context, double frame_s);

  EnvironmentCheck& world() { return world_; }
  [[nodiscard]] double inControl() const { return watched_s_; }
  [[nodiscard]] bool refused() const { return refused_; }

 private:
  void obeyed(const simulator::CycleView& view);
  void reports(const simulator::CycleView& view);
  [[nodiscard]] bool refuses(const simulator::CycleView& view) const;
  void command(uint32_t vertical, double target_m, double depth_m, double time_s);
  void newTick(const GliderContext& context, double frame_s);
  [[nodiscard]] double depthAt(double time_s) const;

  const platforms::Platform& platform_;
  const Conditions& conditions_;
  EnvironmentCheck world_;
  std::vector<bool> wrong_;                       ///< sensors that a fault makes lie
  std::deque<std::pair<double, double>> depths_;  ///< time and true depth of the last cycles
  bool begun_ = false, was_active_ = false, over_ = false, refused_ = false;
  double begun_s_ = 0, watched_s_ = 0;
  std::optional<double> mission_time_;  ///< of the newest tick
  double first_frame_s_ = 0;            ///< of the tick at mission time 0
};

}  // namespace glider::tests
