// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/expressions.h"

#include <span>

/// The environment model of docs/verification.md as rules about five values of a vehicle: its
/// depth, the deepest that the command in force allows (|deepest|), whether that command is to
/// climb (|climbing|), since when (|climbing since|), and the depth at which a climb may stop
/// (|top|). o is `inflection_overshoot_m`.
///
/// - V1. At the start the depth is between 0 and `start_depth_m`, the deepest is o below it, and no
/// climb
///   is in force.
/// - V2. While time passes the vehicle stays between the surface and the deepest, and moves by at
/// most
///   `vertical_rate_m_s`. From `turn_s` after a command to climb, it is no deeper than the top, or
///   than a climb at `slowest_climb_m_s` from the deepest brings it.
/// - V3. To descend to or hover at x: the deepest is x + o, or what it was before, but no more than
/// o
///   below the present depth; the greater of the two.
/// - V4. To ascend to x: the top is x + o, or 0 for the surface (x below 1 m: x). A climb that is
/// already
///   in force, to a top that is no deeper, goes on. Otherwise it starts now, and the dive before
///   ends within o. A vehicle above the top may sink to it, unless it is at the surface.
/// - V5. A command with an unknown argument changes nothing, nor does one that steers.
/// - V6. A profile or route in C may command anything, so only the present depth is known to be
/// allowed.
/// - V7. A known reading of the depth is within `depth_error_m` of it (Expressions::readingOf).
namespace glider::ir::certify {

/// V1: a vehicle at the start.
Vehicle vehicleAtStart(const Setting& setting, SmtText& out);

/// V2: where the vehicle `before` may be when mission time has gone from `from` to `to`.
Vehicle vehicleLater(const Setting& setting, SmtText& out, const Vehicle& before, const Term& from,
                     const Term& to);

/// V3 to V5: after a command at time `now`.
Vehicle commanded(const Setting& setting, SmtText& out, const Vehicle& before, Command command,
                  std::span<const Number> arguments, const Term& now);

/// V6.
Vehicle commandedInC(SmtText& out, const Vehicle& before);

}  // namespace glider::ir::certify
