// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The table of events: filtered by kind; a row moves the cursor of the charts. */

import { element, unbroken } from "./dom";
import { Flight, FlightEvent } from "./flight";
import { fixed } from "./format";
import { kindOf } from "./kinds";
import { View } from "./view";

/** Rows made at once; thousands of log lines come on demand. */
const batch = 500;

function badge(kind: string): HTMLElement {
  const { colour, glyph } = kindOf(kind);
  return element("span", { class: `badge ${colour}` }, element("i", { "aria-hidden": "true" }, glyph), kind);
}

function rowOf(event: FlightEvent, flight: Flight, view: View): HTMLElement {
  const seconds = (v: number | null) => (v === null ? "–" : `${fixed(v, 0)} s`);
  const { time } = event;
  const when = time === null ? element("span", {}, "–")
    : element("button", { type: "button", title: "show this moment in the charts" }, flight.clock(time));
  const row = element("tr", { "data-kind": event.kind },
    element("td", { class: "number" }, when, element("span", { class: "aside" }, time === null ? "" : ` ${seconds(time)}`)),
    element("td", { class: "number" }, seconds(event.missionTime)), element("td", {}, badge(event.kind)),
    element("td", { class: "what" }, ...unbroken(event.what)), element("td", { class: "why" }, ...unbroken(event.why)));
  if (time !== null) row.addEventListener("click", () => view.moveTo(time, true));
  return row;
}

export function eventList(host: HTMLElement, flight: Flight, view: View): void {
  const counts = new Map<string, number>();
  flight.events.forEach((e) => counts.set(e.kind, (counts.get(e.kind) ?? 0) + 1));
  // Every command of a dive or a climb is one: they would hide all else.
  const hidden = new Set([...counts.keys()].filter((kind) => kind === "steering" && counts.size > 1));
  let most = batch;
  const body = element("tbody");
  const more = element("button", { type: "button", class: "more" });
  const fill = () => {
    const chosen = flight.events.filter((e) => !hidden.has(e.kind));
    body.replaceChildren(...chosen.slice(0, most).map((e) => rowOf(e, flight, view)));
    more.hidden = chosen.length <= most;
    more.textContent = `show ${Math.min(batch, chosen.length - most)} more of ${chosen.length - most}`;
  };
  more.addEventListener("click", () => { most += batch; fill(); });
  const filters = element("div", { class: "filters", role: "group", "aria-label": "Kinds of events shown" });
  for (const [kind, count] of counts) {
    const button = element("button", { type: "button", "aria-pressed": String(!hidden.has(kind)) }, badge(kind), element("span", { class: "count" }, String(count)));
    button.addEventListener("click", () => {
      if (!hidden.delete(kind)) hidden.add(kind);
      button.setAttribute("aria-pressed", String(!hidden.has(kind)));
      fill();
    });
    filters.append(button);
  }
  const heads = [flight.log ? "UTC" : "vehicle time", "mission time", "kind", "what", "why"];
  const table = element("table", {}, element("thead", {}, element("tr", {}, ...heads.map((h) => element("th", { scope: "col" }, h)))), body);
  host.replaceChildren(filters, element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Events" }, table), more);
  fill();
}
