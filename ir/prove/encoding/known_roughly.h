// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/tick.h"

#include <string>

namespace glider::ir::prove {

/// What of all that matters to a question over runs the solver knows less of than the machine does,
/// in words: "products, windows"; empty if it is nothing.
std::string knownRoughly(const Mission& mission, const ConeOfInfluence& relevance);

}  // namespace glider::ir::prove
