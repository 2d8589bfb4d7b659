// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace glider::report {

/// What `log` lacks of what SARIF 2.1.0 requires of the objects that we write: required members,
/// indices that fit, places from 1; empty if nothing.
std::vector<std::string> sarifFaults(const nlohmann::json& log);

}  // namespace glider::report
