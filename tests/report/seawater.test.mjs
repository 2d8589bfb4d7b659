// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Salinity and density of the report page, src/seawater.ts, against published check values.

import assert from "node:assert/strict";
import { test } from "node:test";
import { createRequire } from "node:module";

const page = new URL("../../report/page/", import.meta.url);
const { buildSync } = createRequire(new URL("build.mjs", page))("esbuild");
const bundled = buildSync({
  entryPoints: [new URL("src/seawater.ts", page).pathname], bundle: true, format: "esm", write: false,
});
const text = bundled.outputFiles[0].text;
const { densityOfT68, salinity, salinityOfRatio, sigmaT } = await import(`data:text/javascript,${encodeURIComponent(text)}`);

const near = (actual, expected, tolerance, what) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual}, not ${expected}`);

test("salinity has the check values of Unesco 44 (Fofonoff and Millard 1983)", () => {
  for (const [ratio, t, dbar, expected] of [[1, 15, 0, 35], [1.2, 20, 2000, 37.245628], [0.65, 5, 1500, 27.995347]]) {
    near(salinityOfRatio(ratio, t, dbar), expected, 1e-6, `ratio ${ratio}`);
  }
});

test("density has the check values of Unesco 36 (1981), EOS-80", () => {
  const cases = [[0, 5, 0, 999.96675], [0, 5, 1000, 1044.12802], [0, 25, 0, 997.04796], [0, 25, 1000, 1037.90204],
    [35, 5, 0, 1027.67547], [35, 5, 1000, 1069.48914], [35, 25, 0, 1023.34306], [35, 25, 1000, 1062.53817]];
  for (const [s, t, bar, expected] of cases) near(densityOfT68(s, t, bar), expected, 5e-6, `S ${s}, T ${t}, p ${bar}`);
});

test("readings of a CTD, in ITS-90, give what python3-gsw 3.6.16 gives", () => {
  // Practical salinity, °C, dbar, S/m, and the density of EOS-80 at the surface.
  const cases = [[20, 5, 100, 2.014047328, 1015.807018], [30, 15, 20, 3.738417225, 1022.120858], [30, 20, 500, 4.19399153, 1020.952647],
    [32, 10, 0, 3.514237731, 1024.610269]];
  for (const [s, t, dbar, conductivity, surface] of cases) {
    near(salinity(conductivity, t, dbar), s, 2e-6, `salinity ${s} at ${t}`);
    near(sigmaT(s, t), surface - 1000, 1e-6, `sigma-t of ${s} at ${t}`);
  }
});
