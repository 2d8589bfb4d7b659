// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "support/result.h"
#include "vehicles/slocum/port_files/port_plan.h"

namespace glider::slocum {

/// What the files of the port say about a mission that was compiled. GL5131.
support::Result<PortPlan> planFor(const compiler::Optimised& mission, const PortChoice& choice);

}  // namespace glider::slocum
