// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** All values of the row under the cursor, in groups, whatever columns there are. */

import { element, swatch } from "./dom";
import { Flight } from "./flight";
import { clock, degreesMinutes, fixed, quantity, utcText } from "./format";
import { pilotColour } from "./palette";
import { View } from "./view";

const groups: [string, Record<string, string>][] = [
  ["Depth and attitude", {
    m_depth: "depth", true_depth: "true depth", sim_depth: "simulated depth", m_depth_rate: "depth rate", water_depth: "water depth", m_altitude: "altitude",
    m_pitch: "pitch", c_pitch: "commanded pitch", m_roll: "roll", m_heading: "heading", c_heading: "commanded heading",
  }],
  ["Commands of the SBC", {
    hook_active: "hookbeh", hook_vertical: "vertical", hook_depth: "target depth", commanded_top: "range from", commanded_bottom: "range to",
    layer: "commanding layer",
  }],
  ["Water", {
    sci_water_temp: "temperature", sci_water_cond: "conductivity", sci_water_pressure: "pressure", isotherm_depth: "marked isotherm",
    sci_flbbcd_chlor_units: "chlorophyll", sci_flntu_chlor_units: "chlorophyll", sci_flntu_turb_units: "turbidity",
    sci_flbbcd_bb_units: "backscatter", sci_flbbcd_cdom_units: "CDOM", sci_oxy4_oxygen: "oxygen", sci_oxy4_saturation: "oxygen saturation",
    m_water_vx: "estimated current towards east", m_water_vy: "estimated current towards north",
    current_x: "current towards east", current_y: "current towards north",
  }],
  ["Vehicle", {
    m_ballast_pumped: "pump", c_ballast_pumped: "commanded pump volume", m_battpos: "battery position", m_battery: "battery", m_speed: "speed",
    m_de_oil_vol: "oil volume", c_de_oil_vol: "commanded oil volume", m_fin: "fin", m_coulomb_current: "current drawn", power: "power",
    energy: "energy used", m_lithium_battery_relative_charge: "battery charge", m_vacuum: "vacuum",
  }],
  ["Modes of control", {
    cc_final_heading_mode: "heading", cc_final_pitch_mode: "pitch", cc_final_bpump_mode: "pump", x_dr_state: "dead reckoning",
  }],
  ["Position", {
    m_lat: "latitude", m_lon: "longitude", true_lat: "true latitude", true_lon: "true longitude",
    m_x_lmc: "east", m_y_lmc: "north", true_x: "true east", true_y: "true north",
    dr_x: "east of start", dr_y: "north of start", m_gps_lat: "GPS latitude", m_gps_lon: "GPS longitude",
    c_wpt_x_lmc: "waypoint east", c_wpt_y_lmc: "waypoint north", c_wpt_lat: "waypoint latitude", c_wpt_lon: "waypoint longitude",
  }],
];
const apart = new Set(["time", "missiontime", "state", "dr_leg", "gps_x", "gps_y", "sim_x", "sim_y"]);
/** The vehicle's own codes; 99 leaves the command of a lower behaviour as it is. */
const codes: Record<string, Record<number, string>> = {
  cc_final_heading_mode: { 0: "to the waypoint", 1: "heading", 2: "roll", 3: "battery roll", 4: "fin", 5: "relative to the current" },
  cc_final_pitch_mode: { 1: "battery position", 2: "set once", 3: "controlled", 4: "fluid" },
  cc_final_bpump_mode: { 0: "depth rate", 1: "relative to neutral", 2: "absolute", 3: "absolute, at the surface", 5: "speed" },
  x_dr_state: { 0: "mission start", 1: "under water", 2: "waiting for a fix", 3: "waiting for the second fix", 4: "waiting to dive" },
};
const noCommand: Record<number, string> = { [-1]: "not commanded", 99: "ignored" };
const verticals = ["none", "descend", "ascend", "hover", "surface"];

function valueText(name: string, unit: string, value: number): string {
  if (name === "hook_active") return value > 0 ? "in control" : "not in control";
  if (codes[name]) return codes[name][value] ?? noCommand[value] ?? String(value);
  if (name === "hook_vertical") return verticals[value] ?? String(value);
  if (/(^|_)lat$/.test(name)) return degreesMinutes(value, "N", "S");
  if (/(^|_)lon$/.test(name)) return degreesMinutes(value, "E", "W");
  return quantity(value, unit);
}

/** The columns of each group that the trace has, the rest under their own names at the end. */
function present(flight: Flight): [string, { name: string; label: string; unit: string }[]][] {
  const left = flight.columns.filter((c) => !apart.has(c.name) && flight.column(c.name) !== null);
  const out = groups.map(([title, labels]) => [title, Object.entries(labels).flatMap(([name, label]) => {
    const at = left.findIndex((c) => c.name === name);
    return at < 0 ? [] : [{ name, label, unit: left.splice(at, 1)[0].unit }];
  })] as [string, { name: string; label: string; unit: string }[]]);
  out.push(["Other", left.map((c) => ({ name: c.name, label: c.name, unit: c.unit }))]);
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
