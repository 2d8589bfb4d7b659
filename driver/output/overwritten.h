// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string>
#include <vector>

namespace glider::driver {

/// The first of `inputs` that one of `outputs` would overwrite. Empty names are left out; a file
/// that does not exist yet is not an input.
std::optional<std::string> overwrittenInput(const std::vector<std::string>& inputs,
                                            const std::vector<std::string>& outputs);

}  // namespace glider::driver
