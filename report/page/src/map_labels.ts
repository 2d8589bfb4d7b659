// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** Puts words beside marks so that none covers another or is cut off at the edge. */

import { svg } from "./dom";
import { Frame, plotBox } from "./map_frame";

export interface Box { x: number; y: number; width: number; height: number }

const fontSize = 12;
/** How far from the mark a word may stand, px: the nearest first. */
const distances = [10, 18, 30, 46];
const gap = 2;

const overlap = (a: Box, b: Box) =>
  a.x < b.x + b.width + gap && b.x < a.x + a.width + gap && a.y < b.y + b.height + gap && b.y < a.y + a.height + gap;

const ruler = document.createElement("canvas").getContext("2d");

/** The width of bold words, which is no less than that of plain ones. */
function widthOf(words: string): number {
  if (!ruler) return words.length * 8;
  ruler.font = `600 ${fontSize}px system-ui, "DejaVu Sans", sans-serif`;
  return ruler.measureText(words).width + 2;
}

export class Labels {
  private readonly taken: Box[] = [];

  constructor(private readonly frame: Frame) {}

  /** Keeps words off a mark of this half width. */
  keepOff(x: number, y: number, half: number): void {
    this.taken.push({ x: x - half, y: y - half, width: 2 * half, height: 2 * half });
  }

  /** The words beside the mark at `x`, `y`; null where there is no room for them. */
  beside(x: number, y: number, words: string, attributes: Record<string, string> = {}): SVGElement | null {
    const width = widthOf(words);
    for (const d of distances) {
      const near = d * 0.7;
      const places = [[x + d, y - 7], [x - d - width, y - 7], [x - width / 2, y - d - 14], [x - width / 2, y + d],
        [x + near, y - near - 14], [x - near - width, y - near - 14], [x + near, y + near], [x - near - width, y + near]];
      const free = places.map(([left, top]) => ({ x: left, y: top, width, height: 14 })).find((box) => this.isFree(box));
      if (free) {
        this.taken.push(free);
        return svg("text", { x: free.x, y: free.y + 11, ...attributes }, words);
      }
    }
    return null;
  }

  private isFree(box: Box): boolean {
    const plot = plotBox(this.frame);
    const inside = box.x >= plot.x + gap && box.x + box.width <= plot.x + plot.width - gap && box.y >= plot.y + gap &&
      box.y + box.height <= plot.y + plot.height - gap;
    return inside && !this.taken.some((other) => overlap(box, other));
  }
}
