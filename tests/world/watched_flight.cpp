// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/world/watched_flight.h"

#include "flights/in_process_sbc.h"
#include "flights/launch_choice.h"
#include "hooks/protocol/frame.h"
#include "hooks/protocol/tick.h"
#include "ir/opt/optimise.h"
#include "simulator/ocean/ocean.h"
#include "simulator/simulator.h"
#include "support/check.h"
#include "tests/world/world_watch.h"

#include <cmath>
#include <utility>

namespace glider::tests {
namespace {

using flights::InProcessSbc;

/// An SBC in process that reports the time of the newest frame that it received.
class HearingSbc final : public simulator::SbcPort {
 public:
  HearingSbc(std::unique_ptr<InProcessSbc> sbc, WorldWatch& watch) : sbc_(std::move(sbc)) {
    sbc_->watch(
        [this, &watch](const GliderContext& context, double) { watch.polled(context, frame_s_); });
  }

  [[nodiscard]] std::string way() const override { return sbc_->way(); }
  void setTime(double now_s) override { sbc_->setTime(now_s); }
  void deliver(std::span<const uint8_t> bytes, double now_s) override {
    for (const uint8_t byte : bytes) {
      hooks::TickHead head;
      if (decoder_.push(byte) && hooks::decode(decoder_.frame(), head)) {
        frame_s_ = head.vehicle_time_s;
      }
    }
    sbc_->deliver(bytes, now_s);
  }
  std::vector<uint8_t> collect() override { return sbc_->collect(); }
  void kill() override { sbc_->kill(); }
  [[nodiscard]] bool alive() const override { return sbc_->alive(); }
  [[nodiscard]] bool keepsTime() const override { return sbc_->keepsTime(); }
  void plug(bool in) override { sbc_->plug(in); }
  [[nodiscard]] std::string exitReason() const override { return sbc_->exitReason(); }

 private:
  std::unique_ptr<InProcessSbc> sbc_;
  hooks::FrameDecoder decoder_;
  double frame_s_ = 0;
};

/// What the water did where the vehicle was, and how the vehicle went on in it.
void judgeDrift(const support::Trace& trace, const simulator::Scenario& scenario,
                const platforms::Platform& platform, EnvironmentCheck& world) {
  // A glider that has come up glides on for some seconds.
  constexpr double kStill_s = 60;
  const simulator::Ocean ocean(scenario.ocean);
  const int time = trace.column("time"), depth = trace.column("true_depth");
  const int x = trace.column("true_x"), y = trace.column("true_y");
  double under_water_s = 0;
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    const double now = trace.at(row, time);
    const auto current = ocean.current(trace.at(row, depth), trace.at(row, x), trace.at(row, y));
    world.drifts(now, std::hypot(current.east, current.north));
    under_water_s = trace.at(row, depth) > platform.world.surface_depth_m ? now : under_water_s;
    const double passed = row > 0 ? now - trace.at(row - 1, time) : 0;
    if (passed <= 0) {
      continue;
    }
    const double east = (trace.at(row, x) - trace.at(row - 1, x)) / passed;
    const double north = (trace.at(row, y) - trace.at(row - 1, y)) / passed;
    world.getsOn(now, std::hypot(east - current.east, north - current.north));
    if (now - under_water_s > kStill_s) {
      world.floatsAlong(now, std::hypot(east, north));
    }
  }
}

}  // namespace

support::Result<FlyingMission> loadMission(const std::string& path, std::string text) {
  FlyingMission mission;
  mission.name = path;
  auto compiled = compiler::compileText(path, std::move(text));
  if (!compiled) {
    return std::unexpected(compiled.error());
  }
  CHECK(compiled->checked, "a mission to fly has errors");
  mission.flown =
      std::make_shared<const compiler::Optimised>(compiler::optimise(compiled->checked));
  auto loaded = flights::loadHere(*mission.flown, {});
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  mission.loaded = std::make_shared<const codegen::LoadedMission>(std::move(*loaded));
  return mission;
}

support::Result<Seen> flyWatched(const FlyingMission& mission, const Conditions& conditions,
                                 const platforms::Platform& platform) {
  WorldWatch watch(platform, conditions);
  simulator::SimulationSetup setup;
  setup.platform = platform;
  setup.scenario = conditions.scenario;
  setup.seed = conditions.seed;
  setup.observer = &watch;
  const auto card = std::make_shared<flights::Card>();
  const bool keeps_time = !conditions.scenario.faults.empty();
  const auto start = [&] {
    return std::make_unique<InProcessSbc>(mission.loaded, conditions.parameters, card, keeps_time);
  };
  setup.sbc = std::make_unique<HearingSbc>(start(), watch);
  setup.restart_sbc = [&]() -> support::Result<std::unique_ptr<simulator::SbcPort>> {
    return start();
  };
  const auto trace = simulator::simulate(std::move(setup));
  if (!trace) {
    return std::unexpected(trace.error());
  }
  judgeDrift(*trace, conditions.scenario, platform, watch.world());
  Seen seen;
  seen.broken = watch.world().broken();
  for (const Rule rule : kAllRules) {
    seen.uses.at(static_cast<size_t>(rule)) = watch.world().use(rule);
  }
  seen.in_control_s = watch.inControl();
  seen.refused = watch.refused();
  return seen;
}

}  // namespace glider::tests
