// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

/// What assumptions mean for proofs. Only worlds.h makes worlds of it.
namespace glider::ir {

/// The mission as proofs see it that rest on its assumptions:
/// - Range: the sensor's range is narrowed, so a known reading is in it;
/// - Outage: `resume_within_s` is at most the limit, which is that of each outage, not of all
/// together;
/// - Always: requirements of the kinds Always (without geofences) and ExitWithin, which then is one
///   of the kind Always too, are not violated once an assumption is broken, from that tick on.
/// Expressions, states and requirements keep their numbers. It is not what flies.
Mission underAssumptions(Mission mission);

/// The vehicle and the sea under the assumptions StartDepth and Current of `mission`. The start is
/// not above what a program can see by its readings. A current of
/// which the mission knows is set on top by the error of dead reckoning, and at the surface by wind
/// and waves.
platforms::Platform underAssumptions(platforms::Platform platform, const Mission& mission);

/// The same where `mission` assumes more of them than usual, and the usual where it assumes less:
/// what is proved about this rests on no assumption.
platforms::Platform notNarrowed(const platforms::Platform& platform, const Mission& mission);

/// Whether underAssumptions() lets `requirement` rest on the assumptions of the kind Always.
bool restsOnWatches(const Requirement& requirement);

}  // namespace glider::ir
