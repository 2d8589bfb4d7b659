// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

namespace glider::ir::opt {

#define PASS(function, name, purpose) void function(Mission& mission);
#include "ir/opt/opt_passes.def"
#undef PASS

}  // namespace glider::ir::opt
