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

/** Little to much, for what lives or drifts in the water; and for all else. */
const greenStops: [number, string][] = [[0, "#d8d27a"], [0.25, "#8fb84a"], [0.5, "#3f9150"], [0.75, "#1c6650"], [1, "#0d2f2b"]];
const otherStops: [number, string][] = [[0, "#440154"], [0.25, "#3b528b"], [0.5, "#21918c"], [0.75, "#5ec962"], [1, "#d2c521"]];
/** The end of the thermal scale is too pale for a line on white. */
const palest = 0.93;

const stateColours = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442"];
export const layeredColour = "#98a2ac";

function parse(hex: string): Rgb {
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)) as Rgb;
}

/** The colour at 0 (least) to 1 (most). */
export type Scale = (x: number) => Rgb;

function scaleOf(list: [number, string][]): Scale {
  const stops = list.map(([at, hex]) => ({ at, rgb: parse(hex) }));
  return (x) => {
    const clamped = Math.min(1, Math.max(0, x));
    const upper = Math.max(1, stops.findIndex((s) => s.at >= clamped));
    const [a, b] = [stops[upper - 1], stops[upper]];
    const part = (clamped - a.at) / (b.at - a.at);
    return a.rgb.map((v, i) => Math.round(v + (b.rgb[i] - v) * part)) as Rgb;
  };
}

/** The thermal scale, for the ground of a chart. */
export const thermal = scaleOf(thermalStops);
const thermalLine: Scale = (x) => thermal(x * palest);
const greens = scaleOf(greenStops);
/** For all that has no scale of its own. */
export const otherScale = scaleOf(otherStops);

/** The scale in which lines of a quantity are drawn. */
export function scaleFor(title: string): Scale {
  if (title === "temperature") return thermalLine;
  return ["chlorophyll", "turbidity", "backscatter", "CDOM"].includes(title) ? greens : otherScale;
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
