// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/profile_surfacing.h"

#include <string>

namespace glider::ir::prove {

/// What holds after every tick in a state whose profile comes to the surface by itself, as a
/// formula for certificates: it is in one of its modes. "true" for any other.
std::string inProfile(const Mission& mission, const ProfileSurfacing& profile);

/// What holds even while its state waits for a return: the times in its variables have come.
std::string timesOfProfile(const Mission& mission, const ProfileSurfacing& profile);

}  // namespace glider::ir::prove
