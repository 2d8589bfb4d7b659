// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/ground.h"

#include <optional>

namespace glider::ir::prove {

/// A mission time (s) by which every run has ended; none if none up to `latest` is found.
///
/// Every call stack that a run can have is looked at, with what its variables may hold, and the
/// latest time at which it can become current. A state is left for sure once a case of its own that
/// leads away must be true, by the clocks alone; and a tick comes within the world's greatest gap.
/// No solver: a mission that counts its legs, or stops at a chosen set of depths, is bounded here
/// where Spacer, which seeks an invariant over sums of times, gives up.
std::optional<double> endsBy(const Ground& ground, double latest);

}  // namespace glider::ir::prove
