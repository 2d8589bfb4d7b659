// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "report/findings/findings.h"

#include <vector>

namespace glider::analysis {

/// What a mission shares, as its vehicle's modem has to send it: bytes of each message, slots, time
/// on air and energy; empty if it shares nothing.
std::vector<report::Budget> modemBudget(const compiler::Optimised& mission);

}  // namespace glider::analysis
