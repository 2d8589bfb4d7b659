// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a scientist looks for in the report of a simulated flight, in a headless browser.

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { Chromium } from "./chromium.mjs";

const program = process.env.GLIDER_CHROMIUM ?? "";
const samples = process.env.GLIDER_SAMPLES ?? "";
if (program === "" || !existsSync(program)) {
  console.log("SKIPPED: no browser (chromium) is installed");
  process.exit(0);
}

let browser;
before(() => { browser = new Chromium(program); });
after(() => browser.close());

async function withPage(name, look, width = 1400) {
  const page = await browser.open(pathToFileURL(join(samples, `${name}.html`)).href, width, 1000);
  await page.until("document.documentElement.dataset.ready === 'yes'");
  await page.eval("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))");
  await look(page);
  assert.deepEqual(page.complaints, [], "the page complained");
  await page.close();
}

const texts = (page, selector) => page.eval(`[...document.querySelectorAll(${JSON.stringify(selector)})].map((e) => e.textContent)`);
const text = async (page, selector) => page.eval(`document.querySelector(${JSON.stringify(selector)}).innerText`);

test("what the mission lists and logs is drawn first, with units", () => withPage("science", async (page) => {
  const titles = await texts(page, "#others h3");
  assert.deepEqual(titles.slice(0, 7), ["Chlorophyll (µg/L)", "Roll (°)", "True longitude (°)", "m_depth_state", "Temperature (°C)", "Conductivity (S/m)", "Log “bloom, at”: depth (m)"]);
  assert.ok(titles.includes("Energy used (Wh)"));
  const lit = await page.eval(`(() => {
    const charts = [...document.querySelectorAll("#others canvas")];
    return charts.map((c) => new Set(new Uint32Array(c.getContext("2d").getImageData(0, 0, c.width, c.height).data.buffer)).size);
  })()`);
  assert.ok(lit.every((n) => n > 3), `a chart is blank: ${lit}`);
}));

test("a logged position is on the map, and what was logged once in a table", () => withPage("science", async (page) => {
  const titles = await texts(page, "#others h3");
  assert.deepEqual(titles.filter((title) => title.includes("turn")), []);
  assert.equal(await page.eval("document.querySelectorAll('#map .logged').length"), 1);
  assert.match(await page.eval("document.querySelector('#map .logged title').textContent"), /^logged at [0-9:]+: turn 39° 1[0-9.]+′ N 73° /);
  assert.match((await texts(page, "#logged tbody tr")).join(), /^[0-9:]+log “turn”: utc2009-08-11 14:16:20 UTC$/);
}));

test("the depth has the colours of what the conditions read first", () => withPage("science", async (page) => {
  assert.equal(await page.eval("document.querySelector('.chooser select').selectedOptions[0].text"), "chlorophyll");
}));

test("sections, profiles and a T-S diagram with lines of density", () => withPage("science", async (page) => {
  assert.deepEqual(await texts(page, "#sections h3"),
    ["Temperature (°C)", "Chlorophyll (µg/L)", "Conductivity (S/m)", "Salinity", "Sigma-t (kg/m³)"]);
  const plots = await texts(page, "#profiles h3");
  assert.deepEqual(plots.slice(0, 2), ["Temperature (°C) by depth", "Chlorophyll (µg/L) by depth"]);
  assert.equal(plots.at(-1), "T-S diagram");
}));

test("water of one conductivity has no T-S diagram", () => withPage("sample", async (page) => {
  assert.deepEqual(await texts(page, "#profiles h3"), ["Temperature (°C) by depth"]);
}));

test("yos, energy to go and the requirements are told", () => withPage("science", async (page) => {
  const yos = await page.eval("[...document.querySelectorAll('#yos tbody tr')].map((r) => [...r.children].map((c) => c.textContent))");
  assert.ok(yos.length > 3);
  assert.equal(String(yos.length), await page.eval("[...document.querySelectorAll('.tiles div')].find((d) => d.querySelector('dt').textContent === 'yos').querySelector('dd').textContent"));
  assert.match(yos[0].join(" "), /^1 \S+ 2\d\.\d \d+:\d\d 0\.\d{3} 0\.\d{3}/);
  const head = await text(page, "#header");
  assert.match(head, /energy used\s*1\.2 Wh \(0\.12 % of the pack\)/);
  assert.match(head, /energy to go\s*898\.8 Wh \(89\.9 %\)/);
  assert.match(head, /dead-reckoned and true position\s*up to 132 m apart/);
  assert.deepEqual(await texts(page, "#promises .verdict"),
    ["held in this flight", "violated at 10:00: depth is 21 m", "not checked: it says what some flight can do"]);
}));

test("the numbers of the yos stand below their headings", () => withPage("science", async (page) => {
  const edges = await page.eval(`(() => {
    const right = (cell) => { const range = document.createRange(); range.selectNodeContents(cell); return range.getBoundingClientRect().right; };
    const table = document.querySelector("#yos table");
    return [...table.tHead.rows[0].cells].slice(0, 6).map((head, i) => right(head) - right(table.tBodies[0].rows[0].cells[i]));
  })()`);
  assert.ok(edges.every((off) => Math.abs(off) < 1), `${edges}`);
  assert.equal((await texts(page, "#yos th")).at(-1), "to the surface (< 2 m)");
}));

test("no label of an axis is cut off, and all charts have one time scale", () => withPage("science", async (page) => {
  const rooms = await page.eval(`[...document.querySelectorAll("#charts-card .u-wrap, #sections .u-wrap")].map((wrap) => {
    const canvas = wrap.querySelector("canvas");
    const left = wrap.querySelector(".u-over").offsetLeft;
    // Ink in the first columns of the axis would be that of a label that begins further left.
    const { data } = canvas.getContext("2d").getImageData(0, 0, 3 * devicePixelRatio, canvas.height);
    return { left, cut: new Set(new Uint32Array(data.buffer)).size > 1 };
  })`);
  assert.ok(rooms.length > 5);
  assert.deepEqual(rooms.filter((r) => r.cut), []);
  assert.equal(new Set(rooms.map((r) => r.left)).size, 1);
}));

test("a position is not broken over lines", () => withPage("science", async (page) => {
  const spans = await page.eval(`[...document.querySelectorAll("#events .unbroken")].map((s) => [s.textContent, s.getClientRects().length])`);
  assert.deepEqual(spans, [["39 10.498 N 73 49.821 W", 1], ["39 10.498 N", 1]]);
}, 640));

test("a heading that passes north is in the saved table", () => withPage("science", async (page) => {
  await page.eval(`window.saved = []; URL.createObjectURL = (blob) => { blob.text().then((text) => saved.push(text)); return "#"; };
    document.addEventListener("click", (e) => { if (e.target.download) e.preventDefault(); }, true);`);
  await page.eval(`[...document.querySelectorAll("#others .save button[aria-label^='save Heading'][aria-label$='CSV']")][0].click()`);
  await page.until("saved.length > 0");
  const cells = (await page.eval("saved[0]")).trim().split("\n").slice(1).map((row) => row.split(",").at(-1));
  const known = await page.eval(`(() => { const { trace } = JSON.parse(document.getElementById("flight").textContent);
    const at = trace.columns.findIndex((c) => c.name === "m_heading"), width = trace.columns.length;
    return trace.rows.filter((v, i) => i % width === at && v !== null).length; })()`);
  assert.equal(cells.filter((c) => c !== "").length, known);
}));

test("steering is hidden until it is asked for", () => withPage("science", async (page) => {
  const kinds = () => page.eval("new Set([...document.querySelectorAll('#events tbody tr')].map((r) => r.dataset.kind)).has('steering')");
  const button = "[...document.querySelectorAll('.filters button')].find((b) => b.innerText.includes('steering'))";
  assert.equal(await kinds(), false);
  await page.eval(`${button}.click()`);
  assert.equal(await kinds(), true);
}));

test("each chart is saved as a picture and as a table", () => withPage("science", async (page) => {
  // The browser writes no file here: what would be one is kept.
  await page.eval(`window.saved = []; URL.createObjectURL = (blob) => { blob.arrayBuffer().then((b) => saved.push({ type: blob.type, size: b.byteLength, text: new TextDecoder().decode(b) })); return "#"; };
    document.addEventListener("click", (e) => { if (e.target.download) { e.preventDefault(); saved.names = [...(saved.names ?? []), e.target.download]; } }, true);`);
  const groups = await page.eval("document.querySelectorAll('.save').length");
  const charts = await page.eval("document.querySelectorAll('#charts-card canvas, #water-card canvas').length");
  assert.equal(groups, charts + 2, "every chart, the map and the yos");
  const save = async (selector, kind) => {
    const before = await page.eval("saved.length");
    await page.eval(`[...document.querySelectorAll(${JSON.stringify(selector)})].find((b) => b.textContent === "${kind}").click()`);
    await page.until(`saved.length > ${before}`);
    return page.eval("saved[saved.length - 1]");
  };
  for (const place of ["#depth-head", "#map-head", "#sections", "#profiles"]) {
    const png = await save(`${place} .save button`, "PNG");
    assert.equal(png.type, "image/png");
    assert.ok(png.size > 5000, `${place}: ${png.size} bytes`);
  }
  const depth = await save("#depth-head .save button", "CSV");
  assert.match(depth.text, /^time \(s\),.*m_depth \(m\)\n0,/);
  assert.equal(depth.text.trim().split("\n").length, 1 + await page.eval("JSON.parse(document.getElementById('flight').textContent).figures.rows"));
  const logged = await save("#others .head:nth-of-type(13) .save button", "CSV");
  assert.match(logged.text, /^time \(s\),log_bloom_at_depth \(m\)\n/);
  assert.match((await save("#map-head .save button", "CSV")).text, /^time \(s\),east \(m\),north \(m\),latitude \(deg\),longitude \(deg\)\n0,/);
  assert.match(await page.eval("saved.names.join(' ')"), /thermoclinesurvey-depth\.png .*thermoclinesurvey-track\.csv/);
}));

/** The first word of the map that is cut off or covers another; "": there is none. */
const clash = (page) => page.eval(`(() => {
  const boxes = [...document.querySelectorAll("#map text")].map((t) => ({ words: t.textContent, box: t.getBoundingClientRect() }));
  const sheet = document.querySelector("#map > svg").getBoundingClientRect();
  for (const { words, box } of boxes) {
    if (box.left < sheet.left - 1 || box.right > sheet.right + 1 || box.top < sheet.top - 1 || box.bottom > sheet.bottom + 1) return words + " is cut off";
  }
  for (let i = 0; i < boxes.length; ++i) for (let j = i + 1; j < boxes.length; ++j) {
    const [a, b] = [boxes[i].box, boxes[j].box];
    if (a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1) return boxes[i].words + " covers " + boxes[j].words;
  }
  return "";
})()`);

test("no word of the map covers another or is cut off, however wide the page is", async () => {
  for (const name of ["science", "sample", "short", "log"]) {
    await withPage(name, async (page) => {
      for (let width = 640; width <= 1400; width += 20) {
        await page.send("Emulation.setDeviceMetricsOverride", { width, height: 1000, deviceScaleFactor: 1, mobile: false });
        await page.eval("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))");
        assert.equal(await clash(page), "", `${name} at ${width} px`);
      }
    });
  }
});

test("the map has degrees, names, circles, currents and the bottom", async () => {
  for (const width of [1400, 800]) {
    await withPage("science", async (page) => {
      const words = await texts(page, "#map text");
      assert.ok(words.some((w) => /^39° 10\.\d+′ N$/.test(w)), `no latitude: ${words}`);
      assert.ok(words.some((w) => /^73° \d\d\.\d+′ W$/.test(w)), `no longitude: ${words}`);
      for (const word of ["home", "start", "end"]) assert.ok(words.includes(word), `no ${word}: ${words}`);
      assert.ok(words.some((w) => /^\d+ m$/.test(w)));
      assert.equal(await page.eval("document.querySelectorAll('#map .watch').length"), 1);
      assert.ok(await page.eval("document.querySelectorAll('#map .true-current').length") > 4);
      assert.ok(await page.eval("document.querySelectorAll('#map .contour').length") > 0);
    }, width);
  }
});

test("on a narrow screen the values under the cursor do not part the charts from the map", () => withPage("science", async (page) => {
  const tops = await page.eval("['charts-card', 'map-card', 'readout-card', 'water-card'].map((id) => document.getElementById(id).getBoundingClientRect().top)");
  assert.deepEqual([...tops].sort((a, b) => a - b), tops, `the cards stand at ${tops}`);
  assert.ok(await page.eval("document.documentElement.scrollWidth <= innerWidth"));
  assert.ok(await page.eval("document.getElementById('charts-card').getBoundingClientRect().width > 740"), "the charts share their row");
}, 800));

test("a straight track does not sit in an empty square", () => withPage("science", async (page) => {
  // The sample's track goes east.
  const ratio = await page.eval("(() => { const r = document.querySelector('#map .frame').getBBox(); return r.width / r.height; })()");
  assert.ok(ratio > 1.9, `width by height: ${ratio}`);
}));

test("short states and crowded events are folded", () => withPage("crowded", async (page) => {
  // Dark marks of events would hide the depth: count the columns of the plot that a line crosses over its whole height.
  const lines = await page.eval(`(() => {
    const canvas = document.querySelector("#depth canvas"), box = canvas.getBoundingClientRect();
    const plot = document.querySelector("#depth .u-over").getBoundingClientRect(), scale = canvas.width / box.width;
    const [wide, high] = [Math.round(plot.width * scale), 12];
    const { data } = canvas.getContext("2d").getImageData((plot.left - box.left) * scale, (plot.bottom - box.top - high - 2) * scale, wide, high);
    // The lines are dashed, and each pales the one before: a column counts if one of its pixels is not white.
    const dark = new Set();
    for (let i = 0; i < data.length; i += 4) if (data[i] < 200 && data[i + 3] > 0) dark.add((i / 4) % wide);
    return dark.size;
  })()`);
  assert.ok(lines < 300, `a line crosses ${lines} columns`);
  // Both states are in the band, as shares of each bar.
  const band = await page.eval(`(() => {
    const canvas = document.querySelector("#depth canvas"), box = canvas.getBoundingClientRect();
    const plot = document.querySelector("#depth .u-over").getBoundingClientRect(), scale = canvas.width / box.width;
    const x = (plot.left + plot.width / 2 - box.left) * scale;
    const at = (up) => [...canvas.getContext("2d").getImageData(x, (plot.top - box.top - up) * scale, 1, 1).data].slice(0, 3).join();
    return [at(57), at(41)];
  })()`);
  assert.notEqual(band[0], band[1], "the shares of two states look like one");
}));
