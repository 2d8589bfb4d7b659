// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <cstddef>

namespace glider::report {

/// Returns `trace` downsampled to about `most` rows: the first, the shallowest and the deepest row
/// of every stretch of equally many rows are kept. All turning points of the depth are also kept,
/// and the rows on both sides of a change of state, control or current, of a GPS fix, and of a gap
/// in the depth (these may exceed `most`). A trace of at most `most` rows is returned unchanged.
/// Events and field are always complete.
support::Trace downsampled(const support::Trace& trace, size_t most);

}  // namespace glider::report
