// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** Buttons that save a chart as a picture or its numbers as a table. */

import { element } from "./dom";
import { Flight } from "./flight";
import { theme } from "./palette";

/** What a button saves: a picture, and a table by its columns. */
export interface Saved {
  title: string;
  /** None: it is only a table. */
  picture?: () => Promise<HTMLCanvasElement> | HTMLCanvasElement;
  table: () => { head: string[]; rows: (number | string | null)[][] };
}

/** "bloom-chlorophyll.png" for a file of this kind. */
export function fileName(flight: Flight, title: string, kind: string): string {
  const part = (text: string) => text.toLowerCase().replace(/\([^)]*\)/g, "").replace(/[^a-z0-9]+/g, "-").replace(/^-+|-+$/g, "");
  return `${[part(flight.title), part(title)].filter((p) => p !== "").join("-")}.${kind}`;
}

/** A table as text: what has a comma, a quote or a line end is quoted. */
export function csvText(head: string[], rows: (number | string | null)[][]): string {
  const cell = (value: number | string | null) => {
    const text = value === null ? "" : String(value);
    return /[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
  };
  return [head, ...rows].map((row) => row.map(cell).join(",")).join("\n") + "\n";
}

function save(content: Blob, name: string): void {
  const address = URL.createObjectURL(content);
  const link = element("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** `drawn` on the ground of the page, under its title. */
export function titled(drawn: CanvasImageSource, width: number, height: number, title: string): HTMLCanvasElement {
  const scale = devicePixelRatio;
  const head = 30 * scale;
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height + head];
  const ctx = canvas.getContext("2d") as CanvasRenderingContext2D;
  ctx.fillStyle = theme("panel");
  ctx.fillRect(0, 0, canvas.width, canvas.height);
  ctx.drawImage(drawn, 0, head, width, height);
  ctx.fillStyle = theme("ink");
  ctx.font = `600 ${14 * scale}px system-ui, sans-serif`;
  ctx.fillText(title, 10 * scale, 20 * scale);
  return canvas;
}

/** The buttons for one chart. */
export function saveButtons(flight: Flight, saved: Saved): HTMLElement {
  const one = (kind: string, act: () => void) => {
    const button = element("button", { type: "button", "aria-label": `save ${saved.title} as ${kind}`, title: `save as ${kind}` }, kind);
    button.addEventListener("click", act);
    return button;
  };
  const { picture } = saved;
  return element("span", { class: "save" },
    ...(picture ? [one("PNG", () => void Promise.resolve(picture()).then((canvas) =>
      canvas.toBlob((blob) => { if (blob) save(blob, fileName(flight, saved.title, "png")); })))] : []),
    one("CSV", () => {
      const { head, rows } = saved.table();
      save(new Blob([csvText(head, rows)], { type: "text/csv" }), fileName(flight, saved.title, "csv"));
    }));
}
