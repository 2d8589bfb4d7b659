// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/core/runtime.h"
#include "runtime/imc/backseat.h"
#include "tests/unit/runtime/imc_packets.h"
#include "tests/unit/runtime/log_csv.h"
#include "tests/unit/runtime/two_depths.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A mission's program at a vehicle made of packets.
namespace glider::runtime::testing {

inline GliderImcMission imcOf(double greatest_depth_m = 50) {
  GliderImcMission imc = kImcLimits;
  imc.greatest_depth_m = greatest_depth_m;
  imc.count = 2;
  imc.sensors[0] = GLIDER_M_DEPTH;
  imc.sources[0] = static_cast<uint16_t>(imc::Reading::Depth);
  imc.sensors[1] = GLIDER_SCI_WATER_TEMP;
  imc.sources[1] = static_cast<uint16_t>(imc::Reading::Temperature);
  return imc;
}

/// Says once a second what a vehicle says, and obeys packets as DUNE does.
class ImcVehicle {
 public:
  /// A line `that_renews` can be opened again, as that of TCP; a serial one cannot.
  explicit ImcVehicle(const GliderMission& mission, const GliderImcMission& imc = imcOf(),
                      bool that_renews = true)
      : memory_(gliderRuntimeSize() / sizeof(double) + 1),
        context_(mission.context_bytes / sizeof(double) + 1),
        backseat_(
            std::make_unique<imc::Backseat>(mission, imc,
                                            imc::VehicleLine{.stream = {this, read, write},
                                                             .renew = that_renews ? renew : nullptr,
                                                             .self = this},
                                            nullptr)),
        options_{{this, writeLog, nullptr, nullptr}, nullptr, {}, 0},
        runtime_(gliderRuntimeInit(memory_.data(), context_.data(), &mission, &options_)) {
    runtime_->afterTick(backseat_->afterTick());
  }

  /// A second passes.
  void second() {
    now_s += 1;
    if (plan && now_s - heard_s > 15) {
      say(followState(hooks::imc::FollowState::Timeout, hooks::imc::kAllSystems));
      plan.reset();
    }
    say(planState(plan ? hooks::imc::PlanState::Executing : hooks::imc::PlanState::Ready,
                  plan ? plan->c_str() : ""));
    if (plan == "glidercc") {
      hooks::imc::FollowRefState follows = followState(hooks::imc::FollowState::Goto);
      follows.reference = {.present = references > 0, .value = told};
      say(follows);
    }
    say(hooks::imc::Temperature{.value = static_cast<float>(temperature)});
    say(hooks::imc::VehicleMedium{.medium = medium});
    hooks::imc::EstimatedState state;
    state.lat = 0.72;
    state.lon = -0.15;
    state.depth = static_cast<float>(depth_m);
    state.alt = -1;
    say(state);
    hand();
  }
  void seconds(int count) {
    for (int i = 0; i < count; ++i) {
      second();
    }
  }
  template <typename Message>
  void say(const Message& message, uint16_t source = kVehicleAddress) {
    const auto bytes = packetBytes(message, now_s, source);
    if (lost_packet_ && *lost_packet_ == Message::kId) {
      return;
    }
    to_sbc_.insert(to_sbc_.end(), bytes.begin(), bytes.end());
  }
  /// The packets of that message do not arrive from now on.
  void lose(std::optional<uint16_t> message) { lost_packet_ = message; }
  /// Gives the program what was said, `piece` bytes at a time.
  void hand() {
    do {
      ready_ += std::min(piece, to_sbc_.size() - ready_);
      work();
    } while (ready_ < to_sbc_.size());
    to_sbc_.clear();
    ready_ = taken_ = 0;
  }
  void sayBytes(const std::vector<uint8_t>& bytes) {
    to_sbc_.insert(to_sbc_.end(), bytes.begin(), bytes.end());
  }
  /// Replies to the newest request of the program.
  void reply(uint8_t type, uint16_t destination = imc::kOwnAddress) {
    hooks::imc::PlanControl said;
    said.type = type;
    said.op = requested_op;
    said.request_id = request_id;
    const auto bytes = packetBytes(said, now_s, kVehicleAddress, destination);
    to_sbc_.insert(to_sbc_.end(), bytes.begin(), bytes.end());
  }
  /// The events of the mission log with this name, as `glidercc log --csv` writes them.
  [[nodiscard]] std::vector<std::string> logged(const std::string& event) const {
    return eventsIn(csvOf(log_), event);
  }
  [[nodiscard]] const GliderContext* context() const { return gliderRuntimeContext(runtime_); }
  [[nodiscard]] uint32_t damaged() const { return *backseat_->damaged(); }
  [[nodiscard]] double toldDepth() const { return static_cast<double>(told.z.value.value); }
  [[nodiscard]] int count(const std::string& begin) const {
    return static_cast<int>(std::ranges::count_if(
        texts, [&](const std::string& text) { return text.starts_with(begin); }));
  }

  double now_s = 1.7e9, depth_m = 0.2, temperature = 20;
  uint8_t medium = hooks::imc::Medium::WaterSurface;
  size_t piece = 1U << 20U;
  bool refuses = false;      ///< to start and to stop
  uint8_t requested_op = 0;  ///< of the newest request, with its number
  uint16_t request_id = 0;
  bool deaf = false;                ///< takes nothing of what is sent
  bool stuck = false;               ///< the line has no room for more
  bool closed = false;              ///< there is no connection
  std::optional<std::string> plan;  ///< that it executes
  hooks::imc::Reference told{};     ///< the newest
  double heard_s = 0;
  int references = 0, starts = 0, stops = 0, heartbeats = 0, renewed = 0;
  std::vector<std::string> texts;  ///< entries for its log
  bool finished = false;

 private:
  void work() {
    const GliderClock clock{this, [](void*) { return 0.0; }};
    const GliderByteStream stream = backseat_->stream();
    while (!finished) {
      const GliderRuntimeStatus status = gliderRuntimePoll(runtime_, &stream, &clock);
      finished = status == kGliderRuntimeFinished;
      if (status != kGliderRuntimeProgressed) {
        break;
      }
    }
  }
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity) {
    auto& vehicle = *static_cast<ImcVehicle*>(self);
    if (vehicle.closed) {
      return kGliderStreamClosed;
    }
    const size_t count = std::min<size_t>(capacity, vehicle.ready_ - vehicle.taken_);
    std::copy_n(vehicle.to_sbc_.begin() + static_cast<ptrdiff_t>(vehicle.taken_), count, bytes);
    vehicle.taken_ += count;
    return static_cast<int32_t>(count);
  }
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count) {
    auto& vehicle = *static_cast<ImcVehicle*>(self);
    if (vehicle.closed || vehicle.stuck) {
      return vehicle.closed ? kGliderStreamClosed : 0;
    }
    for (uint32_t taken = 0; taken < count && !vehicle.deaf;) {
      taken += vehicle.from_sbc_.push(bytes + taken, count - taken);
      for (hooks::imc::Packet packet; vehicle.from_sbc_.next(&packet);) {
        vehicle.obey(packet);
      }
    }
    EXPECT_EQ(vehicle.from_sbc_.skippedBytes(), 0U);
    return static_cast<int32_t>(count);
  }
  static int32_t writeLog(void* self, const uint8_t* bytes, uint32_t count) {
    static_cast<ImcVehicle*>(self)->log_.append(reinterpret_cast<const char*>(bytes), count);
    return static_cast<int32_t>(count);
  }
  static void renew(void* self) { ++static_cast<ImcVehicle*>(self)->renewed; }
  void obey(const hooks::imc::Packet& packet) {
    hooks::imc::PlanControl request;
    hooks::imc::Reference reference;
    hooks::imc::LogBookEntry entry;
    EXPECT_EQ(packet.header.source, imc::kOwnAddress);
    EXPECT_EQ(packet.header.time_s, now_s) << "by the vehicle's clock";
    if (decode(packet, request)) {
      EXPECT_EQ(packet.header.destination, kVehicleAddress) << "else DUNE does not start it";
      starts += request.op == hooks::imc::PlanOperation::Start ? 1 : 0;
      stops += request.op == hooks::imc::PlanOperation::Stop ? 1 : 0;
      requested_op = request.op;
      request_id = request.request_id;
      heard_s = now_s;
      if (refuses) {
        reply(hooks::imc::PlanControlType::Failure);
        return;
      }
      plan = request.op == hooks::imc::PlanOperation::Start
                 ? std::optional(std::string(request.plan_id.bytes, request.plan_id.size))
                 : std::nullopt;
    } else if (decode(packet, reference)) {
      told = reference;
      heard_s = now_s;
      ++references;
    } else if (decode(packet, entry)) {
      EXPECT_TRUE(entry.context == hooks::imc::textOf("glidercc"));
      texts.emplace_back(entry.text.bytes, entry.text.size);
    } else if (packet.id == hooks::imc::Heartbeat::kId) {
      ++heartbeats;
    }
  }

  std::vector<uint8_t> to_sbc_;
  size_t ready_ = 0, taken_ = 0;  ///< of to_sbc_: has arrived, was read
  std::optional<uint16_t> lost_packet_;
  hooks::imc::PacketReader from_sbc_;
  std::vector<double> memory_, context_;
  std::string log_;
  std::unique_ptr<imc::Backseat> backseat_;
  GliderRuntimeOptions options_;
  GliderRuntime* runtime_;
};

}  // namespace glider::runtime::testing
