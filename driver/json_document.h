// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <functional>
#include <string>

// --format json of the commands that print data: one document, also if the command fails.

namespace glider::driver {

using Json = nlohmann::ordered_json;

/// Adds `--format text|json` to `command`.
void addFormatOption(CLI::App& command, bool& json);

/// Runs `work` and returns its exit code. Without `json` it is given null, and prints. With it,
/// what is reported meanwhile is kept, and printed in a document with the members that `work` has
/// added:
///   {"glidercc": "0.1.0", "command": "sim", "status": 0, "diagnostics": [], …}
int inFormat(bool json, const std::string& command, const std::function<int(Json*)>& work);

/// Prints the document of a command line that is wrong, with one error.
void printUsageError(const std::string& command, const std::string& message,
                     const std::string& hint);

/// `value`, or null if it is not a number.
Json numberOrNull(double value);

}  // namespace glider::driver
