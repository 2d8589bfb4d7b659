// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/port/port_mission.h"

#include "ir/prove/context/duration_text.h"
#include "support/diagnostics/ids/verification.h"
#include "vehicles/slocum/rules/port/port_doubts.h"
#include "vehicles/slocum/rules/port/port_file.h"
#include "vehicles/slocum/rules/port/port_masks.h"
#include "vehicles/slocum/rules/port/port_whole.h"
#include "vehicles/slocum/rules/port_commands.h"
#include "vehicles/slocum/rules/untickled.h"
#include "vehicles/slocum/rules/vehicle_limits.h"
#include "vehicles/slocum/rules/vehicle_premise.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace glider::slocum::rules {
namespace {

using platforms::Platform;
using support::DiagnosticEngine;

class PortOfSlocum final : public vehicles::OwnMission {
 public:
  PortOfSlocum(MissionFile behaviours, std::string path)
      : behaviours_(std::move(behaviours)), path_(std::move(path)) {}

  [[nodiscard]] std::string whyNotFlown() const override {
    return "in it the vehicle is steered by its port, not by hookbeh: `glidercc sim FOLDER` flies "
           "the folder that it belongs to";
  }
  void widen(Platform& platform, double outage_s) const override {
    widenForPort(platform, outage_s);
  }

  std::optional<double> raiseOvertime(double seconds) override {
    return slocum::raiseOvertime(behaviours_, seconds);
  }

  void checkLimits(const ir::WrittenWorld& world, DiagnosticEngine& diagnostics) const override {
    checkPortCommands(world.mission, diagnostics);
    checkVehicleLimits(world, fileOn(world.platform), diagnostics);
  }

  void checkDisturbances(const ir::Worlds& worlds, DiagnosticEngine& diagnostics) const override {
    const Platform& platform = worlds.widest.platform;
    const PortFile port = portOn(platform);
    for (const Disturbance& one : portDoubts(behaviours_, port, platform)) {
      diagnostics.report(support::diagnostics::controlPrevented, one.range, one.what, one.change);
    }
    for (const Disturbance& one : portMasks(behaviours_, port)) {
      diagnostics.report(support::diagnostics::commandsMasked, one.range, one.what, one.change);
    }
    checkUntickled(worlds.written, fileOn(platform), layersOf(behaviours_, platform), diagnostics);
  }

  std::vector<std::string> checkEndings(const ir::WidestWorld& world,
                                        DiagnosticEngine& diagnostics) const override {
    const Whole whole = wholeOn(world.platform);
    reportEndings(whole, diagnostics);
    return wholeLines(whole);
  }

  [[nodiscard]] std::string premiseOf(const ir::WidestWorld& world,
                                      const DiagnosticEngine& diagnostics) const override {
    return fmt::format("with {} by the port, which obeys within {}{}", fileOn(world.platform).name,
                       ir::prove::durationOf(world.platform.world.command_delay_s),
                       onlyWhile("the SBC's commands fly", diagnostics));
  }

  [[nodiscard]] std::optional<std::string> endlessLine(
      const ir::WrittenWorld& world) const override {
    return rules::endlessLine(world, fileOn(world.platform));
  }

  /// The depth of the mission says little: what brings the vehicle up must also do so after a
  /// damaged sentence.
  [[nodiscard]] vehicles::WayHome wayHomeFrom(double /*depth_m*/,
                                              const ir::WrittenWorld& world) const override {
    const Platform& platform = world.platform;
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    const Ending silence = wholeOn(platform).endings.front();
    return {silence.proved() ? silence.parts.front().seconds : kUnknown, portOn(platform).deepest_m,
            silence.proved() ? silence.seconds() : kUnknown,
            fmt::format("{} in {}", silence.by, fileOn(platform).name)};
  }

  [[nodiscard]] std::vector<std::string> wayHomeLines(const ir::WidestWorld& world) const override {
    return missingGuards(fileOn(world.platform));
  }

  [[nodiscard]] std::vector<std::string> refusedLines(
      const ir::Mission& /*mission*/) const override {
    return {};
  }

 private:
  [[nodiscard]] VehicleFile fileOn(const Platform& platform) const {
    return portVehicleFile(behaviours_, path_, platform);
  }
  [[nodiscard]] PortFile portOn(const Platform& platform) const {
    return portFileOf(behaviours_, platform);
  }
  [[nodiscard]] Whole wholeOn(const Platform& platform) const {
    return portWhole(behaviours_, portOn(platform), platform);
  }

  MissionFile behaviours_;  ///< its ranges are in the sources that it was read into
  std::string path_;
};

}  // namespace

std::unique_ptr<vehicles::OwnMission> portMission(MissionFile file, std::string path) {
  return std::make_unique<PortOfSlocum>(std::move(file), std::move(path));
}

}  // namespace glider::slocum::rules
