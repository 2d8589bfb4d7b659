// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/window.h"
#include "runtime/core/lay_out.h"
#include "runtime/library/library.h"
#include "tests/unit/runtime/bench_mission.h"
#include "tests/unit/runtime/log_csv.h"
#include "tests/unit/runtime/power_cut_store.h"
#include "tests/unit/runtime/vehicle_bench.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace glider::runtime::testing {

/// What of a context outlives a power cut.
inline Bytes bodyOf(const GliderContext& context) {
  const auto* from = reinterpret_cast<const uint8_t*>(&context.mission_time);
  return {from, reinterpret_cast<const uint8_t*>(context.calls)};
}

/// A tick as it went into the mission, and what it made of it.
struct Tick {
  double time;
  std::vector<GliderUpdate> updates;
  Bytes body;
};

/// A yo that calls another one for a while: it has a stack, variables (ticks counted, and the mean
/// of depth copied), a window, and memory of its profile.
class ResumeBench : public ::testing::Test {
 protected:
  ResumeBench() {
    mission_.sensors = {depthSensor(), temperatureSensor()};
    mission_.states = {benchState("first", to_second_, 2), benchState("second", &back_, 1)};
    mission_.variable_count = 2;
    mission_.mission.temporal_slots = GLIDER_WINDOW_HEADER + GLIDER_WINDOW_SLOT * window_.bins;
    mission_.guards = [this](const GliderContext& c) {
      const bool over = c.mission_time >= end;
      const bool leaves = c.mission_time >= 100 && c.mission_time < 160;
      return c.state == 1 ? (leaves ? GLIDER_NO_CASE : 0U)
             : over       ? 1U
                          : (leaves ? 0U : GLIDER_NO_CASE);
    };
    mission_.begin = [this](GliderContext& c) {
      gliderWindowStart(c.temporals, &window_, c.mission_time);
      c.variables[0] = 0;
    };
    mission_.advance = [this](GliderContext& c) {
      gliderWindowAdvance(c.temporals, &window_, c.mission_time, c.mission_time,
                          c.readings[0].value, 1);
      c.variables[0] += counts ? 1 : 0;
      c.variables[1] = counts ? c.temporals[0] : 0;
    };
    mission_.fly = [](GliderContext& c, uint32_t phase) {
      gliderProfileYo(&c, &c.memory[0], phase, 5, c.state == 0 ? 12 : 15, .454, .454);
    };
    mission_.mission.resume_within = 120;
    mission_.finish(1);
    mission_.mission.memory_count = 1;
    mission_.mission.context_bytes =
        static_cast<uint32_t>(gliderContextLayout(&mission_.mission).bytes);
    mission_.memory.assign(mission_.mission.context_bytes / sizeof(double), 0.0);
  }

  /// Power comes: the program starts, and remembers nothing but its checkpoints.
  void boot(VehicleBench& vehicle, uint32_t program = 7) {
    runtime_memory_.assign(gliderRuntimeSize() / sizeof(double) + 1, -1.0);
    std::ranges::fill(mission_.memory, -1.0);
    const GliderRuntimeOptions options{{this, &ResumeBench::writeLog, nullptr, nullptr},
                                       nullptr,
                                       keeps ? store_.store() : GliderStore{},
                                       program};
    runtime_ = gliderRuntimeInit(runtime_memory_.data(), mission_.memory.data(), &mission_.mission,
                                 &options);
    ASSERT_NE(runtime_, nullptr);
    finished_ = false;
    last_time_.reset();
    vehicle.sbc = [this, &vehicle] { poll(vehicle); };
  }
  static void cutPower(VehicleBench& vehicle) {
    vehicle.sbc = [] {};
  }

  void poll(VehicleBench& vehicle) {
    const GliderByteStream stream = vehicle.sbcEnd();
    double now = vehicle.now();
    const GliderClock clock{&now, [](void* t) { return *static_cast<double*>(t); }};
    for (int i = 0; i < 100 && !finished_; ++i) {
      const auto status = gliderRuntimePoll(runtime_, &stream, &clock);
      finished_ = status == kGliderRuntimeFinished;
      noteTick();
      if (status == kGliderRuntimeIdle) {
        return;
      }
    }
  }

  void noteTick() {
    const GliderContext* c = gliderRuntimeContext(runtime_);
    if (c == nullptr || (last_time_ && *last_time_ == c->mission_time)) {
      return;
    }
    last_time_ = c->mission_time;
    Tick tick{c->mission_time, {}, bodyOf(*c)};
    for (uint32_t i = 0; i < 2; ++i) {
      if (c->readings[i].seen != 0 && c->readings[i].updated == c->mission_time) {
        tick.updates.push_back(update(mission_.sensors[i].id, c->readings[i].raw));
      }
    }
    ticks_.push_back(tick);
  }

  static int32_t writeLog(void* self, const uint8_t* bytes, uint32_t count) {
    static_cast<ResumeBench*>(self)->log_text_.append(reinterpret_cast<const char*>(bytes), count);
    return static_cast<int32_t>(count);
  }

  /// The ticks of an undisturbed mission that is fed with those.
  std::vector<Bytes> undisturbed(const std::vector<Tick>& fed) {
    std::vector<double> memory(mission_.memory.size(), -2.0);
    GliderContext* context = nullptr;
    std::vector<Bytes> bodies;
    for (const Tick& tick : fed) {
      const auto count = static_cast<uint32_t>(tick.updates.size());
      if (context == nullptr) {
        context =
            gliderStart(memory.data(), &mission_.mission, nullptr, tick.updates.data(), count);
      } else {
        gliderStep(context, tick.time, tick.updates.data(), count);
      }
      bodies.push_back(bodyOf(*context));
    }
    return bodies;
  }

  [[nodiscard]] std::string logCsv() const { return csvOf(log_text_); }

  GliderWindowShape window_{60, 4, 17, kGliderMean, 0, 0};
  GliderCaseInfo to_second_[2] = {{kGliderCall, 1}, {kGliderExit, 0}};
  GliderCaseInfo back_{kGliderReturn, 0};
  double end = 400;
  bool counts = true;  ///< a variable changes in every tick
  bool keeps = true;
  BenchMission mission_;
  RecordingStore store_;
  std::vector<double> runtime_memory_;
  GliderRuntime* runtime_ = nullptr;
  bool finished_ = false;
  std::optional<double> last_time_;
  std::vector<Tick> ticks_;
  std::string log_text_;
};

}  // namespace glider::runtime::testing
