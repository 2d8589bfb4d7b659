// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/context_layout.h"
#include "runtime/abi/runtime.h"
#include "tests/slocum.h"

#include <algorithm>
#include <functional>
#include <vector>

/// A mission made by hand, as generated code would describe it, whose guards and flying the test
/// gives.
namespace glider::runtime::testing {

struct BenchMission {
  std::vector<GliderSensorInfo> sensors;
  std::vector<GliderStateInfo> states;
  std::vector<const GliderStateInfo*> places;  ///< of the states
  GliderMission mission{};

  std::vector<GliderCaseInfo> always;
  std::vector<GliderParameterInfo> parameters;
  uint32_t variable_count = 0;  ///< beside the parameters

  /// The state's own cases: the one whose guard is true.
  std::function<uint32_t(const GliderContext&)> guards = [](const GliderContext&) {
    return GLIDER_NO_CASE;
  };
  /// Those of `always`, from a number on.
  std::function<uint32_t(const GliderContext&, uint32_t)> always_guards =
      [](const GliderContext&, uint32_t) { return GLIDER_NO_CASE; };
  /// A profile: its phases enter and resume, and a tick.
  std::function<void(GliderContext&, uint32_t)> fly = [](GliderContext&, uint32_t) {};
  std::function<void(GliderContext&, uint32_t, uint32_t)> act = [](GliderContext&, uint32_t,
                                                                   uint32_t) {};
  std::function<uint32_t(GliderContext&)> route = [](GliderContext&) { return GLIDER_NO_CASE; };
  std::function<void(GliderContext&)> begin = [](GliderContext&) {};
  std::function<void(GliderContext&)> advance = [](GliderContext&) {};
  std::function<uint32_t(const GliderContext&)> condition = [](const GliderContext&) {
    return GLIDER_NO_CASE;
  };

  /// Fills in `mission` and makes this the bench mission that its functions ask.
  const GliderMission& finish(uint32_t stack_limit) {
    active() = this;
    mission.abi_version = GLIDER_ABI_VERSION;
    mission.state_count = static_cast<uint32_t>(states.size());
    mission.sensor_count = static_cast<uint32_t>(sensors.size());
    mission.stack_limit = stack_limit;
    mission.memory_count = 2 * mission.state_count;
    mission.parameter_count = static_cast<uint32_t>(parameters.size());
    mission.variable_count = mission.parameter_count + variable_count;
    mission.always_count = static_cast<uint32_t>(always.size());
    mission.context_bytes = static_cast<uint32_t>(gliderContextLayout(&mission).bytes);
    mission.always = always.data();
    mission.parameters = parameters.data();
    mission.dictionary = &gliderDictionary;
    mission.name = "bench";
    places.clear();
    for (const GliderStateInfo& state : states) {
      places.push_back(&state);
    }
    mission.states = places.data();
    mission.sensors = sensors.data();
    mission.begin = [](GliderContext* c) { active()->begin(*c); };
    mission.advance = [](GliderContext* c) { active()->advance(*c); };
    mission.guards = [](GliderContext* c, uint32_t from) {
      return active()->always_guards(*c, from);
    };
    mission.act = [](GliderContext* c, uint32_t fired) {
      active()->act(*c, kGliderListAlways, fired);
    };
    mission.condition = [](const GliderContext* c) { return active()->condition(*c); };
    std::ranges::for_each(states, give);
    memory.assign(mission.context_bytes / sizeof(double), 0.0);
    return mission;
  }
  GliderContext* start(const std::vector<GliderUpdate>& frame = {},
                       const double* values = nullptr) {
    return gliderStart(memory.data(), &mission, values, frame.data(),
                       static_cast<uint32_t>(frame.size()));
  }

  /// Gives a state its code.
  static void give(GliderStateInfo& state) {
    state.guards = [](GliderContext* c, uint32_t) { return active()->guards(*c); };
    state.act = [](GliderContext* c, uint32_t fired) {
      active()->act(*c, kGliderListState, fired);
    };
    state.enter = [](GliderContext* c, uint32_t phase) { active()->fly(*c, phase); };
    state.profile = [](GliderContext* c) {
      active()->fly(*c, kGliderTick);
      return GLIDER_NO_CASE;
    };
    state.route = [](GliderContext* c) { return active()->route(*c); };
  }
  static BenchMission*& active() {
    static BenchMission* mission = nullptr;
    return mission;
  }
  std::vector<double> memory;  ///< of the context
};

inline GliderStateInfo benchState(const char* name, const GliderCaseInfo* cases = nullptr,
                                  uint32_t case_count = 0, const GliderLogInfo* log = nullptr,
                                  uint32_t log_count = 0) {
  GliderStateInfo state{};
  state.name = name;
  state.cases = cases;
  state.log = log;
  state.case_count = case_count;
  state.log_count = log_count;
  return state;
}
inline GliderSensorInfo depthSensor() {
  return {"m_depth", nullptr, 1, 0, 1200, 20, GLIDER_M_DEPTH, kGliderLinear};
}
inline GliderSensorInfo temperatureSensor() {
  return {"sci_water_temp", nullptr, 1, -5, 45, 20, GLIDER_SCI_WATER_TEMP, kGliderLinear};
}
inline GliderUpdate update(uint32_t id, double value) {
  return {value, id, 0};
}
inline void step(GliderContext* context, double time, const std::vector<GliderUpdate>& frame = {}) {
  gliderStep(context, time, frame.data(), static_cast<uint32_t>(frame.size()));
}

}  // namespace glider::runtime::testing
