// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>

#include "support/trace/trace.h"

namespace glider::report {

/// `trace` with about `most` rows: of every stretch of equally many rows the first, the shallowest and the deepest
/// stay, so that no inflection is lost, and so do the rows on both sides of a change of state or of control (these
/// may exceed `most`). A trace of at most `most` rows comes back unchanged. Events and field are kept whole.
support::Trace thinned(const support::Trace& trace, size_t most);

}  // namespace glider::report
