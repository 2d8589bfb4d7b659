// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/worlds/worlds.h"

#include <cstdint>
#include <functional>
#include <string>

namespace glider::ir::prove {

/// The questions that the prover asks Spacer, as constrained Horn clauses in SMT-LIB 2 (logic HORN)
/// for any solver, under the mission's assumptions: one problem for each requirement about traces,
/// divided by `(reset)`. `sat` means that no trace violates the requirement; for `reach`, that none
/// enters the state. `words(i)` is the text of requirement number i in one line, for a comment. A
/// requirement without such a question, or with too many call stacks for it, has a comment only.
std::string chcText(const AssumedWorld& world, const std::function<std::string(uint32_t)>& words);

}  // namespace glider::ir::prove
