// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/units/units.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

/// Options whose value is a number with a unit of the language.
namespace glider::driver {

/// The number in `text`, in SI units: with a unit of that dimension, as in 90min, 2day or 1.5 h; a
/// number alone is in SI units. Empty if it is not one, or negative.
std::optional<double> quantityIn(const std::string& text, support::Dimension dimension);

/// Adds an option whose value is a time from `least_s` to `most_s`.
CLI::Option* addDurationOption(CLI::App& command, const std::string& name,
                               std::optional<double>& value, double least_s, double most_s,
                               const std::string& description);

/// Adds an option whose value is a depth from `least_m` to `most_m`.
CLI::Option* addDepthOption(CLI::App& command, const std::string& name,
                            std::optional<double>& value, double least_m, double most_m,
                            const std::string& description);

/// Adds --duration to a command that flies in a scenario.
CLI::Option* addFlightDuration(CLI::App& command, std::optional<double>& value);

}  // namespace glider::driver
