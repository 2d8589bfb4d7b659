// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>
#include <string>

namespace glider::ir {

/// "bool", "latitude", "longitude", "number", or the dimension's name as in "temperature"; none of
/// a dimension without a name.
std::optional<std::string> typeName(const Type& type);

}  // namespace glider::ir
