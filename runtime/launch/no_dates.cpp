// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// In place of dates.cpp in the program of a mission without a parameter that is a time of the
// calendar.

#include "runtime/launch/dates.h"

namespace glider::runtime {

bool readDate(const GliderParameterInfo& /*parameter*/, const Piece& /*text*/, double& /*value*/) {
  return false;
}

bool writeDate(const GliderParameterInfo& /*parameter*/, double /*value*/, Text& /*text*/) {
  return false;
}

bool putDateForm(const GliderParameterInfo& /*parameter*/, Text& /*text*/) {
  return false;
}

}  // namespace glider::runtime
