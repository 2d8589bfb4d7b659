// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// In a file of its own: Program::open sees by its presence that the mission commands pump or
// battery.

#include "runtime/abi/behaviour.h"
#include "runtime/c/glider.h"
#include "runtime/c/program.h"

namespace {

constexpr double kCubicMetresPerCc = 1e-6;
constexpr double kMetresPerInch = 0.0254;

}  // namespace

extern "C" void setPump(double cc) {
  gliderPump(&glider::runtime::Program::instance().context(), cc * kCubicMetresPerCc);
}

extern "C" void setPitchBattery(double inches) {
  gliderBattery(&glider::runtime::Program::instance().context(), inches * kMetresPerInch);
}
