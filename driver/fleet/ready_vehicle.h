// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign.h"
#include "compiler/compilation.h"
#include "flights/fleet/fleet_file.h"
#include "flights/requirement_watch.h"
#include "simulator/fleet/fleet.h"
#include "simulator/ports/sbc_port.h"
#include "support/diagnostics/diagnostic.h"
#include "support/result.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::driver {

/// A vehicle of a fleet with its compiled mission and its scenario.
class ReadyVehicle {
 public:
  /// `slots`: in which the modems of the fleet take turns. `scenario`: with the place where it
  /// starts.
  ReadyVehicle(const flights::FleetVehicle& vehicle, uint32_t number, uint32_t slots,
               std::shared_ptr<const compiler::Optimised> mission, simulator::Scenario scenario);
  ReadyVehicle(const ReadyVehicle&) = delete;
  ReadyVehicle& operator=(const ReadyVehicle&) = delete;

  [[nodiscard]] const std::string& name() const { return vehicle_.name; }
  [[nodiscard]] std::string missionFile() const;
  [[nodiscard]] std::string platformName() const;
  /// What flies: its SBC starts in this process.
  support::Result<simulator::FleetMember> member();
  /// The same for a campaign, any number of times.
  [[nodiscard]] support::Result<campaign::FleetCampaignVehicle> forCampaign() const;
  /// It has flown in a campaign: with this its flight is checked.
  void hasFlown(campaign::FleetFlown::Vehicle flown);
  /// Adds to the trace of its flight what its mission says of it. Prints and returns what went
  /// wrong.
  std::vector<support::Diagnostic> judge(support::Trace& trace) const;

 private:
  flights::FleetVehicle vehicle_;
  uint32_t number_;
  uint32_t slots_;
  std::shared_ptr<const compiler::Optimised> mission_;
  simulator::Scenario scenario_;
  std::unique_ptr<flights::RequirementWatch> watch_;  ///< null: it cannot be watched
};

/// All of a fleet that flies.
struct ReadyFleet {
  simulator::Scenario world;
  uint64_t seed = 0;
  std::vector<std::unique_ptr<ReadyVehicle>> vehicles;
};

/// Compiles the missions of a fleet and reads its scenario for each vehicle; `only` is the one that
/// flies, empty: all. Errors in missions, with `strict` also warnings, are shown, and `status` is
/// then that of the command. Fails for what cannot be read, and with GL9303 for a vehicle that the
/// fleet does not have.
support::Result<ReadyFleet> readyFleet(const flights::Fleet& fleet, const std::string& only,
                                       int& status, bool strict = false);

}  // namespace glider::driver
