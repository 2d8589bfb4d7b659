// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/values.h"
#include "simulator/flight/sensor_array.h"

#include <cstdint>
#include <span>

namespace glider::simulator {

/// How the vehicle stands after a control cycle.
struct CycleView {
  double time_s = 0;
  hooks::HookState hook = hooks::HookState::Absent;
  double true_depth_m = 0;
  bool aborted = false;  ///< the flight controller has aborted its mission
  bool ended = false;    ///< the flight controller's mission is over
  const SensorArray& array;
};

/// Looks on while a mission is flown, from where nothing is damaged.
class Onlooker {
 public:
  virtual ~Onlooker() = default;
  /// The SBC says `bytes`, at its own end of the line.
  virtual void said(std::span<const uint8_t> bytes, double now_s) = 0;
  /// A control cycle is over. False: there is no more to be seen, the flight may end here.
  virtual bool cycle(const CycleView& view) = 0;
};

}  // namespace glider::simulator
