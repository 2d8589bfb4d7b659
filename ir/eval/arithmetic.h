// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/truth.h"

#include <span>

/// The operations of ir/README.md on single values. A number is a double; NaN means unknown, and an
/// unknown result is `kUnknown`.
namespace glider::ir {

/// The only NaN that the interpreter makes: quiet, positive, without payload.
extern const double kUnknown;

/// Whether `value` is a number, decided by its bits.
bool isKnown(double value);

/// Settles an IEEE result: an infinity or NaN becomes unknown, a magnitude of 2^-1022 or less
/// (including minus zero) becomes +0.
double settle(double value);

/// Add, Subtract, Multiply, Divide, Min or Max.
double binary(Op op, double a, double b);
/// Negate, Abs or Sqrt.
double unary(Op op, double a);
/// An operation that the runtime's own code computes (OpGroup::Function), with as many numbers as
/// it takes.
double function(Op op, std::span<const double> operands);
/// Distance (m) or Bearing (rad).
double onEarth(Op op, Position from, Position to);
double clamp(double x, double lowest, double highest);
/// The value of the table with that number; unknown if there is none.
double element(const Table& table, double number);
/// Less, LessEqual, Greater, GreaterEqual, Equal or NotEqual.
Truth compare(Op op, double a, double b);

/// A sensor's value in SI units (positions: degrees) from what the vehicle reported, `age_s`
/// seconds ago.
double reading(const Sensor& sensor, double raw, double age_s);

}  // namespace glider::ir
