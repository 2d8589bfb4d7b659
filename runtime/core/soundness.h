// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/glider_abi.h"
#include "runtime/log/records.h"

namespace glider::runtime {

/// The check that the context of a running mission does not pass between two ticks; Check::None if
/// it passes all.
Check brokenPart(const GliderContext& context, const GliderMission& mission);

}  // namespace glider::runtime
