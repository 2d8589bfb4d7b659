// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/validation.h"
#include "support/result.h"

#include <string>

namespace glider::driver {

/// Shows how the code for `target` compares with the mission. Fails with GL4018 if a part differs,
/// and with `strict` (GL4019) also if one could not be compared; otherwise that is a warning.
support::Result<void> reportValidation(const codegen::Validation& validation,
                                       const std::string& target, bool strict);

}  // namespace glider::driver
