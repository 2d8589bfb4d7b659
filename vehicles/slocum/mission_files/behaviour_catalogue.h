// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <optional>
#include <span>
#include <string_view>

namespace glider::slocum {

/// One b_arg of a behaviour that glidercc knows.
struct KnownArgument {
  std::string_view name;
  std::string_view unit;
  double fallback;  ///< the vehicle's default
};

struct KnownBehaviour {
  std::string_view name;
  std::span<const KnownArgument> arguments;

  [[nodiscard]] const KnownArgument* find(std::string_view argument) const;
};

/// All rows of behaviours.def.
std::span<const KnownBehaviour> knownBehaviours();
/// The row of `name`; null if glidercc does not know the behaviour.
const KnownBehaviour* findBehaviour(std::string_view name);

/// Whether `name` is a known behaviour that moves the vehicle or watches over it; the others only
/// switch sensors.
bool drivesMotors(std::string_view name);

/// Whether `name` is probably a known behaviour, misspelled.
bool isNearlyABehaviour(std::string_view name);

/// Reports b_args that a known behaviour does not have (GL5104 for one that is probably misspelled,
/// else a warning, GL5116) and a heading that is missing (GL5106). Ignores unknown behaviours.
void checkArguments(const BehaviourBlock& block, support::DiagnosticEngine& diagnostics);

}  // namespace glider::slocum
