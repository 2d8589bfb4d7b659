// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** What the instruments of a logged flight measured, as the colour of its depth: a log has no field of the water. */

import uPlot from "uplot";
import { element } from "./dom";
import { Flight, Values } from "./flight";
import { css, thermal } from "./palette";

/** What colours the depth: values between `range` go from cold to warm. */
export interface Colouring { title: string; unit: string; values: Values; range: [number, number] }

const titles: [RegExp, string][] = [
  [/^sci_water_temp$/, "temperature"], [/_chlor_units$/, "chlorophyll"], [/_oxygen$/, "oxygen"], [/_turb_units$/, "turbidity"],
  [/_bb_units$/, "backscatter"], [/_cdom_units$/, "CDOM"], [/^sci_water_cond$/, "conductivity"],
];

/** All but the lowest and the highest hundredth, which are often a fault or a bubble. */
function usual(values: Values): [number, number] {
  const known = values.filter((v): v is number => v !== null).sort((a, b) => a - b);
  const at = (part: number) => known[Math.round((known.length - 1) * part)];
  return [at(0.01), at(0.99)];
}

/** The quantities that can colour the depth, in the order of `titles`; none for a simulated flight, which has its field. */
export function colouringsOf(flight: Flight): Colouring[] {
  if (!flight.log) return [];
  return titles.flatMap(([name, title]) => flight.columns.filter((c) => name.test(c.name)).flatMap((c) => {
    const values = flight.column(c.name);
    return values ? [{ title, unit: c.unit, values, range: usual(values) }] : [];
  }));
}

/** A wide line along `depths` in the colours of `colouring`. */
export function paintColouring(u: uPlot, times: number[], depths: Values, colouring: Colouring): void {
  const { ctx } = u;
  const { values, range: [low, high] } = colouring;
  const [from, to] = [u.scales.x.min ?? 0, u.scales.x.max ?? 0];
  ctx.save();
  ctx.beginPath();
  ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
  ctx.clip();
  ctx.lineWidth = 7 * devicePixelRatio;
  for (let row = 1; row < times.length; ++row) {
    const [a, b, value] = [depths[row - 1], depths[row], values[row]];
    if (a === null || b === null || value === null || times[row] < from || times[row - 1] > to) continue;
    ctx.strokeStyle = css(thermal(high > low ? (value - low) / (high - low) : 0.5));
    ctx.beginPath();
    ctx.moveTo(u.valToPos(times[row - 1], "x", true), u.valToPos(a, "y", true));
    ctx.lineTo(u.valToPos(times[row], "x", true), u.valToPos(b, "y", true));
    ctx.stroke();
  }
  ctx.restore();
}

/** A list to choose one of `colourings` from; `choose` gets its number, -1 for none. */
export function colourChooser(colourings: Colouring[], choose: (index: number) => void): HTMLElement {
  const list = element("select", { "aria-label": "Colour of the depth" },
    ...colourings.map((c, i) => element("option", { value: String(i) }, c.title)), element("option", { value: "-1" }, "none"));
  list.addEventListener("change", () => choose(Number(list.value)));
  return element("label", { class: "chooser" }, "colour: ", list);
}
