// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/possible.h"

#include <optional>

namespace glider::ir::prove {

/// The latest mission time (s) at which a tick leaves `state`, by a case of its own that must be
/// true by then whatever the sensors say, if it became current at `since` at the latest and its
/// variables are within `values` all the while. None if nothing makes it go.
std::optional<double> leftBy(const Ground& ground, const State& state, const Valuation& values,
                             double since);

}  // namespace glider::ir::prove
