// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Draws missions and opens the pictures in a headless browser: nothing may cover a text, and nothing may stand outside.
// With GLIDER_SHOTS set to a folder it also leaves a picture of each there.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { Chromium } from "./chromium.mjs";

const program = process.env.GLIDER_CHROMIUM ?? "";
const shots = process.env.GLIDER_SHOTS;
if (program === "" || !existsSync(program)) {
  console.log("SKIPPED: no browser (chromium) is installed");
  process.exit(0);
}

const root = fileURLToPath(new URL("../..", import.meta.url));
const gallery = join(root, "missions/gallery");
const missions = [
  join(root, "missions/figure2.mission"), join(root, "missions/figure5.mission"), join(root, "tests/report/crowded.mission"),
  ...readdirSync(gallery).filter((name) => name.endsWith(".mission")).sort().map((name) => join(gallery, name)),
];

const folder = mkdtempSync(join(tmpdir(), "glider-graph-"));
let browser;
before(() => { browser = new Chromium(program); });
after(async () => { await browser.close(); rmSync(folder, { recursive: true }); });

/** What is wrong with the picture that is open: texts that something covers, things outside of it. */
const faults = `(() => {
  const svg = document.documentElement, found = [];
  const view = svg.viewBox.baseVal;
  const boxOf = (element, less) => {
    const { x, y, width, height } = element.getBBox();
    return { what: element.textContent.trim() || element.getAttribute("class"), left: x + less, top: y + less,
             right: x + width - less, bottom: y + height - less };
  };
  const covers = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
  const holds = (a, b) => a.left <= b.left && b.right <= a.right && a.top <= b.top && b.bottom <= a.bottom;
  const texts = [...svg.querySelectorAll("text")].map((text) => boxOf(text, 1.5));
  const rects = [...svg.querySelectorAll("rect:not(.paper)")].map((rect) => boxOf(rect, 0));
  for (const text of texts) {
    if (!holds({ left: 0, top: 0, right: view.width, bottom: view.height }, text)) found.push("outside: " + text.what);
    for (const other of texts) if (other !== text && covers(text, other)) found.push(text.what + " / " + other.what);
    for (const rect of rects) {
      const middle = { left: text.left + 4, right: text.right - 4, top: text.top + 4, bottom: text.bottom - 4 };
      if (covers(middle, rect) && !holds(rect, middle)) found.push(text.what + " sticks out of or into a box");
    }
  }
  rects.forEach((a, i) => rects.slice(i + 1).forEach((b) => { if (covers(a, b)) found.push("boxes: " + a.what + " / " + b.what); }));
  for (const path of svg.querySelectorAll("path.line")) {
    const length = path.getTotalLength();
    for (let at = 0; at < length; at += 2) {
      const { x, y } = path.getPointAtLength(at);
      const hit = texts.find((t) => x > t.left && x < t.right && y > t.top && y < t.bottom);
      if (hit) { found.push("a line runs through " + hit.what); break; }
    }
  }
  return found;
})()`;

for (const mission of missions) {
  for (const more of mission.includes("gallery") ? [[]] : [[], ["--deepest"]]) {
    const name = basename(mission, ".mission") + more.join("");
    test(`${name}: every text can be read`, async () => {
      const svg = join(folder, `${name}.svg`);
      execFileSync(process.env.GLIDERCC, ["graph", mission, "-o", svg, ...more], { stdio: ["ignore", "ignore", "ignore"] });
      const page = await browser.open(pathToFileURL(svg).href);
      await page.until("document.readyState === 'complete' && document.documentElement.localName === 'svg'");
      assert.ok(await page.eval("document.querySelectorAll('text').length") >= 4);
      assert.deepEqual(await page.eval(faults), []);
      assert.deepEqual(page.complaints, []);
      assert.deepEqual(page.requests, []);
      if (shots) {
        mkdirSync(shots, { recursive: true });
        const { data } = await page.send("Page.captureScreenshot", { captureBeyondViewport: true });
        writeFileSync(join(shots, `${name}.png`), Buffer.from(data, "base64"));
      }
      await page.close();
    });
  }
}
