// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// In place of launch/values.cpp, launch/positions.cpp and tell_parameters.cpp in the program of a
// mission without parameters, which so needs no reader of numbers and units.

#include "runtime/board/parameters.h"

namespace glider::runtime {

bool Launch::assign(const Piece& name, const Piece& /*given*/) {
  return refuseUnknown(name);
}

void Launch::listNames(Text& /*text*/) const {}

void tellParameters(const GliderMission& /*mission*/) {}

}  // namespace glider::runtime
