// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The charts below the depth, on the same time: what the mission lists and logs, and what was commanded beside what was measured. */

import { Flight, Values } from "./flight";
import { digitsFor, fixed, quantity, shownFactor, shownUnit, utcMark } from "./format";
import { rightMargin } from "./depth_chart";
import { chartedLogs } from "./logged";
import { hasName, nameOf, quantitiesOf } from "./names";
import { ChartOptions, Line, TimeChart } from "./time_chart";
import { View } from "./view";

interface Panel {
  title: string;
  measured: string;
  commanded?: string;
  /** The least height of the range, in the column's unit. */
  least: number;
  /** Wraps round at 360°. */
  round?: boolean;
  /** It has a value only now and then. */
  points?: boolean;
  /** The title is the vehicle's own name, which stays as it is. */
  own?: boolean;
}

const panels: Panel[] = [
  { title: "Pitch", measured: "m_pitch", commanded: "c_pitch", least: 0.2 },
  { title: "Heading, magnetic", measured: "m_heading", commanded: "c_heading", least: 0.35, round: true },
  { title: "Buoyancy pump", measured: "m_ballast_pumped", commanded: "c_ballast_pumped", least: 20 },
  { title: "Oil volume", measured: "m_de_oil_vol", commanded: "c_de_oil_vol", least: 20 },
  { title: "Vertical speed", measured: "m_depth_rate", least: 0.1 },
  { title: "Battery", measured: "m_battery", least: 0.5 },
  { title: "Power", measured: "power", least: 1 },
  { title: "Energy used", measured: "energy", least: 1 },
];

/** In the shown unit; a heading that passes north leaves a gap instead of a stroke across the chart. */
function shown(values: Values, unit: string, round: boolean): Values {
  const factor = shownFactor(unit);
  const out: Values = values.map((v) => (v === null ? null : v * factor));
  if (!round) return out;
  return out.map((v, i) => (v !== null && i > 0 && out[i - 1] !== null && Math.abs(v - out[i - 1]!) > 180 ? null : v));
}

/** Whole turns are added, so that a track across 180° is no stroke across the chart. */
function unwrapped(values: Values): Values {
  let last: number | null = null;
  return values.map((v) => {
    if (v === null) return v;
    last = last === null ? v : v + 360 * Math.round((last - v) / 360);
    return last;
  });
}

const isLongitude = (column: string) => /(^|_)lon(gitude)?$/.test(column);

/** How the marks of the axis of values are written, where they are no plain numbers. */
function marksOf(column: string, unit: string): Pick<ChartOptions, "mark"> {
  if (unit === "timestamp") return { mark: utcMark };
  return isLongitude(column) ? { mark: (value, step) => fixed(value - 360 * Math.round(value / 360), digitsFor(step)) } : {};
}

function rangeOf(lines: Line[], least: number): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const line of lines) {
    for (const value of line.values) {
      if (value === null) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  // A value that never changes still gets a range around it.
  const constant = high === 0 ? 1 : Math.abs(high) * 0.1;
  const half = Math.max((high - low) * 0.56, least / 2, high > low ? 0 : constant);
  return [(low + high) / 2 - half, (low + high) / 2 + half];
}

/** The charts of `panels`, then those of what the mission lists and of what instruments measured. */
function panelsOf(flight: Flight): Panel[] {
  const usual = panels.filter((p) => flight.column(p.measured));
  const taken = new Set(["m_depth", ...usual.map((p) => p.measured)]);
  const listed = [...flight.facts.listed, ...quantitiesOf(flight).map((q) => q.column)].flatMap((name) => {
    const column = flight.columns.find((c) => c.name === name);
    if (!column || taken.has(name) || !flight.column(name)) return [];
    taken.add(name);
    return [{ title: nameOf(flight, name), measured: name, least: 0, own: !hasName(name) }];
  });
  const logged = chartedLogs(flight)
    .map((l) => ({ title: `log ${nameOf(flight, l.column)}`, measured: l.column, least: 0, points: true }));
  // What the mission is about comes first.
  return [...listed, ...logged, ...usual];
}

const capital = (text: string) => text[0].toUpperCase() + text.slice(1);

/** What was commanded, if anything was, and what was measured, in the shown unit. */
function linesOf(flight: Flight, p: Panel, unit: string): Line[] {
  const line = (label: string, column: string, more: Partial<Line>): Line => ({
    label, head: `${column}${shownUnit(unit) === "" ? "" : ` (${shownUnit(unit)})`}`,
    values: isLongitude(column) ? unwrapped(flight.column(column) as Values) : shown(flight.column(column) as Values, unit, p.round ?? false), all: shown(flight.column(column) as Values, unit, false), colour: "ink", width: 1.6, ...more });
  const commanded = p.commanded && flight.column(p.commanded) ? [line("commanded", p.commanded, { colour: "commanded", stepped: true })] : [];
  return [...commanded, line(p.points ? "logged" : "measured", p.measured, p.points ? { width: 0, points: true } : {})];
}

/** One chart for each quantity that is known, made in the host that `place` gives. */
export function otherCharts(flight: Flight, view: View, place: (title: string, lines: Line[], chart: () => TimeChart) => HTMLElement): TimeChart[] {
  return panelsOf(flight).map((p) => {
    const unit = flight.columns.find((c) => c.name === p.measured)?.unit ?? "";
    const measured = flight.column(p.measured) as Values;
    const lines = linesOf(flight, p, unit);
    const name = p.own ? p.title : capital(p.title);
    const title = shownUnit(unit) === "" ? name : `${name} (${shownUnit(unit)})`;
    const chart: TimeChart = new TimeChart(place(title, lines, () => chart), flight, view, {
      label: p.title, height: 132, top: 8, right: rightMargin, lines,
      range: rangeOf(lines, p.least * shownFactor(unit)), ...marksOf(p.measured, unit),
      describe: (row) => {
        const value = measured[row] ?? null;
        return value === null ? `${p.title} not known` : `${p.title} ${quantity(value, unit)}`;
      },
    });
    return chart;
  });
}
