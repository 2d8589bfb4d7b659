// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The lines of latitude and longitude, or of metres where the place is not known, and the scale. */

import { svg } from "./dom";
import { digitsFor, fixed, length, niceStep } from "./format";
import { edge, Frame } from "./map_frame";

/** Steps of a graticule, minutes. */
const minutes = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600];

/** `39° 10.5′ N` with as many decimals as steps of `step` minutes need. */
export function degreeMark(degrees: number, step: number, positive: string, negative: string): string {
  const digits = step >= 1 ? 0 : digitsFor(step);
  const all = Number((Math.abs(degrees) * 60).toFixed(digits));
  const whole = Math.floor(all / 60 + 1e-9);
  const rest = Math.max(all - whole * 60, 0).toFixed(digits);
  const side = all === 0 ? "" : degrees < 0 ? ` ${negative}` : ` ${positive}`;
  return step >= 60 ? `${whole}°${side}` : `${whole}° ${rest.padStart(digits > 0 ? digits + 3 : 2, "0")}′${side}`;
}

interface Mark { at: number; words: string }

/** Marks of degrees between two of them, at most `most`. */
function degreeMarks(from: number, to: number, most: number, positive: string, negative: string): Mark[] {
  const step = minutes.find((m) => ((to - from) * 60) / m <= most) ?? minutes[minutes.length - 1];
  const out: Mark[] = [];
  for (let i = Math.ceil((from * 60) / step); i * step <= to * 60; ++i) {
    out.push({ at: (i * step) / 60, words: degreeMark((i * step) / 60, step, positive, negative) });
  }
  return out;
}

function metreMarks(from: number, to: number, most: number): Mark[] {
  const step = niceStep(to - from, most);
  const out: Mark[] = [];
  for (let v = Math.ceil(from / step) * step; v <= to; v += step) out.push({ at: v, words: step >= 1000 ? `${fixed(v / 1000, 0)} km` : `${fixed(v, 0)} m` });
  return out;
}

/** The marks along both axes, in m east and north. */
function marksOf(frame: Frame): { across: Mark[]; up: Mark[] } {
  const { anchor } = frame;
  const mostAcross = Math.max(1, Math.floor((frame.width - edge.left - edge.right) / 130));
  const mostUp = Math.max(4, Math.floor((frame.height - edge.top - edge.bottom) / 60));
  if (!anchor) return { across: metreMarks(frame.west, frame.east, mostAcross), up: metreMarks(frame.south, frame.north, mostUp) };
  const lon = (x: number) => anchor.lon + (x - anchor.x) / anchor.perLon;
  const lat = (y: number) => anchor.lat + (y - anchor.y) / anchor.perLat;
  return {
    across: degreeMarks(lon(frame.west), lon(frame.east), mostAcross, "E", "W").map((m) => ({ ...m, at: anchor.x + (m.at - anchor.lon) * anchor.perLon })),
    up: degreeMarks(lat(frame.south), lat(frame.north), mostUp, "N", "S").map((m) => ({ ...m, at: anchor.y + (m.at - anchor.lat) * anchor.perLat })),
  };
}

export function graticule(frame: Frame): SVGElement {
  const out = svg("g", { class: "grid" });
  const { across, up } = marksOf(frame);
  const bottom = frame.height - edge.bottom;
  across.forEach(({ at, words }) => {
    const x = frame.x(at);
    out.append(svg("line", { x1: x, x2: x, y1: edge.top, y2: bottom + 4 }));
    // A word at the end of the axis stays on the sheet.
    const anchor = x < edge.left + 30 ? "start" : x > frame.width - edge.right - 30 ? "end" : "middle";
    out.append(svg("text", { x, y: bottom + 17, "text-anchor": anchor }, words));
  });
  up.forEach(({ at, words }) => {
    out.append(svg("line", { x1: edge.left - 4, x2: frame.width - edge.right, y1: frame.y(at), y2: frame.y(at) }));
    out.append(svg("text", { x: edge.left - 8, y: frame.y(at) + 4, "text-anchor": "end" }, words));
  });
  return out;
}

/** Below the plot, where nothing is drawn. */
export function scaleBar(frame: Frame): SVGElement {
  const metres = niceStep((frame.east - frame.west) / 2, 3);
  const width = metres * frame.scale;
  const [right, y] = [frame.width - edge.right, frame.height - 10];
  return svg("g", { class: "scale" },
    svg("path", { d: `M${right - width} ${y - 6}v6h${width}v-6`, fill: "none" }),
    svg("text", { x: right - width - 8, y, "text-anchor": "end" }, length(metres)));
}
