// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/lauv/usual_lauv.h"

#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/context/proof_context.h"
#include "runtime/imc/usual.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::lauv {
namespace {

using vehicles::WayHome;

/// The time-out begins with a Reference, and the last one may have been on its way.
class UsualLauv final : public vehicles::OwnMission {
 public:
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
  [[nodiscard]] WayHome wayHomeFrom(double depth_m,
                                    const platforms::Platform& platform) const override {
    const double lets_go_s = letsGoWithin(platform);
    return {lets_go_s, depth_m,
            lets_go_s + platform.world.turn_s + depth_m / platform.world.slowest_climb_m_s,
            fmt::format("the time-out of the plan, {:.4g} s", runtime::imc::kTimeoutSecs)};
  }
  [[nodiscard]] std::vector<std::string> wayHomeLines(const ir::WidestWorld& world) const override;
  [[nodiscard]] std::vector<std::string> refusedLines(
      const ir::Mission& /*mission*/) const override {
    return {};
  }
};

std::vector<std::string> UsualLauv::wayHomeLines(const ir::WidestWorld& world) const {
  const auto depths = ir::prove::deepestByState(ir::prove::ProofContext(world));
  const WayHome home = wayHomeFrom(std::ranges::max(depths), world.platform);
  const std::string lets_go = fmt::format(
      "if the SBC stops responding, the vehicle stops its propeller within {:.0f} s ({})",
      home.lets_go_s, home.source);
  return {std::isfinite(home.depth_m)
              ? fmt::format("{}; from at most {:.4g} m deep, it floats to the surface within {}",
                            lets_go, home.depth_m, ir::prove::durationOf(home.surface_s))
              : lets_go + "; no bound on its depth is known"};
}

}  // namespace

double letsGoWithin(const platforms::Platform& platform) {
  return runtime::imc::kTimeoutSecs + platform.world.line_lag_s + platform.envelope.cycle_s;
}

std::unique_ptr<vehicles::OwnMission> usualLauv() {
  return std::make_unique<UsualLauv>();
}

}  // namespace glider::lauv
