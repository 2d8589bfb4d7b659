// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/validation.h"

#include <string>
#include <vector>

namespace glider::codegen {

/// Whether a linked program still holds the mission's functions and named constants as the objects
/// have them, bit by bit except for what linking fills in. `image` must have its symbols. Differs
/// names the first place.
Validated compareImage(const std::vector<std::string>& objects, const std::string& image);

}  // namespace glider::codegen
