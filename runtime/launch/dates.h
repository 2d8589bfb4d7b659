// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/glider_abi.h"
#include "runtime/launch/quantity.h"
#include "runtime/log/format.h"

/// Parameters that are times of the calendar. On a board linked only with a mission that has one:
/// no_dates.cpp takes the place of dates.cpp otherwise.
namespace glider::runtime {

/// True if `parameter` is a time of the calendar.
inline bool isDate(const GliderParameterInfo& parameter) {
  Units units(parameter.units);
  return parameter.initial >= GLIDER_FIRST_DATE && units.next() && units.name().is("s");
}

/// Reads "2027-03-01T00:00Z" or "2027-03-01T00:00:30Z" into `value`, in seconds since 1970. False
/// if `parameter` is not a time of the calendar, or `text` is not written so.
bool readDate(const GliderParameterInfo& parameter, const Piece& text, double& value);
/// Writes `value` as readDate reads it. False, with nothing written, if `parameter` is not a time
/// of the calendar, or `value` is not in the years 1970 to 9999.
bool writeDate(const GliderParameterInfo& parameter, double value, Text& text);
/// Writes how a time of the calendar is written. False, with nothing written, if `parameter` is
/// none.
bool putDateForm(const GliderParameterInfo& parameter, Text& text);

}  // namespace glider::runtime
