// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The water as the instruments saw it: sections over time and depth, profiles over depth, temperature over salinity. */

import { Colouring, colouringOf, colouringsOf, paintColourBar, paintColouring } from "./colouring";
import { rightMargin } from "./depth_chart";
import { byId, element } from "./dom";
import { saveButtons, titled } from "./downloads";
import { Flight, Values } from "./flight";
import { digitsFor, fixed, niceStep, quantity, shownUnit } from "./format";
import { Quantity, quantitiesOf } from "./names";
import { otherScale } from "./palette";
import { salinity, sigmaT } from "./seawater";
import { TimeChart } from "./time_chart";
import { View } from "./view";
import { Isoline, XyChart, XyPoint } from "./xy_chart";

const sectionHeight = 190;
const plotHeight = 300;
/** More points than this in one plot only cover each other. */
const mostPoints = 12_000;
/** Conductivity that varies less than this, S/m, is that of a simulator's uniform water: it says nothing of salinity. */
const leastConductivity = 1e-3;

const titleWith = (title: string, unit: string) => {
  const name = /^[A-Z]/.test(title) ? title : title[0].toUpperCase() + title.slice(1);
  return shownUnit(unit) === "" ? name : `${name} (${shownUnit(unit)})`;
};

const both = (a: Values, b: Values, of: (x: number, y: number, row: number) => number): Values =>
  a.map((x, row) => { const y = b[row]; return x === null || y === null ? null : of(x, y, row); });

/** The latest value of each row or the one before: instruments of a log do not measure in the same rows. */
function held(values: Values, times: number[]): Values {
  const longest = 10;
  let last = -1;
  return values.map((v, row) => {
    if (v !== null) last = row;
    return last >= 0 && times[row] - times[last] <= longest ? values[last] : null;
  });
}

/** Salinity and sigma-t, if conductivity and temperature were measured and the water is not uniform. */
export function derived(flight: Flight, depths: Values): Quantity[] {
  const conductivity = flight.column("sci_water_cond");
  const temperature = flight.column("sci_water_temp");
  if (!conductivity || !temperature) return [];
  const range = colouringOf({ column: "", title: "", unit: "", values: conductivity }).range;
  if (range[1] - range[0] < leastConductivity) return [];
  const pressure = flight.column("sci_water_pressure");
  const bar = pressure ? held(pressure, flight.times) : null;
  // A metre of water is a dbar, as near as a shallow glider's salinity needs it.
  const dbar = (row: number) => (bar?.[row] != null ? (bar[row] as number) * 10 : depths[row] ?? 0);
  const salt = both(conductivity, held(temperature, flight.times), (c, t, row) => (c > 0.1 ? salinity(c, t, dbar(row)) : NaN))
    .map((s) => (s !== null && s > 2 && s < 42 ? s : null));
  const sigma = both(salt, held(temperature, flight.times), (s, t) => sigmaT(s, t));
  return [
    { column: "salinity", title: "salinity", unit: "", values: salt },
    { column: "sigma_t", title: "sigma-t", unit: "kg/m3", values: sigma },
  ].filter((q) => q.values.some((v) => v !== null));
}

function section(host: HTMLElement, flight: Flight, view: View, depths: Values, colouring: Colouring, deepest: number): TimeChart {
  const title = titleWith(colouring.title, colouring.unit);
  const place = element("div", { class: "chart" });
  const head = element("div", { class: "head" }, element("h3", {}, title));
  host.append(head, place);
  const chart = new TimeChart(place, flight, view, {
    label: `${colouring.title} by depth`, height: sectionHeight, inverted: true, range: [0, deepest * 1.05],
    lines: [{ label: "depth", head: "depth (m)", values: depths, colour: "ink", width: 0, hidden: true }], top: 22, right: rightMargin,
    paintUnder: (u) => paintColouring(u, flight.times, depths, colouring, 5),
    paintOver: (u) => paintColourBar(u, colouring.range, colouring.unit, colouring.scale),
    describe: (row) => {
      const value = colouring.values[row] ?? null;
      return value === null ? `${colouring.title} not known` : `${colouring.title} ${quantity(value, colouring.unit)}`;
    },
  });
  head.append(saveButtons(flight, {
    title: `${title} section`,
    picture: () => titled(chart.plot.ctx.canvas, chart.plot.ctx.canvas.width, chart.plot.ctx.canvas.height, title),
    table: () => ({
      head: ["time (s)", "depth (m)", title],
      rows: flight.times.flatMap((time, row) => (colouring.values[row] === null ? [] : [[time, depths[row], colouring.values[row]]])),
    }),
  }));
  return chart;
}

function pointsOf(flight: Flight, x: Values, y: Values): XyPoint[] {
  const last = flight.times[flight.times.length - 1] || 1;
  const all = x.flatMap((v, row) => (v === null || y[row] === null ? [] : [{ x: v, y: y[row] as number, part: flight.times[row] / last }]));
  const step = Math.ceil(all.length / mostPoints);
  return all.filter((_, i) => i % step === 0);
}

function plot(host: HTMLElement, flight: Flight, options: { title: string; xTitle: string; yTitle: string; inverted?: boolean; points: XyPoint[]; isolines?: Isoline[] }): XyChart | null {
  if (options.points.length === 0) return null;
  const place = element("div", { class: "plot" });
  const head = element("div", { class: "head" }, element("h3", {}, options.title));
  const figure = element("div", { class: "figure" }, head, place);
  host.append(figure);
  const chart = new XyChart(place, { ...options, label: options.title, colours: otherScale, height: plotHeight });
  head.append(saveButtons(flight, {
    title: options.title,
    picture: () => titled(chart.canvas, chart.canvas.width, chart.canvas.height, options.title),
    table: () => ({ head: [options.xTitle, options.yTitle], rows: options.points.map((p) => [p.x, p.y]) }),
  }));
  return chart;
}

/** Lines of equal sigma-t over the salinities and temperatures of `points`. */
export function densityLines(points: XyPoint[]): Isoline[] {
  const span = (of: (p: XyPoint) => number) => points.reduce(([a, b], p) => [Math.min(a, of(p)), Math.max(b, of(p))], [Infinity, -Infinity]);
  const [salts, temperatures] = [span((p) => p.x), span((p) => p.y)];
  const margin = (s: number[]) => Math.max((s[1] - s[0]) * 0.06, 1e-3);
  const [s0, s1] = [Math.max(salts[0] - margin(salts), 0), salts[1] + margin(salts)];
  const [t0, t1] = [temperatures[0] - margin(temperatures), temperatures[1] + margin(temperatures)];
  const [least, most] = [sigmaT(s0, t1), sigmaT(s1, t0)];
  const step = niceStep(most - least, 8);
  const out: Isoline[] = [];
  for (let sigma = Math.ceil(least / step) * step; sigma < most; sigma += step) {
    const line: { x: number; y: number }[] = [];
    for (let i = 0; i <= 40; ++i) {
      const temperature = t0 + ((t1 - t0) * i) / 40;
      const salt = saltAt(sigma, temperature);
      if (salt >= s0 && salt <= s1) line.push({ x: salt, y: temperature });
    }
    if (line.length > 1) out.push({ label: fixed(sigma, digitsFor(step)), points: line });
  }
  return out;
}

/** The salinity at which water of this temperature has this sigma-t: density grows with salinity, so halving finds it. */
function saltAt(sigma: number, temperature: number): number {
  let [low, high] = [-1e-9, 45];
  if (sigmaT(Math.max(low, 0), temperature) > sigma) return -1;
  for (let i = 0; i < 40; ++i) {
    const middle = (low + high) / 2;
    if (sigmaT(Math.max(middle, 0), temperature) < sigma) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

/** Fills the card of the water; returns its charts, or hides it when no instrument measured anything. */
export function water(flight: Flight, view: View): { sections: TimeChart[]; plots: XyChart[] } {
  const depth = flight.firstOf("m_depth", "true_depth");
  const depths = depth ? held(flight.column(depth) as Values, flight.times) : [];
  const measured = depth ? [...quantitiesOf(flight), ...derived(flight, depths)] : [];
  byId("water-card").hidden = measured.length === 0;
  if (measured.length === 0) return { sections: [], plots: [] };
  const deepest = depths.reduce((a: number, d) => Math.max(a, d ?? 0), 1);
  const known = [...colouringsOf(flight), ...derived(flight, depths).map(colouringOf)];
  const sections = known.map((c) => section(byId("sections"), flight, view, depths, c, deepest));
  const profiles = measured.map((q) => {
    const title = titleWith(q.title, q.unit);
    return plot(byId("profiles"), flight, { title: `${title} by depth`, xTitle: title, yTitle: "depth (m)", inverted: true, points: pointsOf(flight, q.values, depths) });
  });
  const salt = measured.find((q) => q.column === "salinity");
  const temperature = flight.column("sci_water_temp");
  const points = salt && temperature ? pointsOf(flight, salt.values, held(temperature, flight.times)) : [];
  const diagram = plot(byId("profiles"), flight, {
    title: "T-S diagram", xTitle: "Salinity", yTitle: "Temperature (°C)", points, isolines: points.length === 0 ? [] : densityLines(points),
  });
  return { sections, plots: [...profiles, diagram].filter((p): p is XyChart => p !== null) };
}
