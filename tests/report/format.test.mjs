// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How the report page writes numbers: src/format.ts by itself, without a browser.

import assert from "node:assert/strict";
import { test } from "node:test";
import { createRequire } from "node:module";

const page = new URL("../../report/page/", import.meta.url);
const { buildSync } = createRequire(new URL("build.mjs", page))("esbuild");
const bundled = buildSync({
  entryPoints: [new URL("src/format.ts", page).pathname], bundle: true, format: "esm", write: false,
});
const text = bundled.outputFiles[0].text;
const { digitsFor, fixed, quantity, utcMark, utcText } = await import(`data:text/javascript,${encodeURIComponent(text)}`);

test("an axis shows each of its steps without rounding", () => {
  const cases = [[1, 0], [2, 0], [10, 0], [250, 0], [2.5, 1], [0.5, 1], [0.2, 1], [0.25, 2], [0.1, 1], [0.025, 3], [0.001, 3]];
  for (const [step, digits] of cases) {
    assert.equal(digitsFor(step), digits, `step ${step}`);
  }
  assert.deepEqual([0, 2.5, 5, 7.5].map((v) => fixed(v, digitsFor(2.5))), ["0.0", "2.5", "5.0", "7.5"]);
});

test("the marks of a UTC axis are times, and dates at midnight", () => {
  const noon = Date.UTC(2019, 7, 9, 12) / 1000;
  assert.equal(utcText(noon + 59.9), "2019-08-09 12:00:59", "as the terminal shows it, which does not round");
  assert.equal(utcMark(noon + 61, 1), "12:01:01");
  assert.equal(utcMark(noon + 61, 60), "12:01");
  assert.equal(utcMark(noon + 43200, 3600), "08-10");
  assert.equal(utcMark(noon, 86400), "08-09");
});

test("a step that is none ends", () => {
  for (const step of [0, NaN, Infinity, 1 / 3]) {
    assert.ok(digitsFor(step) <= 9);
  }
});

test("what instruments measure has three significant digits", () => {
  const cases = [[0.0213199, "0.0213 µg/L"], [0.1 + 0.2, "0.300 µg/L"], [2.345678, "2.35 µg/L"], [1234.56, "1235 µg/L"], [0, "0 µg/L"],
    [-0.0123456, "−0.0123 µg/L"]];
  for (const [value, words] of cases) {
    assert.equal(quantity(value, "ug/l"), words);
  }
  assert.equal(quantity(234.5678, "uM"), "235 µmol/L");
  assert.equal(quantity(0.123456, "ntu"), "0.123 NTU");
  assert.equal(quantity(0.123456789, "unit"), "0.123457 unit", "others have six");
});
