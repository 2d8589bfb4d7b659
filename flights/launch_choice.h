// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/load/loaded_mission.h"
#include "compiler/compilation.h"
#include "support/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glider::flights {

/// Which vehicle of a fleet it is: the address of its acoustic modem, and how many take turns.
struct Turn {
  uint32_t address = 1;  ///< 1..vehicles
  uint32_t vehicles = 1;
};

/// What the pilot gives a program when it is launched.
struct LaunchChoice {
  std::vector<std::string> settings;  ///< of --set, "name=value"
  std::string file;                   ///< of --parameters; empty: none
  std::optional<Turn> turn = {};      ///< empty: it does not use its modem

  [[nodiscard]] bool empty() const { return settings.empty() && file.empty(); }
};

/// The value of each parameter, SI units or degrees: the defaults, then the file's, then those of
/// --set. GL9052 for what the mission does not allow, and as support::readFile.
support::Result<std::vector<double>> chooseParameters(const ir::Mission& mission,
                                                      const LaunchChoice& choice);

/// The mission, compiled for this process and loaded, with the code that `user_code` has for it.
support::Result<codegen::LoadedMission> loadHere(const compiler::Optimised& mission,
                                                 const std::vector<std::string>& user_code);

}  // namespace glider::flights
