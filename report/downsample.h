// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <cstddef>

namespace glider::report {

/// `trace` with about `most` rows: of every stretch of equally many rows the first, the shallowest
/// and the deepest stay. All turning points of the depth stay too, and the rows on both sides of a
/// change of state or of control (these may exceed `most`). A trace of at most `most` rows comes
/// back unchanged. Events and field are kept whole.
support::Trace downsampled(const support::Trace& trace, size_t most);

}  // namespace glider::report
