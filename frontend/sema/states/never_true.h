// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>

namespace glider::frontend {

/// A condition whose parts exclude each other: `depth < 10 m && depth > 30 m`.
struct NeverTrue {
  ir::SensorId sensor;  ///< what its parts are about
};

/// Whether comparisons of one sensor with constants in it, joined by `&&`, cannot all be true.
std::optional<NeverTrue> neverTrue(const ir::Mission& mission, ir::ExprId condition);

}  // namespace glider::frontend
