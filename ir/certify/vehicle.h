// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/expressions.h"

#include <span>

/// The rules V1 to V7 of the vehicle (docs/verification.md, "The rules of the vehicle") a second
/// time, without the prover's template. Five values of a vehicle: its depth, the deepest that the
/// command in force allows (|deepest|), whether that command is to climb (|climbing|), since when
/// (|climbing since|), and the depth at which a climb may stop (|top|). V7 is
/// Expressions::readingOf.
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
