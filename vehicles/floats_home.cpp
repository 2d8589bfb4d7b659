// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/floats_home.h"

#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/context/proof_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace glider::vehicles {
namespace {

class FloatsHome final : public OwnMission {
 public:
  explicit FloatsHome(Floats floats) : floats_(std::move(floats)) {}

  void checkLimits(const ir::WrittenWorld& /*world*/,
                   support::DiagnosticEngine& /*diagnostics*/) const override {}
  void checkDisturbances(const ir::Worlds& /*worlds*/,
                         support::DiagnosticEngine& /*diagnostics*/) const override {}
  std::vector<std::string> checkEndings(const ir::WidestWorld& /*world*/,
                                        support::DiagnosticEngine& /*diagnostics*/) const override {
    return {};
  }
  [[nodiscard]] std::string premiseOf(
      const ir::WidestWorld& /*world*/,
      const support::DiagnosticEngine& /*diagnostics*/) const override {
    return "";
  }
  [[nodiscard]] std::optional<std::string> endlessLine(
      const ir::WrittenWorld& /*world*/) const override {
    return std::nullopt;
  }
  [[nodiscard]] WayHome wayHomeFrom(double depth_m, const ir::WrittenWorld& world) const override {
    const platforms::Platform& platform = world.platform;
    const double lets_go_s = letsGoWithin(floats_.timeout_s, platform);
    return {lets_go_s, depth_m,
            lets_go_s + platform.world.turn_s + depth_m / platform.world.slowest_climb_m_s,
            fmt::format("{}, {:.4g} s", floats_.timeout, floats_.timeout_s), floats_.first};
  }
  [[nodiscard]] std::vector<std::string> wayHomeLines(const ir::WidestWorld& world) const override;
  [[nodiscard]] std::vector<std::string> refusedLines(
      const ir::Mission& /*mission*/) const override {
    return {};
  }

 private:
  Floats floats_;
};

std::vector<std::string> FloatsHome::wayHomeLines(const ir::WidestWorld& world) const {
  const auto depths = ir::prove::deepestByState(ir::prove::ProofContext(world));
  const WayHome home = wayHomeFrom(std::ranges::max(depths), {world.mission, world.platform});
  const std::string lets_go =
      fmt::format("if the SBC stops responding, the vehicle {} within {:.0f} s ({})", floats_.first,
                  home.lets_go_s, home.source);
  return {std::isfinite(home.depth_m)
              ? fmt::format("{}; from at most {:.4g} m deep, it floats to the surface within {}",
                            lets_go, home.depth_m, ir::prove::durationOf(home.surface_s))
              : lets_go + "; no bound on its depth is known"};
}

}  // namespace

double letsGoWithin(double timeout_s, const platforms::Platform& platform) {
  return timeout_s + platform.world.line_lag_s + platform.envelope.cycle_s;
}

simulator::FloatingPromise promiseOf(double timeout_s, const platforms::Platform& platform) {
  return {.greatest_depth_m = platform.envelope.greatest_depth_m,
          .overshoot_m = platform.envelope.inflection_overshoot_m,
          .lets_go_s = letsGoWithin(timeout_s, platform),
          .turn_s = platform.world.turn_s,
          .rises_m_s = platform.world.slowest_climb_m_s};
}

/// Faults of the SBC, of its line and of the vehicle's computer. Those of hooks, of a science
/// computer and of their line are none that this vehicle can have.
bool promisesOfFloating(simulator::FaultKind kind, const simulator::Scenario& /*scenario*/) {
  using simulator::FaultKind;
  constexpr FaultKind kPromised[] = {
      FaultKind::None,  FaultKind::ByteLoss,    FaultKind::BitFlips,      FaultKind::Bursts,
      FaultKind::Delay, FaultKind::HalfOpen,    FaultKind::LineCut,       FaultKind::Port,
      FaultKind::Power, FaultKind::Checkpoints, FaultKind::FlightRestart, FaultKind::ShallowWater};
  return std::ranges::find(kPromised, kind) != std::end(kPromised);
}

std::unique_ptr<OwnMission> floatsHome(const Floats& floats) {
  return std::make_unique<FloatsHome>(floats);
}

}  // namespace glider::vehicles
