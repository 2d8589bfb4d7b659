// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/json_document.h"
#include "report/plan/plan.h"

namespace glider::driver {

/// Adds the members of the document of `glidercc plan --format json`; docs/guide.md shows it.
void putPlan(Json& document, const report::Plan& plan);

}  // namespace glider::driver
