// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <string>

namespace glider::ir {

/// Whether a variable is one that a profile or route in another file, such as the library, keeps
/// for itself: its name says nothing to a pilot.
bool isInner(const Mission& mission, VariableId id);

/// What a variable is called in messages: as written, "routedone in fly", or for an inner variable
/// what it belongs to, "the flightroute of fly".
std::string pilotName(const Mission& mission, VariableId id);

}  // namespace glider::ir
