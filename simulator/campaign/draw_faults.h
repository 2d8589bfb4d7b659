// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"

#include <cstdint>

namespace glider::simulator {

/// The kinds of faults that a campaign draws, in the order of its table.
enum class FaultKind : uint8_t {
#define FAULT_KIND(name, text) name,
#include "simulator/campaign/fault_kinds.def"
#undef FAULT_KIND
};

/// How many kinds there are.
inline constexpr uint32_t kFaultKinds = 0
#define FAULT_KIND(name, text) +1
#include "simulator/campaign/fault_kinds.def"
#undef FAULT_KIND
    ;

/// "byte loss".
const char* nameOf(FaultKind kind);

/// Draws what goes wrong in a flight: faults of kind `kind` somewhere within its `flight_s`
/// seconds. The same seed draws the same.
Faults drawFaults(FaultKind kind, uint64_t seed, double flight_s);

}  // namespace glider::simulator
