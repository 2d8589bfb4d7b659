// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string>

namespace glider::driver {

/// Checks the certificates of a mission's requirements in `folder`, and prints a line for each;
/// returns the exit code: 1 if one is refused or missing. `own_mission`: the file of the vehicle's
/// own mission, which may make it obey later; empty: none.
int recheckCertificates(const std::string& mission, const std::filesystem::path& folder,
                        const std::string& own_mission);

}  // namespace glider::driver
