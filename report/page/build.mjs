// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Bundles the page into one HTML text and writes it as a C++ source: `node build.mjs OUT.cpp`.
// The text is cut at @@TITLE@@ and @@FLIGHT@@, where report/page.cpp puts the flight.

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const target = process.argv[2];
if (!target) {
  console.error("usage: node build.mjs OUT.cpp");
  process.exit(2);
}

const licence = readFileSync(join(here, "node_modules/uplot/LICENSE"), "utf8").trim();

async function bundle(entry) {
  const result = await build({
    entryPoints: [join(here, "src", entry)],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["es2020"],
    charset: "ascii",
    legalComments: "none",
    banner: { js: `/* Holds uPlot:\n${licence} */`, css: `/* Holds uPlot, see the script */` },
    logLevel: "warning",
  });
  return result.outputFiles[0].text.trim();
}

// Only these two texts may run or style the page: a name in the flight can do neither.
const allowed = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

const script = await bundle("main.ts");
const style = await bundle("style.css");
if (/<\/script|<!--/i.test(script)) throw new Error("the script would end its own element");
const policy = `default-src 'none'; script-src ${allowed(script)}; style-src ${allowed(style)}; img-src data:; base-uri 'none'; form-action 'none'`;
const values = { POLICY: policy, STYLE: style, SCRIPT: script };
const page = readFileSync(join(here, "src/index.html"), "utf8")
  .replace(/@@(POLICY|STYLE|SCRIPT)@@/g, (_, name) => values[name]);
const parts = page.split(/@@(?:TITLE|FLIGHT)@@/);
if (parts.length !== 3) throw new Error("index.html must hold @@TITLE@@ and @@FLIGHT@@ once each");
if (/[^\x00-\x7f]/.test(page)) throw new Error("the page must be ASCII");
if (page.includes(')page"')) throw new Error("the page holds the raw string's end");

// Compilers limit the length of one literal; adjacent ones join.
const literal = (text) => (text.match(/[^]{1,8000}/g) ?? [""]).map((piece) => `R"page(${piece})page"`).join("\n");
mkdirSync(dirname(target), { recursive: true });
writeFileSync(target, `// Written by report/page/build.mjs; do not edit.
#include <array>
#include <string_view>

#include "report/page.h"

namespace glider::report {

const std::array<std::string_view, 3> kPageParts = {
${parts.map(literal).join(",\n\n")}};

}  // namespace glider::report
`);
