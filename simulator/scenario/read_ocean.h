// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/scenario/scenario.h"
#include "simulator/tables/scenario_tables.h"

namespace glider::simulator {

/// Reads [ocean] and its tables into `scenario`, whose start is known.
void readOcean(ScenarioTables& tables, Scenario& scenario);

}  // namespace glider::simulator
