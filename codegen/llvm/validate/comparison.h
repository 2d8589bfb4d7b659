// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/validate/memory.h"
#include "codegen/validation.h"

#include <string>

namespace glider::codegen::validate {

/// Whether what a part of a mission means and what its code does are the same. `what` names it.
Validated compare(Effects& effects, const std::string& what, const Outcome& meant,
                  const Outcome& done);

}  // namespace glider::codegen::validate
