// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/slocum_mission.h"

#include "support/diagnostics/ids/verification.h"
#include "vehicles/slocum/mission_files/load.h"
#include "vehicles/slocum/rules/control.h"
#include "vehicles/slocum/rules/hookbeh_needs.h"
#include "vehicles/slocum/rules/port/port_file.h"
#include "vehicles/slocum/rules/port/port_mission.h"
#include "vehicles/slocum/rules/refused_commands.h"
#include "vehicles/slocum/rules/untickled.h"
#include "vehicles/slocum/rules/vehicle_file.h"
#include "vehicles/slocum/rules/vehicle_guards.h"
#include "vehicles/slocum/rules/vehicle_limits.h"
#include "vehicles/slocum/rules/vehicle_premise.h"
#include "vehicles/slocum/rules/way_home.h"
#include "vehicles/slocum/rules/whole.h"

#include <algorithm>
#include <utility>

namespace glider::slocum::rules {
namespace {

using ir::WidestWorld;
using ir::WrittenWorld;
using platforms::Platform;
using support::DiagnosticEngine;

class FileOfSlocum final : public vehicles::OwnMission {
 public:
  FileOfSlocum(VehicleFile file, MissionFile behaviours)
      : file_(std::move(file)), behaviours_(std::move(behaviours)) {}

  std::optional<double> raiseOvertime(double seconds) override {
    const auto before = slocum::raiseOvertime(behaviours_, seconds);
    if (before) {
      file_.aborts.overtime_s = seconds;
    }
    return before;
  }

  void checkLimits(const WrittenWorld& world, DiagnosticEngine& diagnostics) const override {
    checkVehicleLimits(world, file_, diagnostics);
  }

  void checkDisturbances(const ir::Worlds& worlds, DiagnosticEngine& diagnostics) const override {
    const Platform& platform = worlds.widest.platform;
    const auto layers = layersOf(behaviours_, platform);
    checkGuards(worlds.written, file_, layers, diagnostics);
    checkSameDepth(worlds.written, file_, diagnostics);
    checkUntickled(worlds.written, file_, layers, diagnostics);
    const MissionTimes times(worlds.widest, std::max(0.0, file_.guards.start_secs));
    for (const Disturbance& one : disturbances(behaviours_, layers, times, platform)) {
      const bool masks = one.kind == Disturbance::Kind::Masks;
      diagnostics.report(
          masks ? support::diagnostics::commandsMasked : support::diagnostics::controlPrevented,
          one.range, one.what, one.change);
    }
    const auto hookbeh = std::ranges::find(layers, Role::Hookbeh, &Layer::role);
    checkNaps(worlds.written.mission, file_, hookbeh->range, diagnostics);
    for (const Doubt& one : unmetNeeds(behaviours_)) {
      diagnostics.report(support::diagnostics::sensorUnread, one.range, one.why, one.change);
    }
  }

  std::vector<std::string> checkEndings(const WidestWorld& world,
                                        DiagnosticEngine& diagnostics) const override {
    const Whole whole = wholeOf(world, behaviours_);
    reportEndings(whole, diagnostics);
    return wholeLines(whole);
  }

  [[nodiscard]] std::string premiseOf(const WidestWorld& world,
                                      const DiagnosticEngine& diagnostics) const override {
    return premiseWith(world, file_, diagnostics);
  }

  [[nodiscard]] std::optional<std::string> endlessLine(const WrittenWorld& world) const override {
    return rules::endlessLine(world, file_);
  }

  [[nodiscard]] vehicles::WayHome wayHomeFrom(double depth_m,
                                              const WrittenWorld& world) const override {
    return rules::wayHomeFrom(depth_m, world.platform, silenceOf(file_, world.mission));
  }

  [[nodiscard]] std::vector<std::string> wayHomeLines(const WidestWorld& world) const override {
    return rules::wayHomeLines(world, silenceOf(file_, world.mission));
  }

  [[nodiscard]] std::vector<std::string> refusedLines(
      const ir::Mission& /*mission*/) const override {
    return {};
  }

 private:
  VehicleFile file_;
  MissionFile behaviours_;  ///< its ranges are in the sources that it was read into
};

class UsualSlocum final : public vehicles::OwnMission {
 public:
  void checkLimits(const WrittenWorld& /*world*/,
                   DiagnosticEngine& /*diagnostics*/) const override {}
  void checkDisturbances(const ir::Worlds& /*worlds*/,
                         DiagnosticEngine& /*diagnostics*/) const override {}
  std::vector<std::string> checkEndings(const WidestWorld& /*world*/,
                                        DiagnosticEngine& /*diagnostics*/) const override {
    return {};
  }
  [[nodiscard]] std::string premiseOf(const WidestWorld& /*world*/,
                                      const DiagnosticEngine& /*diagnostics*/) const override {
    return "";
  }
  [[nodiscard]] std::optional<std::string> endlessLine(
      const WrittenWorld& /*world*/) const override {
    return std::nullopt;
  }
  [[nodiscard]] vehicles::WayHome wayHomeFrom(double depth_m,
                                              const WrittenWorld& world) const override {
    return rules::wayHomeFrom(depth_m, world.platform, usualSilence(world.mission));
  }
  [[nodiscard]] std::vector<std::string> wayHomeLines(const WidestWorld& world) const override {
    return rules::wayHomeLines(world, usualSilence(world.mission));
  }
  [[nodiscard]] std::vector<std::string> refusedLines(const ir::Mission& mission) const override {
    std::vector<std::string> lines = rules::refusedLines(mission, usualLimits());
    if (auto line = rules::deeperThanBundledLine(mission)) {
      lines.push_back(std::move(*line));
    }
    return lines;
  }
};

}  // namespace

support::Result<std::unique_ptr<vehicles::OwnMission>> readSlocumMission(
    const std::string& path, support::SourceManager& sources,
    const support::ShowDiagnostics& show) {
  DiagnosticEngine diagnostics;
  auto behaviours = loadMission(path, sources, diagnostics, [](auto&&...) {});
  if (!behaviours) {
    if (show && diagnostics.hasErrors()) {
      show(diagnostics, sources);
    }
    return std::unexpected(behaviours.error());
  }
  if (isPortFile(*behaviours)) {
    return portMission(std::move(*behaviours), path);
  }
  auto file = vehicleFileOf(*behaviours, path);
  if (!file) {
    return std::unexpected(file.error());
  }
  return std::make_unique<FileOfSlocum>(std::move(*file), std::move(*behaviours));
}

std::unique_ptr<vehicles::OwnMission> usualSlocumMission() {
  return std::make_unique<UsualSlocum>();
}

}  // namespace glider::slocum::rules
