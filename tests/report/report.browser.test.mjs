// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Opens the sample reports in a headless browser, as a pilot would, and looks at what is there. With GLIDER_SHOTS set to
// a folder it also leaves a picture of each page there.

import assert from "node:assert/strict";
import { existsSync, mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { pathToFileURL } from "node:url";
import { Chromium } from "./chromium.mjs";

const program = process.env.GLIDER_CHROMIUM ?? "";
const samples = process.env.GLIDER_SAMPLES ?? "";
const shots = process.env.GLIDER_SHOTS;
if (program === "" || !existsSync(program)) {
  console.log("SKIPPED: no browser (chromium) is installed");
  process.exit(0);
}

let browser;
before(() => { browser = new Chromium(program); });
after(() => browser.close());

/** Opens sample `name`, gives it to `look`, and checks what must hold of every page. */
async function withPage(name, look, size = []) {
  const page = await browser.open(pathToFileURL(join(samples, `${name}.html`)).href, ...size);
  await page.until("document.readyState === 'complete'");
  await look(page);
  assert.deepEqual(page.complaints, [], "the page complained");
  assert.deepEqual(page.requests, [], "the page asked for something");
  await page.close();
}

const ready = (page) => page.until("document.documentElement.dataset.ready === 'yes'");
const settle = (page) => page.eval("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))");

async function picture(page, name) {
  if (!shots) return;
  mkdirSync(shots, { recursive: true });
  const { data } = await page.send("Page.captureScreenshot", { captureBeyondViewport: true });
  writeFileSync(join(shots, `${name}.png`), Buffer.from(data, "base64"));
}

/** The number of different colours on canvas `index`: 1 when it is blank. */
const colours = (page, index) => page.eval(`(() => {
  const canvas = document.querySelectorAll("canvas")[${index}];
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  return new Set(new Uint32Array(data.buffer)).size;
})()`);
const text = (page, selector) => page.eval(`document.querySelector(${JSON.stringify(selector)}).innerText`);
const count = (page, selector) => page.eval(`document.querySelectorAll(${JSON.stringify(selector)}).length`);
const boxOf = (page, selector) => page.eval(`(() => {
  const { left, top, width, height } = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect();
  return { left, top, width, height };
})()`);
/** Chooses colour number `index` of the depth. */
const chooseColour = async (page, index) => {
  await page.eval(`(() => { const s = document.querySelector('.chooser select'); s.value = '${index}'; s.dispatchEvent(new Event('change')); })()`);
  await settle(page);
};
const value = (page, column) => text(page, `[data-column="${column}"]`);

describe("the sample flight", () => {
  test("is drawn with all its parts", () => withPage("sample", async (page) => {
    await ready(page);
    await settle(page);
    assert.equal(await page.eval("document.title"), "thermoclineSurvey: flight report");
    assert.equal(await count(page, "#charts-card canvas"), 7, "depth, temperature, pitch, heading, pump, vertical speed, battery");
    assert.equal(await count(page, "#water-card canvas"), 2, "a section and profiles of temperature");
    for (let i = 0; i < 9; ++i) assert.ok(await colours(page, i) > 3, `chart ${i} is blank`);
    assert.match(await text(page, "#header"), /scenario shelf-summer · flown in process · seed 7 · 28 events/);
    assert.match(await text(page, "#header"), /deepest\s*28\.8 m/);
    assert.match(await text(page, "#header"), /track 16:56, current once/);
    assert.equal(await count(page, "#events tbody tr"), 28);
    assert.match(await text(page, "#events tbody"), /search → track \(call\)/);
    assert.ok(await count(page, "#map .track path") >= 4, "the track has no states");
    assert.match(await text(page, "#map"), /39° 10\.500′ N/);
    assert.match(await text(page, "#map"), /waypoint 1, 4696 m/);
    await picture(page, "sample");
  }));

  test("tells the values under the mouse", () => withPage("sample", async (page) => {
    await ready(page);
    const plot = await boxOf(page, "#depth .u-over");
    await page.mouse("mouseMoved", plot.left + plot.width / 2, plot.top + plot.height / 2);
    assert.match(await text(page, ".now"), /20:20\s*1220 s, mission time 960 s/);
    assert.match(await text(page, "#readout .state"), /track/);
    const depth = await value(page, "m_depth");
    assert.match(depth, /^\d+\.\d m$/);
    await page.mouse("mouseMoved", plot.left + plot.width * 0.9, plot.top + plot.height / 2);
    assert.match(await text(page, "#readout .state"), /layered control/);
    assert.notEqual(await value(page, "m_depth"), depth);
    assert.equal(await value(page, "commanded_top"), "–");
    assert.equal(await value(page, "c_pitch"), "−26.0°");
  }));

  test("explains an event under the mouse", () => withPage("sample", async (page) => {
    await ready(page);
    const plot = await boxOf(page, "#depth .u-over");
    await page.mouse("mouseMoved", plot.left + plot.width * (444 / 2440), plot.top + 60);
    const tip = await text(page, ".tip");
    assert.match(tip, /search → track \(call\)/);
    assert.match(tip, /transition at 7:24, mission time 184 s/);
    assert.match(tip, /spread\(temp, 10 m of depth\) >= 6 degC/);
    await page.mouse("mouseMoved", plot.left + plot.width * 0.75, plot.top + 60);
    assert.equal(await page.eval("document.querySelector('.tip').hidden"), true);
  }));

  test("zooms by dragging, in all charts, and back by keys", () => withPage("sample", async (page) => {
    await ready(page);
    const plot = await boxOf(page, "#depth .u-over");
    const [y, from, to] = [plot.top + 80, plot.left + plot.width * 0.25, plot.left + plot.width * 0.5];
    await page.mouse("mouseMoved", from, y);
    await page.mouse("mousePressed", from, y, { button: "left", clickCount: 1 });
    await page.mouse("mouseMoved", to, y, { button: "left", buttons: 1 });
    await page.mouse("mouseReleased", to, y, { button: "left", clickCount: 1 });
    const pitch = await boxOf(page, "#others .u-over");
    await page.mouse("mouseMoved", pitch.left + 1, pitch.top + 20);
    assert.match(await text(page, ".now"), /^10:[01]\d/);
    await picture(page, "zoomed");
    await page.eval("document.querySelector('#depth .u-over').focus()");
    await page.key("0");
    await page.key("Home");
    await page.key("ArrowRight");
    assert.match(await text(page, ".now"), /^0:04/);
    const words = await page.eval("document.querySelector('#depth .u-over').getAttribute('aria-valuetext')");
    assert.match(words, /^0:04, depth 1\.\d m, layered control$/);
  }));

  test("finds an event from the list and filters by kind", () => withPage("sample", async (page) => {
    await ready(page);
    await page.eval("[...document.querySelectorAll('#events tbody tr')].find((r) => r.innerText.includes('track → exit')).querySelector('button').click()");
    assert.match(await text(page, ".now"), /^24:20/);
    await page.eval("[...document.querySelectorAll('.filters button')].find((b) => b.innerText.includes('hook')).click()");
    assert.equal(await count(page, "#events tbody tr"), 12);
    assert.equal(await count(page, "#events tbody tr[data-kind=hook]"), 0);
  }));

  test("takes or leaves lines", () => withPage("sample", async (page) => {
    await ready(page);
    const pixels = "document.querySelector('canvas').toDataURL()";
    await settle(page);
    const before = await page.eval(pixels);
    await page.eval("[...document.querySelectorAll('#depth-head .legend button')].find((b) => b.innerText.includes('commanded')).click()");
    await settle(page);
    assert.notEqual(await page.eval(pixels), before);
  }));

  test("follows the dark theme and fits a telephone", () => withPage("sample", async (page) => {
    await ready(page);
    const ground = "getComputedStyle(document.body).backgroundColor";
    const light = await page.eval(ground);
    await page.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: "dark" }] });
    await settle(page);
    assert.notEqual(await page.eval(ground), light);
    assert.ok(await page.eval("document.documentElement.scrollWidth <= innerWidth"), "the page is wider than the screen");
    await picture(page, "telephone");
  }, [400, 800]));

  test("prints", () => withPage("sample", async (page) => {
    await ready(page);
    const { data } = await page.send("Page.printToPDF", { printBackground: true });
    const pdf = Buffer.from(data, "base64");
    assert.ok(pdf.length > 20_000, "the print is empty");
    if (shots) writeFileSync(join(shots, "sample.pdf"), pdf);
  }));
});

describe("other flights", () => {
  test("markup and script in names are shown, not obeyed", () => withPage("hostile", async (page) => {
    await ready(page);
    assert.equal(await page.eval("window.glider_was_here"), undefined);
    assert.equal(await count(page, "img"), 0);
    assert.equal(await count(page, "body script"), 2);
    assert.match(await text(page, "h1"), /^<\/script><script>window\.glider_was_here = 1<\/script><\/title><!-- ünïcødé 海洋/);
    assert.equal(await count(page, "#events tbody tr"), 29);
    await picture(page, "hostile");
  }));

  test("no field, no states, no events, unknown depths", () => withPage("bare", async (page) => {
    await ready(page);
    assert.equal(await page.eval("document.querySelector('#events-card').hidden"), true);
    assert.ok(await colours(page, 0) > 3);
    const plot = await boxOf(page, "#depth .u-over");
    await page.mouse("mouseMoved", plot.left + plot.width * (230 / 610), plot.top + 40);
    assert.equal(await value(page, "m_depth"), "–");
    await picture(page, "bare");
  }));

  test("the log of a vehicle", () => withPage("log", async (page) => {
    await ready(page);
    await settle(page);
    assert.equal(await page.eval("document.title"), "comet: SPIRAL.MI: flight report");
    const head = await text(page, "#header");
    assert.match(head, /log of the vehicle · 2019-08-09 15:24:32 to 16:05:12 UTC · simulated flight: flight\/trace.csv · 3 events/);
    assert.doesNotMatch(head, /seed|layered/);
    assert.match(head, /a note/);
    assert.match(head, /energy used\s*6\.1 Wh/);
    assert.equal(await count(page, "#charts-card canvas"), 9, "depth, temperature, pitch, heading, pump, vertical speed, battery, power, energy");
    assert.match(await text(page, "#depth-head"), /simulated flight/);
    assert.match(await text(page, "#map-legend"), /dead-reckoned track, in the state's colour\s*GPS fix\s*moved by a GPS fix\s*depth-averaged current, up to 0\.22 m\/s\s*simulated flight/);
    assert.equal(await count(page, "#map .fix"), 2);
    assert.equal(await count(page, "#map .current"), 2, "one arrow for each estimate");
    assert.equal(await count(page, "#map .simulated"), 1);
    // The fix moves the position by 200 m: no piece of the track is that long.
    const lengths = await page.eval(`[...document.querySelectorAll("#map .faded path")].map((p) => p.getTotalLength())`);
    const usual = lengths.sort((a, b) => a - b)[Math.floor(lengths.length / 2)];
    assert.ok(lengths.length > 8 && Math.max(...lengths) < 2 * usual, "the track jumps to the fix");
    assert.match(await text(page, "#events tbody"), /15:26:32[^]*left the surface[^]*15:46:12[^]*too deep/);
    assert.match(await text(page, "#events thead"), /UTC/);
    const plot = await boxOf(page, "#depth .u-over");
    await page.mouse("mouseMoved", plot.left + plot.width / 2, plot.top + 100);
    assert.match(await text(page, ".now"), /15:44:52\s*UTC, 2019-08-09, 1220 s/);
    assert.equal(await value(page, "cc_final_heading_mode"), "to the waypoint");
    assert.doesNotMatch(await text(page, "#readout .state"), /control/);
    await picture(page, "log");
  }));

  test("a gap of a log is no state", () => withPage("log_gap", async (page) => {
    await ready(page);
    await settle(page);
    assert.match(await text(page, "#header"), /duration\s*40:40\s*with records\s*30:28/);
    assert.doesNotMatch(await text(page, "#header"), /state not known/);
    // Whether the bar of states is painted at these parts of the width.
    const painted = await page.eval(`(() => {
      const canvas = document.querySelector("#depth canvas"), box = canvas.getBoundingClientRect();
      const plot = document.querySelector("#depth .u-over").getBoundingClientRect(), scale = canvas.width / box.width;
      const row = canvas.getContext("2d").getImageData(0, (plot.top - box.top - 58) * scale, canvas.width, 1).data;
      return [0.2, 0.3, 0.4, 0.6].map((part) => row[4 * Math.round((plot.left + plot.width * part - box.left) * scale) + 3] > 0);
    })()`);
    assert.deepEqual(painted, [true, false, false, true]);
  }));

  test("the depth of a log has the colours of an instrument, or none", () => withPage("log", async (page) => {
    await ready(page);
    await settle(page);
    const pixels = "document.querySelector('canvas').toDataURL().length";
    const coloured = await page.eval(pixels);
    assert.equal(await page.eval("document.querySelector('.chooser select').selectedOptions[0].text"), "temperature");
    await chooseColour(page, 1);
    assert.ok(await page.eval(pixels) < 0.7 * coloured, "the temperature is still drawn");
  }));

  test("the depth of a simulated flight is coloured on white, or drawn on the field", () => withPage("sample", async (page) => {
    await ready(page);
    await settle(page);
    const titles = await page.eval("[...document.querySelector('.chooser select').options].map((o) => o.text)");
    assert.deepEqual(titles, ["temperature", "temperature of all the water", "none"]);
    // Whether the ground is white beside the line: half way down the plot at its left edge.
    const ground = `(() => {
      const canvas = document.querySelector("#depth canvas"), box = canvas.getBoundingClientRect();
      const plot = document.querySelector("#depth .u-over").getBoundingClientRect(), scale = canvas.width / box.width;
      const at = canvas.getContext("2d").getImageData((plot.left - box.left + 2) * scale, (plot.top - box.top + plot.height * 0.53) * scale, 1, 1).data;
      return [...at].slice(0, 3);
    })()`;
    assert.deepEqual(await page.eval(ground), [255, 255, 255]);
    await chooseColour(page, 1);
    assert.ok(await colours(page, 0) > 500, "the depth chart has no temperature field");
    assert.notDeepEqual(await page.eval(ground), [255, 255, 255]);
    assert.match(await text(page, "#map-legend"), /true track, in the state's colour\s*dead reckoned/);
  }));

  test("a single row", () => withPage("one_row", async (page) => {
    await ready(page);
    assert.equal(await value(page, "m_depth"), "1.2 m");
    await picture(page, "one_row");
  }));

  test("nothing at all", () => withPage("empty", async (page) => {
    assert.match(await text(page, "body"), /This flight recorded nothing/);
    assert.equal(await count(page, "canvas"), 0);
  }));

  test("100,000 rows", () => withPage("long", async (page) => {
    await ready(page);
    assert.match(await text(page, "#thinned"), /of 100000 rows are drawn/);
    const start = Date.now();
    const plot = await boxOf(page, "#depth .u-over");
    for (let i = 0; i < 20; ++i) await page.mouse("mouseMoved", plot.left + 20 + i * 20, plot.top + 80);
    assert.ok(Date.now() - start < 5000, "moving the cursor is slow");
    await picture(page, "long");
  }));
});
