// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The temperature field as a picture to be stretched over the depth chart. */

import { Field, lowerBound } from "./flight";
import { thermal } from "./palette";

export interface FieldImage {
  canvas: HTMLCanvasElement;
  times: [number, number];
  depths: [number, number];
  /** Coldest and warmest, as given by the field. */
  range: [number, number];
}

const mostColumns = 2000;
const imageRows = 400;

/** For each of `count` evenly spaced points: the grid line before it and how far on towards the next, 0 to 1. */
function weights(grid: number[], count: number): { index: number; part: number }[] {
  const [first, last] = [grid[0], grid[grid.length - 1]];
  return Array.from({ length: count }, (_, i) => {
    const at = first + ((last - first) * (i + 0.5)) / count;
    const index = Math.min(Math.max(lowerBound(grid, at) - 1, 0), Math.max(grid.length - 2, 0));
    const step = grid.length > 1 ? grid[index + 1] - grid[index] : 1;
    return { index, part: Math.min(Math.max((at - grid[index]) / step, 0), 1) };
  });
}

/** Values between grid points are interpolated before they are coloured; a point beside a gap stays clear. */
export function fieldImage(field: Field): FieldImage | null {
  const known = field.values.filter((v): v is number => v !== null);
  const ctx = document.createElement("canvas").getContext("2d");
  if (known.length === 0 || !ctx) return null;
  const low = known.reduce((a, b) => Math.min(a, b));
  const high = known.reduce((a, b) => Math.max(a, b));
  const columns = field.times.length === 1 ? 1 : Math.min(mostColumns, Math.max(400, field.times.length));
  const [across, down] = [weights(field.times, columns), weights(field.depths, imageRows)];
  const rows = field.depths.length;
  const at = (time: number, depth: number) =>
    field.values[Math.min(time, field.times.length - 1) * rows + depth];
  ctx.canvas.width = columns;
  ctx.canvas.height = imageRows;
  const image = ctx.createImageData(columns, imageRows);
  const scale = Array.from({ length: 512 }, (_, i) => thermal(i / 511));
  for (let y = 0; y < imageRows; ++y) {
    for (let x = 0; x < columns; ++x) {
      const [a, b] = [across[x], down[y]];
      const corners = [at(a.index, b.index), at(a.index + 1, b.index), at(a.index, b.index + 1), at(a.index + 1, b.index + 1)];
      if (corners.some((v) => v === null)) continue;
      const [p, q, r, s] = corners as number[];
      const value = (p + (q - p) * a.part) * (1 - b.part) + (r + (s - r) * a.part) * b.part;
      const rgb = scale[high > low ? Math.round(((value - low) / (high - low)) * 511) : 256];
      image.data.set([...rgb, 255], (y * columns + x) * 4);
    }
  }
  ctx.putImageData(image, 0, 0);
  return {
    canvas: ctx.canvas,
    times: field.times.length === 1 ? [-Infinity, Infinity] : [field.times[0], field.times[field.times.length - 1]],
    depths: [field.depths[0], field.depths[rows - 1]],
    range: [low, high],
  };
}
