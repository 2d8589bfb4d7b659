// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/ocean/seawater.h"

#include <algorithm>
#include <array>
#include <cmath>

// The practical salinity scale of 1978, from N. P. Fofonoff and R. C. Millard, Algorithms for
// computation of fundamental properties of seawater, UNESCO technical papers in marine science 44
// (1983). The runtime's salinity is a second implementation, in the other direction.
namespace glider::simulator {
namespace {

constexpr double kOf35 = 4.2914;   // S/m, of salinity 35 at 15 degC and no pressure
constexpr double kTo68 = 1.00024;  // from ITS-90 to IPTS-68

struct SalinityAt {
  double value = 0, slope = 0;
};

/// The salinity of water of which `root` squared is R_t, and how it grows with `root`.
SalinityAt salinityOfRoot(double root, double t68) {
  constexpr std::array<double, 6> kA = {0.0080, -0.1692, 25.3851, 14.0941, -7.0261, 2.7081};
  constexpr std::array<double, 6> kB = {0.0005, -0.0056, -0.0066, -0.0375, 0.0636, -0.0144};
  const double from_15 = t68 - 15;
  const double scale = from_15 / (1 + 0.0162 * from_15);
  SalinityAt sum;
  for (size_t i = kA.size(); i-- > 0;) {
    sum.slope = sum.slope * root + sum.value;
    sum.value = sum.value * root + kA[i] + scale * kB[i];
  }
  return sum;
}

/// R_t of a salinity: the conductivity relative to that of 35 at the same temperature and no
/// pressure, by Newton's method.
double ratioAtTemperature(double salinity, double t68) {
  constexpr double kFreshest = 0.006;  // below it the polynomial does not rise everywhere
  double root = std::max(std::sqrt(salinity / 35), kFreshest);
  constexpr int kSteps = 20;
  for (int i = 0; i < kSteps; ++i) {
    const SalinityAt s = salinityOfRoot(root, t68);
    const double step = (salinity - s.value) / s.slope;
    root = std::max(root + step, kFreshest);
  }
  return root * root;
}

/// r_t: how the conductivity of salinity 35 changes with temperature.
double of35(double t68) {
  return 0.6766097 +
         t68 * (2.00564e-2 + t68 * (1.104259e-4 + t68 * (-6.9698e-7 + t68 * 1.0031e-9)));
}

}  // namespace

double conductivityOf(double salinity, double temperature_degC, double dbar) {
  const double t68 = temperature_degC * kTo68;
  const double unpressed = of35(t68) * ratioAtTemperature(salinity, t68);
  // R = unpressed * R_p, and R_p = 1 + c / (b + a R): a quadratic equation for R.
  const double a = 0.4215 - 3.107e-3 * t68;
  const double b = 1 + t68 * (3.426e-2 + t68 * 4.464e-4);
  const double c = dbar * (2.070e-5 + dbar * (-6.370e-10 + dbar * 3.989e-15));
  const double half = (b - unpressed * a) / 2;
  const double ratio = (std::sqrt(half * half + a * unpressed * (b + c)) - half) / a;
  return ratio * kOf35;
}

}  // namespace glider::simulator
