// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

namespace glider::platforms {

/// The platform of a mission, or of a command, that names none.
inline constexpr std::string_view kDefaultPlatform = "slocum";

}  // namespace glider::platforms
