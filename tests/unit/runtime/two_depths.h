// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/library/library.h"
#include "tests/unit/runtime/bench_mission.h"

namespace glider::runtime::testing {

/// A mission of two states that change with the temperature, each with a depth of its own.
struct TwoDepths : BenchMission {
  TwoDepths() {
    sensors = {depthSensor(), temperatureSensor()};
    states = {benchState("warm", &to_cold, 1), benchState("cold", &to_warm, 1)};
    guards = [this](const GliderContext& c) {
      if (c.mission_time >= end_s) {
        return GLIDER_NO_CASE;
      }
      const double temperature = c.readings[1].value;
      return (c.state == 0 ? temperature < 12 : temperature > 14) ? 0U : GLIDER_NO_CASE;
    };
    always = {exit_case};
    always_guards = [this](const GliderContext& c, uint32_t) {
      return c.mission_time >= end_s ? 0U : GLIDER_NO_CASE;
    };
    fly = [this](GliderContext& c, uint32_t phase) {
      if (phase != kGliderTick) {
        gliderDescendAt(&c, c.state == 0 ? 20 : deeper_m, 1.25);
        gliderSteer(&c, 1.5);
      }
    };
    finish(2);
  }
  GliderCaseInfo to_cold{kGliderGoto, 1}, to_warm{kGliderGoto, 0};
  GliderCaseInfo exit_case{kGliderExit, 0};
  double end_s = 1e9;
  double deeper_m = 40;
};

}  // namespace glider::runtime::testing
