// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// In a file of its own: Program::open sees by its presence that the mission commands the fin.

#include "runtime/abi/behaviour.h"
#include "runtime/c/glider.h"
#include "runtime/c/program.h"

extern "C" void holdFin(double angle) {
  gliderFin(&glider::runtime::Program::instance().context(), angle);
}
