// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace glider::driver {

/// The time in `text`, s: a number with a unit of time of the language, as in 90min, 2day or 1.5 h;
/// a number alone is in seconds. Empty if it is not one, or negative.
std::optional<double> secondsIn(const std::string& text);

/// Adds an option whose value is a time from `least_s` to `most_s`, written as secondsIn reads it.
CLI::Option* addDurationOption(CLI::App& command, const std::string& name,
                               std::optional<double>& value, double least_s, double most_s,
                               const std::string& description);

/// Adds --duration to a command that flies in a scenario.
CLI::Option* addFlightDuration(CLI::App& command, std::optional<double>& value);

}  // namespace glider::driver
