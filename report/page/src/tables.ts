// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The tables of the page: the yos of the flight, and what became of the mission's requirements. */

import { byId, element, unbroken } from "./dom";
import { saveButtons } from "./downloads";
import { Flight, Promised } from "./flight";
import { clock, fixed } from "./format";
import { View } from "./view";

const row = (cells: (string | Node)[], numbers: boolean) =>
  element("tr", {}, ...cells.map((c) => element("td", numbers ? { class: "number" } : {}, c)));

function table(heads: string[], rows: HTMLElement[], numbers = false): HTMLElement {
  const head = (text: string) => element("th", { scope: "col", ...(numbers ? { class: "number" } : {}) }, text);
  return element("table", {}, element("thead", {}, element("tr", {}, ...heads.map(head))), element("tbody", {}, ...rows));
}

/** The yos, one a row; a row moves the cursor of the charts to its start. */
export function yoTable(flight: Flight, view: View): void {
  byId("yos-card").hidden = flight.yos.length === 0;
  const rate = (v: number | null) => (v === null ? "–" : fixed(v, 3));
  const rows = flight.yos.map((yo, i) => {
    const made = row([String(i + 1), flight.clock(yo.start), fixed(yo.deepest, 1), clock(yo.duration), rate(yo.down), rate(yo.up), yo.surfaced ? "yes" : ""], true);
    made.addEventListener("click", () => view.moveTo(yo.start, true));
    return made;
  });
  const heads = ["yo", flight.log ? "start (UTC)" : "start", "deepest (m)", "duration", "down (m/s)", "up (m/s)", `to the surface (< ${flight.figures.surfaceDepth} m)`];
  byId("yos").replaceChildren(element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Yos" }, table(heads, rows, true)));
  byId("yos-head").append(saveButtons(flight, {
    title: "yos",
    table: () => ({
      head: ["yo", "start (s)", "deepest (m)", "duration (s)", "down (m/s)", "up (m/s)", "surfaced"],
      rows: flight.yos.map((yo, i) => [i + 1, yo.start, yo.deepest, yo.duration, yo.down, yo.up, yo.surfaced ? 1 : 0]),
    }),
  }));
}

function verdictOf(flight: Flight, promise: Promised): string {
  if (promise.verdict === "held") return "held in this flight";
  const time = promise.time === null ? "" : ` ${promise.verdict === "violated" ? "at" : "after"} ${flight.clock(promise.time)}`;
  return `${promise.verdict}${time}${promise.words === "" ? "" : `: ${promise.words}`}`;
}

/** What the mission requires and assumes, and whether this flight did so. */
export function promiseTable(flight: Flight): void {
  const { promises } = flight.facts;
  byId("promises-card").hidden = promises.length === 0;
  byId("promises").replaceChildren(table(["the mission's text", "in this flight"], promises.map((p) => {
    const verdict = element("td", { class: `verdict ${p.verdict.replace(" ", "-")}` }, ...unbroken(verdictOf(flight, p)));
    return element("tr", {}, element("td", {}, element("code", {}, p.text)), verdict);
  })));
}
