// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/random_proofs/conditions.h"

#include <string>

namespace glider::random_proofs {

/// Makes `requirement` a random pattern of the language (docs/promises.md), written as the frontend
/// does. Returns its name.
std::string writePattern(ir::Mission& mission, ir::Requirement& requirement, Conditions& conditions,
                         random_missions::Random& random);

}  // namespace glider::random_proofs
