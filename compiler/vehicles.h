// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "support/result.h"

#include <string>

namespace glider::compiler {

/// Loads the platform called `name`, as missions name it; GL9301 (with the names there are) if
/// share/glidercc/platforms has none, else as platforms::loadPlatform.
support::Result<platforms::Platform> loadVehicle(const std::string& name);

}  // namespace glider::compiler
