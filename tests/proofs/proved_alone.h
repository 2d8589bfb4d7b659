// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/requirements/strategy.h"

#include <string>

namespace glider::tests {

/// Whether `promise` about a mission, given without its first line, is proved by `strategy` without
/// the others, which would answer first.
bool isProvedAlone(const ir::prove::Strategy& strategy, const std::string& promise,
                   const std::string& mission);

/// A state; each case on a line of its own.
std::string stateOf(const std::string& name, const std::string& profile, const std::string& cases);

}  // namespace glider::tests
