// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The main chart: depth over time on the temperature field, as in Figure 5 of the paper. */

import uPlot from "uplot";
import { colourChooser, Colouring, colouringsOf, paintColouring } from "./colouring";
import { FieldImage, fieldImage } from "./field_image";
import { Flight, Values } from "./flight";
import { fixed, niceStep, quantity, shownUnit } from "./format";
import { css, theme, thermal } from "./palette";
import { markedEvents, paintControl, paintEvents, paintStates, stripHeight } from "./strip";
import { Line, TimeChart } from "./time_chart";
import { View } from "./view";

export const rightMargin = 74;

function linesOf(flight: Flight, onField: boolean, coloured: boolean): Line[] {
  const lines: Line[] = [];
  const add = (name: string, line: Omit<Line, "values">) => {
    const values = flight.column(name);
    if (values) lines.push({ ...line, values });
  };
  // On the field, light lines with a dark edge read on warm and on cold water alike.
  const edge = (width: number) => (onField ? { halo: { colour: "rgb(7 12 22 / .78)", width } } : {});
  const [main, commanded, pale] = onField ? ["#ffffff", "#9df5d8", "#ffffff"] : ["ink", "kind-hook", "muted"];
  add("isotherm_depth", { label: "marked isotherm", colour: pale, width: 1.5, dash: [1.5, 4.5], ...edge(3) });
  add("commanded_top", { label: "commanded range", colour: commanded, width: 1.5, stepped: true, ...edge(3.5) });
  add("commanded_bottom", { label: "commanded range", colour: commanded, width: 1.5, stepped: true, ...edge(3.5) });
  add("hook_depth", { label: "commanded target", colour: commanded, width: 1.5, dash: [6, 4], stepped: true, hidden: true, ...edge(3.5) });
  const measured = flight.column("m_depth") !== null;
  add("true_depth", { label: "true depth", colour: measured ? "#ffb3c7" : main, width: measured ? 1.3 : 2.4, hidden: measured, ...edge(4.8) });
  add("sim_depth", { label: "simulated flight", colour: "simulated", width: 1.6, dash: [6, 3] });
  add("m_depth", { label: "measured depth", colour: main, width: coloured ? 1 : 2.4, ...edge(5) });
  return lines;
}

/** From the surface to a little below all that is drawn. */
function depthRange(lines: Line[]): [number, number] {
  let [least, greatest] = [0, 0];
  for (const line of lines.filter((l) => !l.hidden)) {
    for (const value of line.values) {
      if (value === null) continue;
      least = Math.min(least, value);
      greatest = Math.max(greatest, value);
    }
  }
  return [least, greatest > 0 ? Math.max(greatest * 1.08, 2) : 10];
}

function paintGround(u: uPlot, field: FieldImage | null): void {
  const { ctx } = u;
  const { left, top, width, height } = u.bbox;
  ctx.save();
  ctx.fillStyle = theme("water");
  ctx.fillRect(left, top, width, height);
  if (field) {
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    ctx.imageSmoothingEnabled = true;
    const everywhere = field.times[0] === -Infinity;
    const [x0, x1] = everywhere ? [left, left + width] : field.times.map((t) => u.valToPos(t, "x", true));
    const [y0, y1] = field.depths.map((d) => u.valToPos(d, "y", true));
    ctx.drawImage(field.canvas, x0, y0, x1 - x0, y1 - y0);
  }
  ctx.restore();
}

/** The seabed where it comes into view. */
function paintSeabed(u: uPlot, times: number[], depths: Values): void {
  const { ctx } = u;
  const bottom = u.bbox.top + u.bbox.height;
  ctx.save();
  ctx.beginPath();
  ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
  ctx.clip();
  ctx.fillStyle = theme("seabed");
  ctx.beginPath();
  let last = NaN;
  depths.forEach((depth, row) => {
    if (depth === null) {
      if (!Number.isNaN(last)) ctx.lineTo(last, bottom);
      last = NaN;
      return;
    }
    const x = u.valToPos(times[row], "x", true);
    if (Number.isNaN(last)) ctx.moveTo(x, bottom);
    ctx.lineTo(x, Math.min(u.valToPos(depth, "y", true), bottom));
    last = x;
  });
  if (!Number.isNaN(last)) ctx.lineTo(last, bottom);
  ctx.fill();
  ctx.restore();
}

function paintColourBar(u: uPlot, [low, high]: [number, number], unit: string): void {
  const { ctx } = u;
  const scale = devicePixelRatio;
  const { top, height } = u.bbox;
  const left = u.bbox.left + u.bbox.width + 14 * scale;
  const width = 13 * scale;
  ctx.save();
  const gradient = ctx.createLinearGradient(0, top, 0, top + height);
  for (let i = 0; i <= 20; ++i) gradient.addColorStop(i / 20, css(thermal(1 - i / 20)));
  ctx.fillStyle = gradient;
  ctx.fillRect(left, top, width, height);
  ctx.fillStyle = ctx.strokeStyle = theme("muted");
  ctx.font = `${12 * scale}px system-ui, sans-serif`;
  ctx.textBaseline = "middle";
  ctx.textAlign = "left";
  const step = niceStep(Math.max(high - low, 1e-6), 8);
  const digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  for (let value = Math.ceil(low / step) * step; high > low && value <= high + step * 1e-6; value += step) {
    const y = top + height * (1 - (value - low) / (high - low));
    ctx.fillRect(left + width, y - scale / 2, 4 * scale, scale);
    ctx.fillText(fixed(value, digits), left + width + 8 * scale, y);
  }
  ctx.textBaseline = "alphabetic";
  ctx.fillText(shownUnit(unit), left, top - 8 * scale);
  ctx.restore();
}

/** `chooser`: what else belongs in the chart's head. */
interface DepthChart { chart: TimeChart; lines: Line[]; onField: boolean; chooser: HTMLElement[] }

export function depthChart(host: HTMLElement, flight: Flight, view: View): DepthChart {
  const field = flight.field ? fieldImage(flight.field) : null;
  const colourings = colouringsOf(flight);
  let colouring: Colouring | undefined = colourings[0];
  const lines = linesOf(flight, field !== null, colouring !== undefined);
  const seabed = flight.column("water_depth");
  const states = flight.log && !flight.column("state") ? [] : flight.spans((row) => flight.pilot(row));
  const control = flight.spans((row) => flight.inControl(row));
  const events = markedEvents(flight);
  const depth = flight.firstOf("m_depth", "true_depth");
  const depths = depth ? flight.column(depth) : null;
  const describe = (row: number) => {
    const value = depths?.[row] ?? null;
    return `${value === null ? "depth not known" : `depth ${quantity(value, "m")}`}, ${flight.pilotName(flight.pilot(row))}`;
  };
  const chart = new TimeChart(host, flight, view, {
    label: "Depth", height: 480, inverted: true, range: depthRange(lines), lines,
    top: stripHeight, right: rightMargin, describe,
    paintUnder: (u) => {
      paintGround(u, field);
      if (seabed) paintSeabed(u, flight.times, seabed);
      if (colouring && depths) paintColouring(u, flight.times, depths, colouring);
    },
    paintOver: (u) => {
      paintStates(u, states, (pilot) => flight.pilotName(pilot));
      if (!flight.log) paintControl(u, control);
      paintEvents(u, events);
      if (field && flight.field) paintColourBar(u, field.range, flight.field.unit);
      if (colouring) paintColourBar(u, colouring.range, colouring.unit);
    },
  });
  attachTips(chart.plot, flight, events);
  const choose = (index: number) => { colouring = colourings[index]; chart.redraw(); };
  return { chart, lines, onField: field !== null, chooser: colourings.length === 0 ? [] : [colourChooser(colourings, choose)] };
}

/** What happened under the pointer, as a small note beside it. */
function attachTips(u: uPlot, flight: Flight, events: ReturnType<typeof markedEvents>): void {
  const tip = document.createElement("div");
  tip.className = "tip";
  tip.hidden = true;
  u.root.append(tip);
  const reach = 6;
  u.root.addEventListener("pointermove", (event) => {
    const box = u.over.getBoundingClientRect();
    const x = event.clientX - box.left;
    const near = x < -reach || x > box.width + reach ? []
      : events.filter((e) => Math.abs(u.valToPos(e.time, "x") - x) <= reach).slice(0, 5);
    tip.hidden = near.length === 0;
    if (tip.hidden) return;
    tip.replaceChildren(...near.flatMap((e) => {
      const head = document.createElement("b");
      head.textContent = e.what;
      const rest = document.createElement("span");
      rest.textContent = `${e.kind} at ${flight.clock(e.time)}${e.missionTime === null ? "" : `, mission time ${fixed(e.missionTime, 0)} s`}`;
      const why = document.createElement("span");
      why.textContent = e.why;
      return e.why === "" ? [head, rest] : [head, rest, why];
    }));
    const root = u.root.getBoundingClientRect();
    const left = Math.min(event.clientX - root.left + 14, root.width - tip.offsetWidth - 4);
    tip.style.transform = `translate(${Math.max(left, 0)}px, ${event.clientY - root.top + 16}px)`;
  });
  u.root.addEventListener("pointerleave", () => { tip.hidden = true; });
}
