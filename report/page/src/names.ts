// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** What the columns of a trace are called on the page, and which of them describe the water. */

import { Column, Flight, Values } from "./flight";
import { shownUnit } from "./format";

/** The columns in groups, each with its name. */
export const groups: [string, Record<string, string>][] = [
  ["Depth and attitude", {
    m_depth: "depth", true_depth: "true depth", sim_depth: "simulated depth", m_depth_rate: "depth rate", water_depth: "water depth", m_altitude: "altitude",
    m_pitch: "pitch", c_pitch: "commanded pitch", m_roll: "roll", m_heading: "heading", c_heading: "commanded heading",
  }],
  ["Commands of the SBC", {
    hook_active: "SBC", hook_vertical: "vertical", hook_depth: "target depth", commanded_top: "range from", commanded_bottom: "range to",
    layer: "commanding layer",
  }],
  ["Water", {
    sci_water_temp: "temperature", sci_water_cond: "conductivity", sci_water_pressure: "pressure", isotherm_depth: "marked isotherm",
    sci_flbbcd_chlor_units: "chlorophyll", sci_flntu_chlor_units: "chlorophyll", sci_flntu_turb_units: "turbidity",
    sci_flbbcd_bb_units: "backscatter", sci_flbbcd_cdom_units: "CDOM", sci_oxy4_oxygen: "oxygen", sci_oxy4_saturation: "oxygen saturation",
    m_water_vx: "estimated current towards east", m_water_vy: "estimated current towards north",
    current_x: "current towards east", current_y: "current towards north",
    true_current_x: "true current towards east", true_current_y: "true current towards north",
  }],
  ["Vehicle", {
    m_ballast_pumped: "pump", c_ballast_pumped: "commanded pump volume", m_battpos: "battery position", m_battery: "battery", m_speed: "speed",
    m_de_oil_vol: "oil volume", c_de_oil_vol: "commanded oil volume", m_fin: "fin", m_coulomb_current: "current drawn", m_coulomb_amphr_total: "charge used", power: "power",
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

const names = new Map(groups.flatMap(([, list]) => Object.entries(list)));

/** Whether the page has a name of its own for a column. */
export const hasName = (column: string) => names.has(column);

/** The name of a column, its own if the page has no other. */
export function nameOf(flight: Flight, column: string): string {
  const logged = flight.facts.logged.find((l) => l.column === column);
  return logged ? `“${logged.text}”: ${logged.value}` : names.get(column) ?? column;
}

/** "Temperature (°C)". */
export function titleOf(flight: Flight, column: Column): string {
  const name = nameOf(flight, column.name);
  const unit = shownUnit(column.unit);
  const title = names.has(column.name) ? name[0].toUpperCase() + name.slice(1) : name;
  return unit === "" ? title : `${title} (${unit})`;
}

/** What an instrument measures along the track, in the order in which it is offered. */
const instruments: [RegExp, string][] = [
  [/^sci_water_temp$/, "temperature"], [/_chlor_units$/, "chlorophyll"], [/_oxygen$/, "oxygen"], [/_turb_units$/, "turbidity"],
  [/_bb_units$/, "backscatter"], [/_cdom_units$/, "CDOM"], [/^sci_water_cond$/, "conductivity"],
];

/** A quantity of the water along the track. */
export interface Quantity { column: string; title: string; unit: string; values: Values }

/** The quantities that the flight's instruments measured. */
export function quantitiesOf(flight: Flight): Quantity[] {
  return instruments.flatMap(([pattern, title]) => flight.columns.filter((c) => pattern.test(c.name)).flatMap((c) => {
    const values = flight.column(c.name);
    return values ? [{ column: c.name, title, unit: c.unit, values }] : [];
  }));
}
