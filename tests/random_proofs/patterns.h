// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/random_proofs/conditions.h"

#include <cstdint>
#include <span>

namespace glider::random_proofs {

/// The patterns: "visit", "patrol", "count", "never", "reaction", "hold", "climb".
std::span<const char* const> patterns();

/// Makes `requirement` a random one of the pattern with this number of the language
/// (docs/promises.md), written as the frontend does.
void writePattern(uint32_t pattern, ir::Mission& mission, ir::Requirement& requirement,
                  Conditions& conditions, random_missions::Random& random);

}  // namespace glider::random_proofs
