// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** What the instruments measured, as the colour of the depth. */

import uPlot from "uplot";
import { element } from "./dom";
import { Flight, Values } from "./flight";
import { fixed, niceStep, shownUnit } from "./format";
import { Quantity, quantitiesOf } from "./names";
import { css, Scale, scaleFor, theme } from "./palette";

/** What colours the depth: values between `range` go from one end of the scale to the other. */
export interface Colouring extends Quantity { range: [number, number]; scale: Scale }

/** All but the lowest and the highest hundredth, which are often a fault or a bubble. */
function usual(values: Values): [number, number] {
  const known = values.filter((v): v is number => v !== null).sort((a, b) => a - b);
  const at = (part: number) => known[Math.round((known.length - 1) * part)];
  return [at(0.01), at(0.99)];
}

export function colouringOf(quantity: Quantity): Colouring {
  return { ...quantity, range: usual(quantity.values), scale: scaleFor(quantity.title) };
}

/** The quantities that can colour the depth. */
export function colouringsOf(flight: Flight): Colouring[] { return quantitiesOf(flight).map(colouringOf); }

/** The number of the one that the mission itself looks at: the first that its conditions read, or else that it lists; -1: there is none. */
export function missionsOwn(flight: Flight, colourings: Colouring[]): number {
  const wanted = [...flight.facts.read, ...flight.facts.listed].map((name) => colourings.findIndex((c) => c.column === name));
  return wanted.find((i) => i >= 0) ?? (colourings.length > 0 ? 0 : -1);
}

const shades = 64;

/** A wide line along `depths` in the colours of `colouring`. */
export function paintColouring(u: uPlot, times: number[], depths: Values, colouring: Colouring, width = 7): void {
  const { ctx } = u;
  const { values, range: [low, high], scale } = colouring;
  const [from, to] = [u.scales.x.min ?? 0, u.scales.x.max ?? 0];
  // One path for each shade: a path for each row would take seconds.
  const paths = new Map<number, Path2D>();
  for (let row = 1; row < times.length; ++row) {
    const [a, b, value] = [depths[row - 1], depths[row], values[row]];
    if (a === null || b === null || value === null || times[row] < from || times[row - 1] > to) continue;
    const part = high > low ? Math.min(Math.max((value - low) / (high - low), 0), 1) : 0.5;
    const shade = Math.round(part * (shades - 1));
    const path = paths.get(shade) ?? new Path2D();
    paths.set(shade, path);
    path.moveTo(u.valToPos(times[row - 1], "x", true), u.valToPos(a, "y", true));
    path.lineTo(u.valToPos(times[row], "x", true), u.valToPos(b, "y", true));
  }
  ctx.save();
  ctx.beginPath();
  ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
  ctx.clip();
  ctx.lineWidth = width * devicePixelRatio;
  ctx.lineCap = "round";
  paths.forEach((path, shade) => { ctx.strokeStyle = css(scale(shade / (shades - 1))); ctx.stroke(path); });
  ctx.restore();
}

/** The scale of colours to the right of the plot. */
export function paintColourBar(u: uPlot, [low, high]: [number, number], unit: string, colours: Scale): void {
  const { ctx } = u;
  const scale = devicePixelRatio;
  const { top, height } = u.bbox;
  const left = u.bbox.left + u.bbox.width + 14 * scale;
  const width = 13 * scale;
  ctx.save();
  const gradient = ctx.createLinearGradient(0, top, 0, top + height);
  for (let i = 0; i <= 20; ++i) gradient.addColorStop(i / 20, css(colours(1 - i / 20)));
  ctx.fillStyle = gradient;
  ctx.fillRect(left, top, width, height);
  ctx.fillStyle = ctx.strokeStyle = theme("muted");
  ctx.font = `${12 * scale}px system-ui, sans-serif`;
  ctx.textBaseline = "middle";
  ctx.textAlign = "left";
  const step = niceStep(Math.max(high - low, 1e-6), height / scale > 300 ? 8 : 4);
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

/** A list to choose one of `titles` from; `choose` gets its number. */
export function colourChooser(titles: string[], chosen: number, choose: (index: number) => void): HTMLElement {
  const list = element("select", { "aria-label": "Colour of the depth" }, ...titles.map((title, i) => element("option", { value: String(i) }, title)));
  list.value = String(chosen);
  list.addEventListener("change", () => choose(Number(list.value)));
  return element("label", { class: "chooser" }, "colour: ", list);
}
