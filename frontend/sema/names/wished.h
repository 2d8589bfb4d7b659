// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/spelling.h"
#include "platforms/load/platform.h"

#include <optional>
#include <string_view>

namespace glider::frontend {

/// What to write in place of a name that the language does not have, such as `now` or `east`; empty
/// if nothing takes its place on this platform.
std::optional<Suggestion> insteadOf(std::string_view wish, const platforms::Platform& platform);

}  // namespace glider::frontend
