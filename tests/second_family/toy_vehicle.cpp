// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/context/proof_context.h"
#include "support/diagnostics/ids/verification.h"
#include "support/files.h"
#include "vehicles/vehicle.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::vehicles {
namespace {

/// The rules of a toy: a file whose one number is the greatest depth to which it dives.
class ToyMission final : public OwnMission {
 public:
  explicit ToyMission(double deepest_m) : deepest_m_(deepest_m) {}

  void checkLimits(const ir::WrittenWorld& world,
                   support::DiagnosticEngine& diagnostics) const override {
    const auto depths = ir::prove::deepestByState(ir::prove::ProofContext(world));
    if (const double deepest = std::ranges::max(depths); deepest > deepest_m_) {
      diagnostics.report(support::diagnostics::vehicleRefuses, world.mission.states.front().range,
                         "this mission", fmt::format("a depth of {:.4g} m", deepest), "the toy",
                         fmt::format("more than {:.4g} m", deepest_m_), "the toy's file");
    }
  }
  void checkDisturbances(const ir::Worlds& /*worlds*/,
                         support::DiagnosticEngine& /*diagnostics*/) const override {}
  std::vector<std::string> checkEndings(const ir::WidestWorld& /*world*/,
                                        support::DiagnosticEngine& /*diagnostics*/) const override {
    return {"after control a toy comes up"};
  }
  [[nodiscard]] std::string premiseOf(
      const ir::WidestWorld& /*world*/,
      const support::DiagnosticEngine& /*diagnostics*/) const override {
    return "with a toy";
  }
  [[nodiscard]] std::optional<std::string> endlessLine(
      const ir::WrittenWorld& /*world*/) const override {
    return std::nullopt;
  }
  [[nodiscard]] WayHome wayHomeFrom(double depth_m, const ir::WrittenWorld& world) const override {
    return {0, depth_m, depth_m / world.platform.world.slowest_climb_m_s, "a toy"};
  }
  [[nodiscard]] std::vector<std::string> wayHomeLines(
      const ir::WidestWorld& /*world*/) const override {
    return {"if the SBC stops responding, a toy comes up within 24 s"};
  }
  [[nodiscard]] std::vector<std::string> refusedLines(
      const ir::Mission& /*mission*/) const override {
    return {};
  }

 private:
  double deepest_m_;
};

support::Result<std::unique_ptr<OwnMission>> readToyMission(
    const std::string& path, support::SourceManager& /*sources*/,
    const support::ShowDiagnostics& /*show*/) {
  const auto text = support::readFile(path);
  if (!text) {
    return std::unexpected(text.error());
  }
  return std::make_unique<ToyMission>(std::stod(*text));
}

/// A toy must be up at the end of its flight.
class ToyJudge final : public simulator::Judge {
 public:
  void said(std::span<const uint8_t> /*bytes*/, double /*now_s*/) override {}
  bool cycle(const simulator::CycleView& view) override {
    verdict_.end_s = view.time_s;
    verdict_.deepest_m = std::max(verdict_.deepest_m, view.true_depth_m);
    const bool flies = view.hook == hooks::HookState::Active;
    verdict_.take_s = flies && verdict_.take_s == 0 ? view.time_s : verdict_.take_s;
    const bool exits = view.hook == hooks::HookState::Complete;
    verdict_.release_s = exits && verdict_.release_s == 0 ? view.time_s : verdict_.release_s;
    depth_m_ = view.true_depth_m;
    return true;
  }
  [[nodiscard]] simulator::Verdict verdict() const override {
    simulator::Verdict verdict = verdict_;
    using Outcome = simulator::Verdict::Outcome;
    verdict.outcome = verdict.release_s > 0 ? Outcome::Exited : Outcome::Released;
    if (depth_m_ > 2) {
      verdict.outcome = Outcome::Violation;
      verdict.violation = "the toy is not up";
      verdict.violations.push_back({simulator::JudgeId::Ending, verdict.end_s, verdict.violation});
    }
    return verdict;
  }

 private:
  simulator::Verdict verdict_;
  double depth_m_ = 0;
};

}  // namespace

constinit const Vehicle families::toy = {
    .name = "toy",
    .flight_computer = "vehicle",
    .science_computer = "vehicle",
    .own_mission_ending = ".toy",
    .read_own_mission = readToyMission,
    .usual_own_mission = []() -> std::unique_ptr<OwnMission> {
      return std::make_unique<ToyMission>(1000);
    },
    .make_judge = [](const FlightToJudge& /*flight*/) -> std::unique_ptr<simulator::Judge> {
      return std::make_unique<ToyJudge>();
    },
    .promises = [](simulator::FaultKind /*kind*/,
                   const simulator::Scenario& /*scenario*/) { return true; }};

}  // namespace glider::vehicles
