// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/random_missions/random.h"

#include <string>

namespace glider::random_missions {

/// A random mission of few states whose cases do anything, most of them mistaken, in the text form
/// of the IR. Half of them call later states only, and so without a cycle. Guards are unknown,
/// `true`, `false`, or `(not (or true …))`, which is false.
std::string randomStructure(Random& random, bool with_always);

}  // namespace glider::random_missions
