// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/codec.h"
#include "runtime/core/runtime.h"
#include "runtime/recon/backseat.h"
#include "tests/unit/runtime/log_csv.h"
#include "tests/unit/runtime/two_depths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A mission's program at a vehicle made of lines.
namespace glider::runtime::testing {

/// Limits like those of platforms/remus100.toml.
inline GliderReconMission reconOf() {
  GliderReconMission recon{.greatest_depth_m = 50,
                           .slowest_m_s = 0.8,
                           .fastest_m_s = 2.5,
                           .usual_m_s = 1.5,
                           .count = 2,
                           .unused = 0,
                           .sensors = {},
                           .sources = {}};
  recon.sensors[0] = GLIDER_M_DEPTH;
  recon.sources[0] = static_cast<uint16_t>(recon::Reading::Depth);
  recon.sensors[1] = GLIDER_SCI_WATER_TEMP;
  recon.sources[1] = static_cast<uint16_t>(recon::Reading::Temperature);
  return recon;
}

template <typename Message>
std::string reconLine(const Message& message) {
  char bytes[hooks::recon::kMostLine];
  return {bytes, encode(message, bytes, sizeof bytes)};
}

/// Says once a second what a vehicle says, and obeys lines as a REMUS is known to.
class ReconVehicle {
 public:
  explicit ReconVehicle(const GliderMission& mission, const LinkFacts* checkpoint = nullptr,
                        const GliderRuntimeOptions* options = nullptr)
      : memory_(gliderRuntimeSize() / sizeof(double) + 1),
        context_(mission.context_bytes / sizeof(double) + 1),
        backseat_(std::make_unique<recon::Backseat>(
            mission, reconOf(), GliderByteStream{this, read, write}, checkpoint)),
        options_(options != nullptr ? *options : GliderRuntimeOptions{}) {
    options_.log = {this, writeLog, nullptr, nullptr};
    runtime_ = gliderRuntimeInit(memory_.data(), context_.data(), &mission, &options_);
    runtime_->afterTick(backseat_->afterTick());
  }

  /// A second passes.
  void second() {
    now_s += 1;
    if (asked_time && knows_time) {
      say(hooks::recon::TimeSet{now_s});
    }
    asked_time = false;
    hooks::recon::Ctd ctd;
    ctd.temperature_degC = temperature;
    say(ctd);
    sayState(mode);
    hand();
  }
  void seconds(int count) {
    for (int i = 0; i < count; ++i) {
      second();
    }
  }
  void sayState(uint8_t said) { say(stateAt(now_s, said)); }
  [[nodiscard]] hooks::recon::State stateAt(double time_s, uint8_t said) const {
    hooks::recon::State state;
    state.time_s = time_s - 86400 * static_cast<double>(static_cast<int64_t>(time_s / 86400));
    state.latitude_deg = 41;
    state.longitude_deg = -8.5;
    state.depth_m = depth_m;
    state.heading_deg = heading_deg;
    state.mode = said;
    return state;
  }
  template <typename Message>
  void say(const Message& message) {
    sayBytes(reconLine(message));
  }
  void sayBytes(const std::string& bytes) { to_sbc_ += bytes; }
  /// Gives the program what was said, `piece` bytes at a time.
  void hand() {
    do {
      ready_ += std::min(piece, to_sbc_.size() - ready_);
      work();
    } while (ready_ < to_sbc_.size());
    to_sbc_.clear();
    ready_ = taken_ = 0;
  }
  /// The events of the mission log with this name, as `glidercc log --csv` writes them.
  [[nodiscard]] std::vector<std::string> logged(const std::string& event) const {
    return eventsIn(csvOf(log_), event);
  }
  [[nodiscard]] const GliderContext* context() const { return gliderRuntimeContext(runtime_); }
  [[nodiscard]] uint32_t damaged() const { return *backseat_->damaged(); }
  [[nodiscard]] bool obeys() const { return mode == hooks::recon::Mode::Override; }

  double now_s = 1.7e9, depth_m = 0.2, temperature = 20, heading_deg = 30;
  uint8_t mode = hooks::recon::Mode::Launched;
  size_t piece = 1U << 20U;
  bool deaf = false;                                ///< takes nothing of what is sent
  bool deaf_to_begin = false, deaf_to_end = false;  ///< does not obey `#E,1`, `#E,0`
  bool knows_time = true;
  bool asked_time = false;
  double told_heading = -1, told_speed = -1, told_depth = -1;
  int goals = 0, asks = 0, ends = 0, alive = 0, queries = 0;
  std::vector<std::string> texts;  ///< for a simulated vehicle
  bool finished = false;

 private:
  void work() {
    const GliderClock clock{this, [](void*) { return 0.0; }};
    const GliderByteStream stream = backseat_->stream();
    while (!finished) {
      const GliderRuntimeStatus status = gliderRuntimePoll(runtime_, &stream, &clock);
      finished = status == kGliderRuntimeFinished && backseat_->mayEnd();
      if (status != kGliderRuntimeProgressed) {
        break;
      }
    }
  }
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity) {
    auto& vehicle = *static_cast<ReconVehicle*>(self);
    const size_t count = std::min<size_t>(capacity, vehicle.ready_ - vehicle.taken_);
    std::copy_n(vehicle.to_sbc_.begin() + static_cast<ptrdiff_t>(vehicle.taken_), count, bytes);
    vehicle.taken_ += count;
    return static_cast<int32_t>(count);
  }
  static int32_t writeLog(void* self, const uint8_t* bytes, uint32_t count) {
    static_cast<ReconVehicle*>(self)->log_.append(reinterpret_cast<const char*>(bytes), count);
    return static_cast<int32_t>(count);
  }
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count) {
    auto& vehicle = *static_cast<ReconVehicle*>(self);
    for (uint32_t i = 0; i < count && !vehicle.deaf; ++i) {
      hooks::recon::Line line;
      if (vehicle.from_sbc_.push(bytes[i], &line)) {
        vehicle.obey(line);
      }
    }
    EXPECT_EQ(vehicle.from_sbc_.skippedBytes(), 0U);
    return static_cast<int32_t>(count);
  }
  void obey(const hooks::recon::Line& line) {
    hooks::recon::HeadingGoal heading;
    hooks::recon::SpeedGoal speed;
    hooks::recon::DepthGoal depth;
    hooks::recon::Override override_;
    hooks::recon::SimulationText text;
    hooks::recon::KeepAlive keep_alive;
    hooks::recon::TimeQuery query;
    if (decode(line, heading)) {
      told_heading = heading.heading_deg;
    } else if (decode(line, speed)) {
      told_speed = speed.value;
    } else if (decode(line, depth)) {
      told_depth = depth.depth_m;
      ++goals;
    } else if (decode(line, override_)) {
      (override_.on ? asks : ends) += 1;
      if (override_.on ? !deaf_to_begin : !deaf_to_end) {
        mode = override_.on ? hooks::recon::Mode::Override : hooks::recon::Mode::Launched;
      }
    } else if (decode(line, text)) {
      texts.emplace_back(text.text.bytes, text.text.size);
    } else if (decode(line, keep_alive)) {
      ++alive;
    } else if (decode(line, query)) {
      ++queries;
      asked_time = true;
    } else {
      ADD_FAILURE() << std::string(line.text, line.size);
    }
  }

  std::string to_sbc_;
  size_t ready_ = 0, taken_ = 0;  ///< of to_sbc_: has arrived, was read
  hooks::recon::LineReader from_sbc_;
  std::vector<double> memory_, context_;
  std::string log_;
  std::unique_ptr<recon::Backseat> backseat_;
  GliderRuntimeOptions options_;
  GliderRuntime* runtime_ = nullptr;
};

}  // namespace glider::runtime::testing
