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

/// The flightprofile or flightroute of the standard library that is meant by `surface_every` and
/// the like with so many arguments; empty: there is none.
std::string_view behaviourInsteadOf(std::string_view wish, size_t arguments);

/// Whether `wish` is the vehicle's behaviour `goto_list`, or a file of its waypoints, `goto_l10`.
bool namesWaypointList(std::string_view wish);

}  // namespace glider::frontend
