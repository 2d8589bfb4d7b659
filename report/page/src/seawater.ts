// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** Salinity and density of sea water: PSS-78 and EOS-80, as in Fofonoff and Millard 1983 (Unesco technical papers in marine science 44). */

/** Of standard sea water at 35, 15 degrees and no pressure, S/m (Culkin and Smith 1980). */
const standardConductivity = 4.2914;

/** Temperatures are of ITS-90, the equations of IPTS-68. */
const toT68 = 1.00024;

/** The value at `x` of the polynomial with these coefficients, that of the power 0 first. */
const polynomial = (x: number, coefficients: number[]) => coefficients.reduceRight((sum, c) => sum * x + c, 0);

/** Practical salinity of a conductivity relative to the standard's, with temperatures of IPTS-68 and dbar. */
export function salinityOfRatio(ratio: number, t68: number, dbar: number): number {
  const pressure = 1 + (dbar * (2.07e-5 + dbar * (-6.37e-10 + dbar * 3.989e-15))) /
    (1 + 3.426e-2 * t68 + 4.464e-4 * t68 ** 2 + (4.215e-1 - 3.107e-3 * t68) * ratio);
  const temperature = polynomial(t68, [0.6766097, 2.00564e-2, 1.104259e-4, -6.9698e-7, 1.0031e-9]);
  const root = Math.sqrt(Math.max(ratio / (pressure * temperature), 0));
  const change = (t68 - 15) / (1 + 0.0162 * (t68 - 15));
  return polynomial(root, [0.008, -0.1692, 25.3851, 14.0941, -7.0261, 2.7081]) +
    change * polynomial(root, [0.0005, -0.0056, -0.0066, -0.0375, 0.0636, -0.0144]);
}

/** Practical salinity from conductivity in S/m, temperature in °C (ITS-90) and pressure in dbar. */
export function salinity(conductivity: number, temperature: number, dbar: number): number {
  return salinityOfRatio(conductivity / standardConductivity, temperature * toT68, dbar);
}

/** Density at the surface, kg/m3, with a temperature of IPTS-68. */
function surfaceDensity(s: number, t: number): number {
  return polynomial(t, [999.842594, 6.793952e-2, -9.09529e-3, 1.001685e-4, -1.120083e-6, 6.536332e-9]) +
    s * polynomial(t, [8.24493e-1, -4.0899e-3, 7.6438e-5, -8.2467e-7, 5.3875e-9]) +
    s ** 1.5 * polynomial(t, [-5.72466e-3, 1.0227e-4, -1.6546e-6]) + 4.8314e-4 * s * s;
}

/** In-situ density of EOS-80, kg/m3: practical salinity, temperature in °C of IPTS-68, pressure in bar. */
export function densityOfT68(s: number, t: number, bar: number): number {
  const root = s ** 1.5;
  const bulk = polynomial(t, [19652.21, 148.4206, -2.327105, 1.360477e-2, -5.155288e-5]) +
    s * polynomial(t, [54.6746, -0.603459, 1.09987e-2, -6.167e-5]) + root * polynomial(t, [7.944e-2, 1.6483e-2, -5.3009e-4]) +
    bar * (polynomial(t, [3.239908, 1.43713e-3, 1.16092e-4, -5.77905e-7]) + s * polynomial(t, [2.2838e-3, -1.0981e-5, -1.6078e-6]) + root * 1.91075e-4) +
    bar * bar * (polynomial(t, [8.50935e-5, -6.12293e-6, 5.2787e-8]) + s * polynomial(t, [-9.9348e-7, 2.0816e-8, 9.1697e-10]));
  return surfaceDensity(s, t) / (1 - bar / bulk);
}

/** sigma-t: the density at the surface less 1000 kg/m3; practical salinity, temperature in °C (ITS-90). */
export function sigmaT(s: number, temperature: number): number {
  return densityOfT68(s, temperature * toT68, 0) - 1000;
}
