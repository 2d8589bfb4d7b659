// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <cstdint>
#include <functional>
#include <string>

namespace glider::ir::prove {

/// The questions that the prover asks Spacer, as constrained Horn clauses in SMT-LIB 2 (logic HORN)
/// for any solver: one problem for each requirement about traces, divided by `(reset)`. `sat` means
/// that no trace violates the requirement; for `reach`, that none enters the state. `words(i)` is
/// the text of requirement number i in one line, for a comment. A requirement without such a
/// question, or with too many call stacks for it, has a comment only.
std::string chcText(const Mission& mission, const platforms::Platform& platform,
                    const std::function<std::string(uint32_t)>& words);

}  // namespace glider::ir::prove
