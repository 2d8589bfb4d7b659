// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** Where places are on the map, and how large it is: as wide or as tall as the flight needs. */

import { Anchor, Place } from "./track";

export const edge = { left: 88, right: 16, top: 26, bottom: 52 };

export interface Frame {
  width: number;
  height: number;
  x: (east: number) => number;
  y: (north: number) => number;
  /** Pixels to a metre. */
  scale: number;
  west: number; east: number; south: number; north: number;
  anchor: Anchor | null;
}

export interface Extent { west: number; east: number; south: number; north: number }

export function extentOf(places: Place[]): Extent {
  const [xs, ys] = [places.map((p) => p.x), places.map((p) => p.y)];
  const least = (v: number[]) => v.reduce((a, b) => Math.min(a, b), Infinity);
  const most = (v: number[]) => v.reduce((a, b) => Math.max(a, b), -Infinity);
  return { west: least(xs), east: most(xs), south: least(ys), north: most(ys) };
}

/** Smaller than this, m, is only the noise of a vehicle that stays where it is. */
const leastExtent = 60;
const heights = { least: 220, most: 560 };
const leastWidth = 300;
/** The part of the plot that the places fill. */
const filled = 0.84;

/** The plot for `room` pixels of width; `margin`: pixels on each side that the places must leave free. */
export function frameFor(extent: Extent, room: number, margin: number, anchor: Anchor | null): Frame {
  const [across, up] = [Math.max(extent.east - extent.west, leastExtent), Math.max(extent.north - extent.south, leastExtent)];
  const inner = (all: number) => Math.max(Math.min(all * filled, all - 2 * margin), 60);
  const outer = (all: number) => Math.max(all / filled, all + 2 * margin);
  const most = Math.max(room - edge.left - edge.right, 120);
  // As wide as there is room, unless the flight is so much longer to the north that most of it would be empty.
  let h = Math.min(Math.max(outer((inner(most) * up) / across), heights.least), heights.most);
  let w = Math.min(Math.max(outer((inner(h) * across) / up), leastWidth), most);
  if (up / across < h / most) w = most;
  h = Math.min(Math.max(outer((inner(w) * up) / across), heights.least), heights.most);
  const scale = Math.min(inner(w) / across, inner(h) / up);
  const [cx, cy] = [(extent.west + extent.east) / 2, (extent.south + extent.north) / 2];
  return {
    width: w + edge.left + edge.right, height: h + edge.top + edge.bottom,
    x: (v) => edge.left + w / 2 + (v - cx) * scale,
    y: (v) => edge.top + h / 2 - (v - cy) * scale,
    scale,
    west: cx - w / 2 / scale, east: cx + w / 2 / scale, south: cy - h / 2 / scale, north: cy + h / 2 / scale,
    anchor,
  };
}

/** The plot itself, inside the margins of its labels. */
export const plotBox = (frame: Frame) =>
  ({ x: edge.left, y: edge.top, width: frame.width - edge.left - edge.right, height: frame.height - edge.top - edge.bottom });
