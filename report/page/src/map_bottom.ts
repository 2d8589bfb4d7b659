// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** Lines of equal water depth. */

import { svg } from "./dom";
import { Facts } from "./flight";
import { fixed, digitsFor, niceStep } from "./format";
import { Frame } from "./map_frame";
import { Labels } from "./map_labels";

type Segment = [number, number, number, number];

/** The pieces, from x, y to x, y, of the line on which the grid has `level`: marching squares with linear interpolation. */
export function contour(grid: Facts["bottom"], level: number): Segment[] {
  const { x, y, depths } = grid;
  const out: Segment[] = [];
  const at = (i: number, j: number) => depths[i * y.length + j];
  for (let i = 0; i + 1 < x.length; ++i) {
    for (let j = 0; j + 1 < y.length; ++j) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const cuts: number[][] = [];
      corners.forEach(([a, b], k) => {
        const [c, d] = corners[(k + 1) % 4];
        const [from, to] = [at(a, b), at(c, d)];
        if (from < level === to < level) return;
        const part = (level - from) / (to - from);
        cuts.push([x[a] + (x[c] - x[a]) * part, y[b] + (y[d] - y[b]) * part]);
      });
      for (let k = 0; k + 1 < cuts.length; k += 2) out.push([cuts[k][0], cuts[k][1], cuts[k + 1][0], cuts[k + 1][1]]);
    }
  }
  return out;
}

const mostLevels = 8;

/** The contours of the bottom with their depths, where it is not flat. */
export function contours(grid: Facts["bottom"], frame: Frame, labels: Labels): SVGElement[] {
  if (grid.depths.length === 0) return [];
  const [least, most] = [grid.depths.reduce((a, b) => Math.min(a, b)), grid.depths.reduce((a, b) => Math.max(a, b))];
  const step = niceStep(most - least, mostLevels);
  const out: SVGElement[] = [];
  for (let level = Math.ceil(least / step) * step; level <= most; level += step) {
    const pieces = contour(grid, level).map(([a, b, c, d]) => [frame.x(a), frame.y(b), frame.x(c), frame.y(d)]);
    const inside = pieces.filter(([a, b]) => a > 0 && a < frame.width && b > 0 && b < frame.height);
    if (inside.length === 0) continue;
    const words = `${fixed(level, digitsFor(step))} m`;
    const d = pieces.map(([a, b, c, e]) => `M${a.toFixed(1)} ${b.toFixed(1)}L${c.toFixed(1)} ${e.toFixed(1)}`).join("");
    out.push(svg("path", { class: "contour", d }, svg("title", {}, `water depth ${words}`)));
    for (let i = Math.floor(inside.length / 2), tries = 0; tries < 12; i = (i + 7) % inside.length, ++tries) {
      const label = labels.beside(inside[i][0] - 10, inside[i][1], words, { class: "contour-label" });
      if (label) {
        out.push(label);
        break;
      }
    }
  }
  return out;
}
