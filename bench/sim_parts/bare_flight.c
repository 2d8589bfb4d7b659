/* SPDX-FileCopyrightText: 2026 The glidercc authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * bare_flight SECONDS - what bench/sim measures `glidercc sim` against: nothing but a glider's
 * motion, integrated in plain C with the step of the simulator, 0.25 s. A yo between 5 and 30 m by
 * pump, lagging pitch, lift and drag after Merckelbach et al. (2010), solved for the angle of
 * attack in each step. No sensors, no computers, no lines, no SBC, no report: far less work than a
 * simulated second of a mission is. Prints the depth it ends at. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double kStep = 0.25;                              /* s */
static const double kArea = 0.1, kDrag = 0.15, kInduced = 2.9; /* m2, 1, 1/rad2 */
static const double kLift = 6.0, kDensity = 1025.0, kGravity = 9.81;

/* Angle of attack at which lift and drag balance a glide at `pitch`, rad. */
static double angleOfAttack(double pitch) {
  double angle = 0;
  for (int i = 0; i < 20; ++i) {
    const double next = (kDrag + kInduced * angle * angle) / (kLift * tan(pitch + angle));
    if (fabs(next - angle) < 1e-6) {
      return next;
    }
    angle += 0.5 * (next - angle);
  }
  return angle;
}

int main(int argc, char** argv) {
  const double end = argc > 1 ? atof(argv[1]) : 3600;
  double depth = 0, pump = 230, wanted = -230, pitch = 0.4, ahead = 0, up = 0, x = 0;
  for (double now = 0; now < end; now += kStep) {
    wanted = depth > 30 ? 230 : depth < 5 ? -230 : wanted;
    pump += wanted > pump ? fmin(37.5 * kStep, wanted - pump) : fmax(-37.5 * kStep, wanted - pump);
    const double aim = pump > 0 ? 0.4538 : -0.4538;
    pitch += (aim - pitch) * (1 - exp(-kStep / 3));
    const double slope = fabs(pitch) > 0.1 ? pitch : copysign(0.1, pitch);
    const double angle = angleOfAttack(slope);
    const double path = slope + angle;
    const double buoyancy = kDensity * kGravity * pump * 1e-6;
    const double force =
        0.5 * kDensity * kArea *
        ((kDrag + kInduced * angle * angle) * fabs(sin(path)) + kLift * fabs(angle) * cos(path));
    const double speed = sqrt(fabs(buoyancy) / force);
    ahead += (speed * cos(path) - ahead) * (1 - exp(-kStep / 8));
    up += (copysign(speed * sin(fabs(path)), buoyancy) - up) * (1 - exp(-kStep / 8));
    x += ahead * kStep;
    depth = fmax(0, depth - up * kStep);
  }
  printf("%.3f %.3f\n", depth, x);
  return 0;
}
