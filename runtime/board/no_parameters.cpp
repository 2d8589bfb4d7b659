// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// In place of launch/values.cpp, launch/positions.cpp and tell_parameters.cpp in the program of a
// mission without parameters, which so needs no reader of numbers and units.

#include "runtime/board/parameters.h"

namespace glider::runtime {

uint32_t Launch::find(const Piece& /*name*/) const {
  return kMostParameters;
}

/// Not reached: there is no parameter.
bool Launch::assign(uint32_t /*parameter*/, const Piece& /*name*/, const Piece& /*given*/) {
  return false;
}

/// Only parameters have conditions.
bool Launch::check() {
  return true;
}

void Launch::listNames(Text& /*text*/) const {}

void tellParameters(const GliderMission& /*mission*/) {}

}  // namespace glider::runtime
