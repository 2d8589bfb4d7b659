// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <string>

namespace glider::ir {

/// The text form of `mission`, which must be valid: `read` turns it back into the same mission,
/// except for source ranges. The same mission gives the same text; doubles have the shortest form
/// that reads back exactly. Guards and arguments are s-expressions; one that is used more than
/// once, or is out of order, is named by a `let %n` before its use.
std::string print(const Mission& mission);

/// The text form of a type: "length", "latitude", "dim(1,0,-2,0,0,0)".
std::string typeText(Type type);

}  // namespace glider::ir
