// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/glider_abi.h"
#include "runtime/numbers/numbers.h"
#include "runtime/numbers/polynomial.h"

/// Salinity by the practical scale of 1978 and density by the equation of state of 1980: N. P.
/// Fofonoff and R. C. Millard, Algorithms for computation of fundamental properties of seawater,
/// UNESCO technical papers in marine science 44 (1983). Their temperatures are of IPTS-68.
namespace glider::runtime {
namespace {

constexpr double kConductivityOf35 = 4.2914;  // S/m, of salinity 35 at 15 degC and no pressure
constexpr double kTo68 = 1.00024;
constexpr double kPascalPerDecibar = 1e4;
constexpr double kColdest = -4.0;
constexpr double kWarmest = 45.0;
constexpr double kSaltiest = 45.0;
constexpr double kMostPressure = 1.2e8;  // Pa
constexpr double kLeastPressure = -1e5;  // a sensor's zero may be wrong by that much

bool isInside(double x, double lowest, double highest) {
  return x >= lowest && x <= highest;  // false for NaN
}

struct Water {
  double salinity;
  double degrees;  ///< IPTS-68
  double decibars;
};

/// The salinity of conductivity ratio `ratio` at that temperature and pressure.
double salinityOf(double ratio, double t, double p) {
  static constexpr double kPressure[] = {0.0, 2.070e-5, -6.370e-10, 3.989e-15};
  static constexpr double kTemperature[] = {1.0, 3.426e-2, 4.464e-4};
  static constexpr double kOf35[] = {0.6766097, 2.00564e-2, 1.104259e-4, -6.9698e-7, 1.0031e-9};
  static constexpr double kAt15[] = {0.0080, -0.1692, 25.3851, 14.0941, -7.0261, 2.7081};
  static constexpr double kBeside15[] = {0.0005, -0.0056, -0.0066, -0.0375, 0.0636, -0.0144};
  const double pressed = 1.0 + unrolled(kPressure, p) /
                                   (unrolled(kTemperature, t) + (4.215e-1 - 3.107e-3 * t) * ratio);
  const double root = __builtin_sqrt(ratio / (pressed * unrolled(kOf35, t)));
  const double beside = (t - 15.0) / (1.0 + 0.0162 * (t - 15.0));
  return unrolled(kAt15, root) + beside * unrolled(kBeside15, root);
}

/// False where the formulas are not defined, or an argument is unknown.
bool measure(double conductivity, double temperature, double pressure, Water& water) {
  if (!isInside(temperature, kColdest, kWarmest) || !isInside(conductivity, 0.0, 20.0) ||
      !isInside(pressure, kLeastPressure, kMostPressure)) {
    return false;
  }
  water.degrees = temperature * kTo68;
  water.decibars = pressure / kPascalPerDecibar;
  const double salinity =
      salinityOf(conductivity / kConductivityOf35, water.degrees, water.decibars);
  water.salinity = salinity < 0.0 ? 0.0 : salinity;  // of distilled water the sum is just below 0
  return isInside(salinity, -0.01, kSaltiest);
}

double densityOf(const Water& water) {
  static constexpr double kPure[] = {999.842594,  6.793952e-2,  -9.095290e-3,
                                     1.001685e-4, -1.120083e-6, 6.536332e-9};
  static constexpr double kSalt[] = {8.24493e-1, -4.0899e-3, 7.6438e-5, -8.2467e-7, 5.3875e-9};
  static constexpr double kSaltRoot[] = {-5.72466e-3, 1.0227e-4, -1.6546e-6};
  static constexpr double kBulk[] = {19652.21, 148.4206, -2.327105, 1.360477e-2, -5.155288e-5};
  static constexpr double kBulkSalt[] = {54.6746, -0.603459, 1.09987e-2, -6.1670e-5};
  static constexpr double kBulkRoot[] = {7.944e-2, 1.6483e-2, -5.3009e-4};
  static constexpr double kLinear[] = {3.239908, 1.43713e-3, 1.16092e-4, -5.77905e-7};
  static constexpr double kLinearSalt[] = {2.2838e-3, -1.0981e-5, -1.6078e-6};
  static constexpr double kSquare[] = {8.50935e-5, -6.12293e-6, 5.2787e-8};
  static constexpr double kSquareSalt[] = {-9.9348e-7, 2.0816e-8, 9.1697e-10};
  const double t = water.degrees;
  const double s = water.salinity;
  const double bars = water.decibars / 10.0;
  const double root = s * __builtin_sqrt(s);  // s^(3/2)
  const double surface = unrolled(kPure, t) + unrolled(kSalt, t) * s +
                         unrolled(kSaltRoot, t) * root + 4.8314e-4 * s * s;
  const double linear = unrolled(kLinear, t) + unrolled(kLinearSalt, t) * s + 1.91075e-4 * root;
  const double square = unrolled(kSquare, t) + unrolled(kSquareSalt, t) * s;
  const double bulk = unrolled(kBulk, t) + unrolled(kBulkSalt, t) * s +
                      unrolled(kBulkRoot, t) * root + (linear + square * bars) * bars;
  return surface / (1.0 - bars / bulk);
}

}  // namespace
}  // namespace glider::runtime

using namespace glider::runtime;

extern "C" double gliderSalinity(double conductivity, double temperature, double pressure) {
  Water water;
  return measure(conductivity, temperature, pressure, water) ? gliderSettle(water.salinity)
                                                             : unknown();
}

extern "C" double gliderDensity(double conductivity, double temperature, double pressure) {
  Water water;
  return measure(conductivity, temperature, pressure, water) ? gliderSettle(densityOf(water))
                                                             : unknown();
}
