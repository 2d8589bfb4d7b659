// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "platforms/load/platform.h"
#include "support/diagnostics/engine.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::vehicles {

/// What happens to the vehicle if the SBC fails or stops responding.
struct WayHome {
  double lets_go_s = 0;  ///< upper bound from the SBC's last frame until it loses control
  double depth_m = 0;    ///< upper bound of its depth at that time, by the mission's commands
  double surface_s = 0;  ///< upper bound from the SBC's last frame to the surface
  std::string source;    ///< of the time until it loses control: "silence_secs 24 from skeleton.mi"
  /// What the vehicle does when it loses control.
  std::string lets_go = "takes control";
};

/// What a vehicle flies by itself, beside the SBC and after it, as the checks of a mission see it:
/// from a file of the vehicle, or what is usual for its family.
class OwnMission {
 public:
  OwnMission() = default;
  OwnMission(const OwnMission&) = delete;
  OwnMission& operator=(const OwnMission&) = delete;
  virtual ~OwnMission() = default;

  /// Why a mission cannot be flown with it in a scenario of its own; empty: it can.
  [[nodiscard]] virtual std::string whyNotFlown() const { return ""; }
  /// Widens `platform` to what a vehicle may do that flies this, with a mission that goes on after
  /// an outage of its program of up to `outage_s`.
  virtual void widen(platforms::Platform& /*platform*/, double /*outage_s*/) const {}

  /// Raises the time after which it ends by itself to `seconds`, for a flight of that length, if it
  /// is sooner; returns what it was, empty if it was not.
  virtual std::optional<double> raiseOvertime(double /*seconds*/) { return std::nullopt; }

  /// Reports commands that the vehicle refuses (GL3124) and limits at which it ends the flight
  /// (GL3125).
  virtual void checkLimits(const ir::WrittenWorld& world,
                           support::DiagnosticEngine& diagnostics) const = 0;
  /// Reports what of it keeps the SBC's commands from flying.
  virtual void checkDisturbances(const ir::Worlds& worlds,
                                 support::DiagnosticEngine& diagnostics) const = 0;
  /// Reports the ways in which control ends after which the vehicle may stay below (GL3127).
  /// Returns lines for the report about the others.
  virtual std::vector<std::string> checkEndings(const ir::WidestWorld& world,
                                                support::DiagnosticEngine& diagnostics) const = 0;
  /// On what proofs rest with it, after all else has been reported: "with skeleton.mi, in water of
  /// 35 m or more".
  [[nodiscard]] virtual std::string premiseOf(
      const ir::WidestWorld& world, const support::DiagnosticEngine& diagnostics) const = 0;

  /// A line for the report if it ends a mission whose end is not proved.
  [[nodiscard]] virtual std::optional<std::string> endlessLine(
      const ir::WrittenWorld& world) const = 0;
  /// From a depth of at most `depth_m`, the deepest that commands of the mission lead to.
  [[nodiscard]] virtual WayHome wayHomeFrom(double depth_m,
                                            const ir::WrittenWorld& world) const = 0;
  /// Lines for the report: the way home of a mission, and of states where it is shorter.
  [[nodiscard]] virtual std::vector<std::string> wayHomeLines(
      const ir::WidestWorld& world) const = 0;
  /// Lines for the report about commands that are refused, of what is usual for a family: those of
  /// a file are errors (checkLimits).
  [[nodiscard]] virtual std::vector<std::string> refusedLines(const ir::Mission& mission) const = 0;
};

}  // namespace glider::vehicles
