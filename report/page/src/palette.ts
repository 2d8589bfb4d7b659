// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** Colours: the thermal scale, the states' (told apart by colour-blind eyes: Okabe and Ito 2008), the theme's. */

import { Pilot } from "./flight";

type Rgb = [number, number, number];

/** Cold to warm, rising in lightness throughout so that it also reads in grey. */
const thermalStops: [number, string][] = [
  [0, "#0b2748"], [0.14, "#253a7d"], [0.32, "#5f4693"], [0.48, "#97528a"], [0.63, "#cb6068"],
  [0.77, "#ec8549"], [0.9, "#f6bb4a"], [1, "#f5ee9a"],
];

const stateColours = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442"];
export const layeredColour = "#98a2ac";

function parse(hex: string): Rgb {
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)) as Rgb;
}

const stops = thermalStops.map(([at, hex]) => ({ at, rgb: parse(hex) }));

/** The thermal scale at 0 (coldest) to 1 (warmest). */
export function thermal(x: number): Rgb {
  const clamped = Math.min(1, Math.max(0, x));
  const upper = Math.max(1, stops.findIndex((s) => s.at >= clamped));
  const [a, b] = [stops[upper - 1], stops[upper]];
  const part = (clamped - a.at) / (b.at - a.at);
  return a.rgb.map((v, i) => Math.round(v + (b.rgb[i] - v) * part)) as Rgb;
}

export const css = (rgb: Rgb): string => `rgb(${rgb[0]} ${rgb[1]} ${rgb[2]})`;

/** The colour of whoever decides; states beyond the seventh begin again. */
export function pilotColour(pilot: Pilot): string {
  if (pilot === "sbc") return stateColours[0];
  return pilot === "layered" || !(pilot >= 0) ? layeredColour : stateColours[Math.floor(pilot) % stateColours.length];
}

/** Black or white, whichever is read more easily on `hex` (relative luminance, WCAG 2). */
export function inkOn(hex: string): string {
  const [r, g, b] = parse(hex).map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.24 ? "#10161d" : "#ffffff";
}

/** A colour of the theme in force: a custom property of style.css without its dashes. */
export function theme(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
