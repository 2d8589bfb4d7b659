// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace glider::frontend {

/// "135 deg": the angle from true north of a point of the compass, one of sixteen, in words or
/// letters: `southeast`, `south-east`, `SE`, `NNW`. Empty: it is none.
std::string compassAngle(std::string_view point);

}  // namespace glider::frontend
