// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** What the mission logged that is no chart: positions, and values of which there are too few. */

import { element } from "./dom";
import { Flight, Logged } from "./flight";
import { clock, degreesMinutes, quantity } from "./format";
import { nameOf } from "./names";
import { View } from "./view";

/** Fewer values than this are told in a table. */
const leastForChart = 3;

export interface LoggedPlace { row: number; lat: number; lon: number; words: string }

/** A latitude and the longitude after it, of one statement. */
function pairs(flight: Flight): [Logged, Logged][] {
  const { logged } = flight.facts;
  return logged.flatMap((one, i) => {
    const next = logged[i + 1];
    const pair = one.half === "latitude" && next?.half === "longitude" && next.text === one.text;
    return pair && flight.column(one.column) && flight.column(next.column) ? [[one, next] as [Logged, Logged]] : [];
  });
}

/** The positions that the mission logged. */
export function loggedPlaces(flight: Flight): LoggedPlace[] {
  return pairs(flight).flatMap(([north, east]) => {
    const [lats, lons] = [flight.column(north.column) ?? [], flight.column(east.column) ?? []];
    return lats.flatMap((lat, row) => {
      const lon = lons[row] ?? null;
      return lat === null || lon === null ? [] : [{ row, lat, lon, words: north.text }];
    });
  });
}

const countOf = (flight: Flight, column: string) => (flight.column(column) ?? []).filter((v) => v !== null).length;

/** The logged values that have a chart. */
export function chartedLogs(flight: Flight): Logged[] {
  const placed = new Set(pairs(flight).flat());
  return flight.facts.logged.filter((l) => !placed.has(l) && countOf(flight, l.column) >= leastForChart);
}

function valueText(flight: Flight, logged: Logged, value: number): string {
  if (logged.half === "latitude") return degreesMinutes(value, "N", "S");
  if (logged.half === "longitude") return degreesMinutes(value, "E", "W");
  const unit = flight.columns.find((c) => c.name === logged.column)?.unit ?? "";
  return unit === "s" && Math.abs(value) >= 60 ? clock(value) : quantity(value, unit);
}

/** A table of the logged values that are too few for a chart, into `host`. A row moves the cursor to its time. */
export function loggedTable(host: HTMLElement, flight: Flight, view: View): void {
  const placed = new Set(pairs(flight).flat());
  const few = flight.facts.logged.filter((l) => !placed.has(l) && countOf(flight, l.column) > 0 && countOf(flight, l.column) < leastForChart);
  const rows = few.flatMap((logged) => (flight.column(logged.column) ?? []).flatMap((value, row) => (value === null ? [] : [{ logged, value, time: flight.times[row] }])));
  rows.sort((a, b) => a.time - b.time);
  if (rows.length === 0) return;
  const cells = (tag: "td" | "th", texts: string[]) => element("tr", {}, ...texts.map((text) => element(tag, {}, text)));
  const body = rows.map(({ logged, value, time }) => {
    const made = cells("td", [flight.clock(time), `log ${nameOf(flight, logged.column)}`, valueText(flight, logged, value)]);
    made.addEventListener("click", () => view.moveTo(time, true));
    return made;
  });
  host.append(element("h3", {}, "Logged"), element("table", {},
    element("thead", {}, cells("th", [flight.log ? "time (UTC)" : "time", "what", "value"])), element("tbody", {}, ...body)));
}
