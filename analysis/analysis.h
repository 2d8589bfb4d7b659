// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/closed_loop.h"
#include "analysis/graph_of.h"
#include "analysis/mission_budget.h"
#include "analysis/replay.h"
#include "analysis/way_home.h"

/// What can be said of a mission beyond its errors, each as a plain function of a compiled mission:
/// what it needs of each board (missionBudgets), how the vehicle comes home without the SBC
/// (wayHomeLines), a simulated flight that violates what it requires (searchClosedLoop), a found
/// flight flown again tick by tick (replayRun), and its graph (graphOf). Nothing here prints;
/// others include this header and no other of the folder.
