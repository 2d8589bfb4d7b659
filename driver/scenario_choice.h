// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/scenario/scenario.h"
#include "support/result.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace glider::driver {

/// The scenarios that come with glidercc, by name.
std::vector<std::string> scenarioNames();

/// Loads the scenario that --scenario names: a .toml file, or one that comes with glidercc. Its
/// mistakes are shown as a mission's are. GL9302, and as simulator::loadScenario.
support::Result<simulator::Scenario> chooseScenario(const std::string& wanted);

/// For --seed: a whole number of 64 bits without a sign; CLI11 alone would wrap `-1` round.
CLI::Validator seedValidator();

}  // namespace glider::driver
