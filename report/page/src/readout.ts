// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** All values of the row under the cursor, in groups, whatever columns there are. */

import { element, swatch } from "./dom";
import { Flight } from "./flight";
import { clock, degreesMinutes, fixed, quantity, utcText } from "./format";
import { groups, nameOf } from "./names";
import { pilotColour } from "./palette";
import { View } from "./view";

const apart = new Set(["time", "missiontime", "state", "dr_leg", "gps_x", "gps_y", "sim_x", "sim_y"]);
/** The vehicle's own codes; 99 leaves the command of a lower behaviour as it is. */
const codes: Record<string, Record<number, string>> = {
  cc_final_heading_mode: { 0: "to the waypoint", 1: "heading", 2: "roll", 3: "battery roll", 4: "fin", 5: "relative to the current" },
  cc_final_pitch_mode: { 1: "battery position", 2: "set once", 3: "controlled", 4: "fluid" },
  cc_final_bpump_mode: { 0: "depth rate", 1: "relative to neutral", 2: "absolute", 3: "absolute, at the surface", 5: "speed" },
  x_dr_state: { 0: "mission start", 1: "under water", 2: "waiting for a fix", 3: "waiting for the second fix", 4: "waiting to dive" },
};
const noCommand: Record<number, string> = { [-1]: "not commanded", 99: "ignored" };
const verticals = ["none", "descend", "ascend", "hover", "surface", "pump and battery"];

function valueText(name: string, unit: string, value: number): string {
  if (name === "hook_active") return value > 0 ? "in control" : "not in control";
  if (codes[name]) return codes[name][value] ?? noCommand[value] ?? String(value);
  if (name === "hook_vertical") return verticals[value] ?? String(value);
  if (/(^|_)lat(itude)?$/.test(name)) return degreesMinutes(value, "N", "S");
  if (/(^|_)lon(gitude)?$/.test(name)) return degreesMinutes(value, "E", "W");
  return quantity(value, unit);
}

/** The columns of each group that the trace has, the rest under their own names at the end. */
function present(flight: Flight): [string, { name: string; label: string; unit: string }[]][] {
  const left = flight.columns.filter((c) => !apart.has(c.name) && flight.column(c.name) !== null);
  const out = groups.map(([title, labels]) => [title, Object.entries(labels).flatMap(([name, label]) => {
    const at = left.findIndex((c) => c.name === name);
    return at < 0 ? [] : [{ name, label, unit: left.splice(at, 1)[0].unit }];
  })] as [string, { name: string; label: string; unit: string }[]]);
  out.push(["Other", left.map((c) => ({ name: c.name, label: nameOf(flight, c.name), unit: c.unit }))]);
  return out.filter(([, list]) => list.length > 0);
}

export function readout(host: HTMLElement, flight: Flight, view: View): void {
  const now = element("p", { class: "now" });
  const state = element("p", { class: "state" });
  host.replaceChildren(now, state);
  const cells: { cell: HTMLElement; update: (row: number) => string }[] = [];
  for (const [title, list] of present(flight)) {
    const terms = element("dl");
    for (const { name, label, unit } of list) {
      const cell = element("dd", { "data-column": name });
      const values = flight.column(name) ?? [];
      cells.push({ cell, update: (row) => (values[row] == null ? "–" : valueText(name, unit, values[row] as number)) });
      const term = element("dt", { title: name }, label);
      terms.append(element("div", {}, term, cell));
    }
    host.append(element("h3", {}, title), terms);
  }
  const mission = flight.column("missiontime");
  view.onCursor(() => {
    const row = view.row;
    const at = mission?.[row] ?? null;
    const utc = flight.log ? utcText(flight.log.utc + view.time) : null;
    now.replaceChildren(element("b", {}, utc ? utc.slice(11) : clock(view.time)), element("span", {},
      `${utc ? `UTC, ${utc.slice(0, 10)}, ` : ""}${fixed(view.time, 0)} s${at === null ? "" : `, mission time ${fixed(at, 0)} s`}`));
    const pilot = flight.pilot(row);
    state.replaceChildren(swatch(pilotColour(pilot)), flight.pilotName(pilot),
      ...(!flight.log && pilot !== "layered" && !flight.inControl(row) ? [element("span", {}, " (not in control)")] : []));
    for (const { cell, update } of cells) {
      const text = update(row);
      if (cell.textContent !== text) cell.textContent = text;
    }
  });
}
