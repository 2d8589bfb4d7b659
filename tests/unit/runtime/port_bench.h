// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/sentence.h"
#include "runtime/extctl/backseat.h"
#include "tests/unit/runtime/two_depths.h"
#include "tests/unit/runtime/vehicle_bench.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace glider::runtime::extctl {

using hooks::extctl::PortSensor;
using testing::BenchMission;

/// The vehicle's mission is so old when a test begins, s: the program may steer.
inline constexpr double kBegun = 40;
inline constexpr GliderPortMission kPort{
    60, 0.7854, 0.19, 10, 4711, GLIDER_M_LAT, GLIDER_M_LON, GLIDER_M_DEPTH_STATE, 0};

/// The same mission for a vehicle that glides.
struct TwoStates : testing::TwoDepths {
  TwoStates() {
    fly = [](GliderContext& c, uint32_t phase) {
      if (phase != kGliderTick) {
        gliderDescend(&c, c.state == 0 ? 20 : 40, -0.4);
        gliderSteer(&c, 1.5);
      }
    };
  }
};

/// A vehicle's port: reports what changes, and keeps what the SBC writes.
class PortBench {
 public:
  explicit PortBench(const GliderMission& mission, const LinkFacts* checkpoint = nullptr)
      : port_(portIndices(mission)),
        memory_(gliderRuntimeSize() / sizeof(double) + 1),
        context_(mission.context_bytes / sizeof(double) + 1),
        backseat_(std::make_unique<Backseat>(mission, kPort, GliderByteStream{this, read, write},
                                             BackseatOptions{.checkpoint = checkpoint})),
        runtime_(gliderRuntimeInit(memory_.data(), context_.data(), &mission, nullptr)) {}

  /// Bytes arrive at the SBC; it works until it has nothing to do.
  void send(std::string_view bytes) {
    to_sbc_ += bytes;
    const GliderClock clock{this, [](void*) { return 0.0; }};
    const GliderByteStream stream = backseat_->stream();
    while (!finished_) {
      const GliderRuntimeStatus status = gliderRuntimePoll(runtime_, &stream, &clock);
      finished_ = status == kGliderRuntimeFinished && backseat_->mayEnd();
      if (status != kGliderRuntimeProgressed) {
        break;
      }
    }
  }
  void say(const std::string& body) {
    char text[1200];
    hooks::extctl::SentenceWriter writer(text, sizeof text);
    writer.put(body.c_str());
    send({text, writer.end()});
  }
  void begin(bool tells_program = true) {
    say("HI");
    say(fmt::format("SD,{}:0", index(PortSensor::InGliderDos)));
    if (tells_program) {
      say(fmt::format("SD,{}:{}", index(PortSensor::Program), kPort.program));
    }
  }
  void cycle(double now_s, double depth, double temperature) {
    const std::string clock = fmt::format("{}:{:.12f}", port_.count() - 1, 1.7e9 + now_s);
    say(fmt::format("SD,{}:{:.12f},{}:{:.12f},{}:{:.12f},{}",
                    ofSensor(GLIDER_M_PRESENT_SECS_INTO_MISSION), now_s, ofSensor(GLIDER_M_DEPTH),
                    depth, ofSensor(GLIDER_SCI_WATER_TEMP), temperature, clock));
  }
  /// A cycle in which nothing has changed but the clocks.
  void cycle(double now_s) {
    say(fmt::format("SD,{}:{:.12f},{}:{:.12f}", ofSensor(GLIDER_M_PRESENT_SECS_INTO_MISSION), now_s,
                    port_.count() - 1, 1.7e9 + now_s));
  }
  [[nodiscard]] double written(PortSensor sensor) const {
    const auto found = values.find(index(sensor));
    return found == values.end() ? NAN : found->second;
  }
  [[nodiscard]] const GliderContext* context() const { return gliderRuntimeContext(runtime_); }
  [[nodiscard]] bool finished() const { return finished_; }
  [[nodiscard]] uint32_t ofSensor(uint16_t id) const { return port_.indexOf(id); }
  [[nodiscard]] uint32_t damaged() const { return *backseat_->damaged(); }
  [[nodiscard]] uint32_t clock() const { return port_.count() - 1; }

  std::map<uint32_t, double> values;  ///< written by the SBC
  std::vector<std::string> texts;
  std::vector<std::string> others;
  bool line_is_cut = false;
  bool line_is_stuck = false;  ///< takes nothing

  static uint32_t index(PortSensor sensor) { return static_cast<uint32_t>(sensor); }

 private:
  static hooks::extctl::Port portIndices(const GliderMission& mission) {
    std::vector<hooks::Subscription> all = {{.id = GLIDER_M_LAT}, {.id = GLIDER_M_LON}};
    for (uint32_t i = 0; i < mission.sensor_count; ++i) {
      all.push_back({.id = static_cast<uint16_t>(mission.sensors[i].id)});
    }
    all.push_back({.id = GLIDER_M_DEPTH});
    return {gliderDictionary, all.data(), static_cast<uint32_t>(all.size())};
  }
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity) {
    auto& bench = *static_cast<PortBench*>(self);
    if (bench.line_is_cut) {
      return kGliderStreamClosed;
    }
    const size_t count = bench.to_sbc_.copy(reinterpret_cast<char*>(bytes), capacity);
    bench.to_sbc_.erase(0, count);
    return static_cast<int32_t>(count);
  }
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count) {
    auto& bench = *static_cast<PortBench*>(self);
    if (bench.line_is_stuck) {
      return 0;
    }
    for (uint32_t i = 0; i < count; ++i) {
      if (bench.from_sbc_.push(bytes[i])) {
        bench.take({bench.from_sbc_.body(), bench.from_sbc_.size()});
      }
    }
    EXPECT_EQ(bench.from_sbc_.bad(), 0U);
    return static_cast<int32_t>(count);
  }
  void take(const std::string& body) {
    if (body.starts_with("TXT,")) {
      texts.push_back(body.substr(4));
    } else if (body.starts_with("SW,")) {
      for (size_t at = 2; at != std::string::npos; at = body.find(',', at + 1)) {
        values[static_cast<uint32_t>(std::stoul(body.substr(at + 1)))] =
            std::stod(body.substr(body.find(':', at) + 1));
      }
    } else {
      others.push_back(body);
    }
  }

  hooks::extctl::Port port_;
  std::string to_sbc_;
  hooks::extctl::SentenceReader from_sbc_;
  std::vector<double> memory_, context_;
  std::unique_ptr<Backseat> backseat_;
  GliderRuntime* runtime_;
  bool finished_ = false;
};

}  // namespace glider::runtime::extctl
