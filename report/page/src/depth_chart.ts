// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The main chart: depth over time in the colours of what was measured, or on the temperature field as in Figure 5 of the paper. */

import uPlot from "uplot";
import { colourChooser, Colouring, colouringsOf, missionsOwn, paintColourBar, paintColouring } from "./colouring";
import { FieldImage, fieldImage } from "./field_image";
import { Flight, Values } from "./flight";
import { fixed, quantity } from "./format";
import { theme, thermal } from "./palette";
import { markedEvents, paintControl, paintEvents, paintStates, stripHeight } from "./strip";
import { Line, TimeChart } from "./time_chart";
import { View } from "./view";

export const rightMargin = 74;

function linesOf(flight: Flight, coloured: () => boolean): Line[] {
  const lines: Line[] = [];
  const add = (name: string, line: Omit<Line, "values">) => {
    const values = flight.column(name);
    if (values) lines.push({ ...line, values, head: `${name} (m)` });
  };
  // On the field, light lines with a dark edge read on warm and on cold water alike.
  const edge = (width: number) => (flight.field ? { halo: { colour: "depth-halo", width } } : {});
  add("isotherm_depth", { label: "marked isotherm", colour: "depth-pale", width: 1.5, dash: [1.5, 4.5], ...edge(3) });
  add("commanded_top", { label: "commanded range", colour: "depth-commanded", width: 1.5, stepped: true, ...edge(3.5) });
  add("commanded_bottom", { label: "commanded range", colour: "depth-commanded", width: 1.5, stepped: true, ...edge(3.5) });
  add("hook_depth", { label: "commanded target", colour: "depth-commanded", width: 1.5, dash: [6, 4], stepped: true, hidden: true, ...edge(3.5) });
  const measured = flight.column("m_depth") !== null;
  add("true_depth", { label: "true depth", colour: measured ? "depth-true" : "depth-line", width: measured ? 1.3 : 2.2, hidden: measured, ...edge(4.8) });
  add("sim_depth", { label: "simulated flight", colour: "simulated", width: 1.6, dash: [6, 3] });
  add("m_depth", { label: "measured depth", colour: "depth-line", width: 1.4, onlyIfSparse: coloured, ...edge(4.5) });
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

/** What the depth is drawn on or in: a quantity along it, the water's temperature at all depths, or nothing. */
interface Ground { title: string; colouring?: Colouring; field?: FieldImage }

function groundsOf(colourings: Colouring[], field: FieldImage | null): Ground[] {
  return [...colourings.map((colouring) => ({ title: colouring.title, colouring })),
    ...(field ? [{ title: "temperature of all the water", field }] : []), { title: "none" }];
}

/** `chooser`: what else belongs in the chart's head. */
interface DepthChart { chart: TimeChart; lines: Line[]; chooser: HTMLElement[] }

export function depthChart(host: HTMLElement, flight: Flight, view: View): DepthChart {
  const field = flight.field ? fieldImage(flight.field) : null;
  const colourings = colouringsOf(flight);
  const grounds = groundsOf(colourings, field);
  const first = Math.max(missionsOwn(flight, colourings), 0);
  let ground = grounds[first];
  const lines = linesOf(flight, () => ground.colouring !== undefined);
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
      paintGround(u, ground.field ?? null);
      if (seabed) paintSeabed(u, flight.times, seabed);
      if (ground.colouring && depths) paintColouring(u, flight.times, depths, ground.colouring);
    },
    paintOver: (u) => {
      paintStates(u, states, (pilot) => flight.pilotName(pilot));
      if (!flight.log) paintControl(u, control);
      paintEvents(u, events);
      if (ground.field && flight.field) paintColourBar(u, ground.field.range, flight.field.unit, thermal);
      if (ground.colouring) paintColourBar(u, ground.colouring.range, ground.colouring.unit, ground.colouring.scale);
    },
  });
  attachTips(chart.plot, flight, events);
  const choose = (index: number) => {
    ground = grounds[index];
    // Lines on the field are light with a dark edge, on white they are dark: custom properties of style.css.
    document.documentElement.classList.toggle("on-field", ground.field !== undefined);
    chart.redraw();
  };
  return { chart, lines, chooser: grounds.length < 2 ? [] : [colourChooser(grounds.map((g) => g.title), first, choose)] };
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
