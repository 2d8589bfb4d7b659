// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/against/against_logs.h"
#include "analysis/brief/brief_of.h"
#include "analysis/certificates/recheck.h"
#include "analysis/closed_loop.h"
#include "analysis/coverage.h"
#include "analysis/difference/compare_bounds.h"
#include "analysis/difference/compare_missions.h"
#include "analysis/difference/parting.h"
#include "analysis/graph_of.h"
#include "analysis/mission_budget.h"
#include "analysis/parameter_rows.h"
#include "analysis/refused_commands.h"
#include "analysis/replay.h"
#include "analysis/trace_of_run.h"
#include "analysis/trial_flight.h"
#include "analysis/vehicle_file.h"
#include "analysis/vehicle_guards.h"
#include "analysis/vehicle_limits.h"
#include "analysis/vehicle_premise.h"
#include "analysis/way_home.h"
#include "analysis/whole/control.h"
#include "analysis/whole/hookbeh_needs.h"
#include "analysis/whole/whole.h"

/// Analyses of a mission beyond its errors, each a plain function of a compiled mission: its budget
/// on each board (missionBudgets), how the vehicle comes home without the SBC (wayHomeLines, and
/// with the vehicle's mission file wholeOf), which of its commands hookbeh refuses (refusedLines),
/// what a vehicle's own mission file does not allow (checkVehicleLimits, checkGuards,
/// checkSameDepth, checkStart), what in it keeps hookbeh from flying (disturbances, unmetNeeds),
/// what goes wrong in a flight in a scenario (reportTrialFlight), a simulated flight that violates
/// a requirement (searchClosedLoop), what no requirement depends on (coverageOf), the replay of a
/// counterexample tick by tick (replayRun), a second check of the certificates of proofs (recheck),
/// what it would have done with the readings of a vehicle's data files (runAgainstLogs), its graph
/// (graphOf), its parameters (parameterRows), all of this for the crew (briefOf), and what differs
/// between two versions of it (compareMissions, compareBounds, searchParting). Nothing here prints.
/// Other folders include only this header.
