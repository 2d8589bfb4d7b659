// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/check/check.h"
#include "driver/fleet/fleet_talk.h"
#include "driver/json_document.h"
#include "flights/fleet/fleet_file.h"
#include "ir/core/mission.h"
#include "support/result.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace glider::driver {

/// Whether two vehicles of a fleet are certain to keep their separation.
struct PairVerdict {
  std::string one, other;  ///< names of vehicles
  double apart_m = 0;      ///< a lower bound; 0: none is known
  bool proved = false;
  std::string reason;  ///< why it is not proved; empty if it is
};

/// The missions of a fleet, each checked once, and what follows for the fleet from what each alone
/// guarantees: no vehicle knows where another one is.
class FleetCheck {
 public:
  explicit FleetCheck(flights::Fleet fleet) : fleet_(std::move(fleet)) {}

  /// The files of its missions, each once.
  [[nodiscard]] std::vector<std::string> missions() const;
  /// Takes what was found about one of them.
  void take(const analysis::CheckedFile& checked);
  /// Once all were taken: whether the settings of each vehicle are allowed by its mission, and
  /// where each starts, and whether they can talk. GL9052, which names the vehicle, GL9304, and as
  /// flights::chooseScenario.
  support::Result<void> settle();
  /// All pairs of vehicles; empty if the fleet requires no separation.
  [[nodiscard]] std::vector<PairVerdict> pairs() const;
  /// Those as text, and a line about the fleet.
  [[nodiscard]] std::string text() const;
  /// The same as data.
  [[nodiscard]] Json json() const;

 private:
  /// What was found about a mission.
  struct Known {
    std::shared_ptr<const compiler::Checked> checked;  ///< null: it has errors
    std::vector<ir::Geofence> kept;                    ///< areas in which it is proved to stay
    double start_margin_m = 0;  ///< how far from their edges control must be given
    bool tried = false;         ///< it requires to stay in an area
  };

  [[nodiscard]] std::vector<Talking> talking() const;
  [[nodiscard]] std::string talkText() const;
  [[nodiscard]] PairVerdict judge(const flights::FleetVehicle& one,
                                  const flights::FleetVehicle& other) const;
  /// Why it is not certain that the vehicle stays in an area; empty: it is.
  [[nodiscard]] std::string doubtAbout(const flights::FleetVehicle& vehicle) const;
  [[nodiscard]] std::string doubtAboutStart(const flights::FleetVehicle& vehicle,
                                            const Known& known) const;
  [[nodiscard]] const Known* knownOf(const flights::FleetVehicle& vehicle) const;

  flights::Fleet fleet_;
  std::map<std::string, Known> known_;          ///< by the mission's path
  std::map<std::string, ir::Position> starts_;  ///< by the vehicle's name
};

}  // namespace glider::driver
