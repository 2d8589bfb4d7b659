// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/behaviour.h"
#include "runtime/c/glider.h"
#include "runtime/c/program.h"

using glider::runtime::Limits;
using glider::runtime::Program;

namespace {

/// trackThermo extends this fraction of ddepth above and below the thermocline. It is less than
/// half because the two ends are commanded at different times, and an internal wave moves the
/// thermocline in between.
constexpr double kHalfWindow = 0.4;

GliderContext* context() {
  return &Program::instance().context();
}

void descend(double depth) {
  if (context()->vertical != kGliderDescend) {
    Program::instance().beginLeg();
  }
  gliderDescend(context(), depth, Program::instance().limits().dive);
}

void ascend(double depth) {
  if (context()->vertical != kGliderAscend) {
    Program::instance().beginLeg();
  }
  gliderAscend(context(), depth, Program::instance().limits().climb);
}

double within(double x, double low, double high) {
  return x < low ? low : high < x ? high : x;
}

}  // namespace

extern "C" void setDepths(double shallowest, double deepest) {
  Program::instance().limits().shallowest = shallowest;
  Program::instance().limits().deepest = deepest;
}

extern "C" void setPitches(double dive_pitch, double climb_pitch) {
  Program::instance().limits().dive = dive_pitch;
  Program::instance().limits().climb = climb_pitch;
}

extern "C" void dive(void) {
  descend(Program::instance().limits().deepest);
}

extern "C" void climb(void) {
  ascend(Program::instance().limits().shallowest);
}

extern "C" void diveTo(double depth) {
  descend(depth);
}

extern "C" void climbTo(double depth) {
  ascend(depth);
}

extern "C" void hoverAt(double depth) {
  gliderHover(context(), depth);
}

extern "C" void surface(void) {
  gliderSurface(context());
}

extern "C" void steer(double heading) {
  gliderSteer(context(), heading);
}

extern "C" void steerTo(double latitude, double longitude) {
  gliderSteerTo(context(), latitude, longitude);
}

extern "C" void drift(void) {
  gliderDriftFree(context());
}

extern "C" int thermoMet(const void* thermo) {
  const auto& wanted = *static_cast<const gliderThermo*>(thermo);
  const Program& program = Program::instance();
  const double difference = program.column().steepest(wanted.ddepth, program.legBegan()).difference;
  return difference > 0.0 && difference >= wanted.dtemp ? 1 : 0;
}

extern "C" int trackThermo(double* min, double* max, double dtemp, double ddepth) {
  Program& program = Program::instance();
  const glider::runtime::Stretch met = program.column().steepest(ddepth, program.legBegan());
  const glider::runtime::Crossing crossing =
      program.column().crossing(met.middle, program.legBegan());
  if (!(met.difference > 0.0 && met.difference >= dtemp) || !crossing.found) {
    return 0;
  }
  const double half = kHalfWindow * ddepth;
  const Limits& limits = program.limits();
  *min = within(crossing.depth - half, limits.shallowest, limits.deepest);
  *max = within(crossing.depth + half, limits.shallowest, limits.deepest);
  return 1;
}
