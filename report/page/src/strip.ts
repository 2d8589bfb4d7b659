// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** What lies above the depth plot: the states by name, who is in control, and the marks of events. */

import uPlot from "uplot";
import { Flight, FlightEvent, Pilot, Span } from "./flight";
import { kindOf } from "./kinds";
import { inkOn, layeredColour, pilotColour, theme } from "./palette";

/** Heights above the plot, CSS pixels. */
const states = { from: 60, to: 38 };
const control = { from: 33, to: 27 };
const marks = { flag: 18, other: 7, size: 5.5 };
export const stripHeight = 66;

/** The events that are marked on the chart, those with a time and of a kind that is. */
export function markedEvents(flight: Flight): (FlightEvent & { time: number })[] {
  return flight.events.filter((e): e is FlightEvent & { time: number } => e.time !== null && kindOf(e.kind).marked);
}

/** A part of the plot's width, device pixels; null when it lies outside what is shown. */
function across(u: uPlot, from: number, to: number): { left: number; width: number } | null {
  const edge = u.bbox.left + u.bbox.width;
  const left = Math.max(u.valToPos(from, "x", true), u.bbox.left);
  const right = Math.min(u.valToPos(to, "x", true), edge);
  return right > left ? { left, width: right - left } : null;
}

function paintName(ctx: CanvasRenderingContext2D, name: string, left: number, width: number, middle: number): void {
  const scale = devicePixelRatio;
  const room = width - 8 * scale;
  let text = name;
  if (ctx.measureText(text).width > room) {
    let letters = Array.from(name).slice(0, 80);
    while (letters.length > 1 && ctx.measureText(`${letters.join("")}…`).width > room) letters = letters.slice(0, -1);
    text = letters.length > 1 || Array.from(name).length === 1 ? `${letters.join("")}…` : "";
  }
  if (text !== "" && room > 6 * scale) ctx.fillText(text, left + width / 2, middle);
}

/** Narrower than this, CSS pixels, a state has no room of its own. */
const narrow = 4;
/** The width of a bar of shares, CSS pixels. */
const binWidth = 10;

/** Part of the band: one state, or so many short ones that only their shares are drawn. */
type Piece = { span: Span<Pilot> } | { spans: Span<Pilot>[] };

/** Spans with room as they are, runs of three and more narrow ones together. */
function piecesOf(u: uPlot, spans: Span<Pilot>[]): Piece[] {
  const least = u.posToVal(narrow, "x") - u.posToVal(0, "x");
  const out: Piece[] = [];
  for (let i = 0; i < spans.length;) {
    let end = i;
    while (end < spans.length && spans[end].to - spans[end].from < least) ++end;
    if (end - i > 2) out.push({ spans: spans.slice(i, end) });
    else spans.slice(i, Math.max(end, i + 1)).forEach((span) => out.push({ span }));
    i = Math.max(end, i + 1);
  }
  return out;
}

/** Short states as bars that each show how its time is shared. */
function paintShares(u: uPlot, spans: Span<Pilot>[], top: number, height: number): void {
  const { ctx } = u;
  const part = across(u, spans[0].from, spans[spans.length - 1].to);
  if (!part) return;
  const step = binWidth * devicePixelRatio;
  const bins = Math.max(1, Math.round(part.width / step));
  const [first, last] = [u.posToVal(part.left, "x", true), u.posToVal(part.left + part.width, "x", true)];
  for (let bin = 0; bin < bins; ++bin) {
    const [from, to] = [first + ((last - first) * bin) / bins, first + ((last - first) * (bin + 1)) / bins];
    const shares = new Map<Pilot, number>();
    for (const span of spans) {
      const held = Math.min(span.to, to) - Math.max(span.from, from);
      if (held > 0) shares.set(span.value, (shares.get(span.value) ?? 0) + held);
    }
    let y = top;
    for (const [pilot, held] of [...shares].sort((a, b) => String(a[0]).localeCompare(String(b[0])))) {
      const tall = (height * held) / (to - from);
      ctx.fillStyle = pilotColour(pilot);
      ctx.fillRect(part.left + (part.width * bin) / bins, y, part.width / bins + 0.5, tall);
      y += tall;
    }
  }
}

export function paintStates(u: uPlot, spans: Span<Pilot>[], nameOf: (pilot: Pilot) => string): void {
  const { ctx } = u;
  const scale = devicePixelRatio;
  ctx.save();
  ctx.font = `600 ${12 * scale}px system-ui, sans-serif`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  const top = u.bbox.top - states.from * scale;
  const height = (states.from - states.to) * scale;
  for (const piece of piecesOf(u, spans)) {
    if ("spans" in piece) {
      paintShares(u, piece.spans, top, height);
      continue;
    }
    const { span } = piece;
    const part = across(u, span.from, span.to);
    if (!part) continue;
    const colour = pilotColour(span.value);
    ctx.globalAlpha = span.value === "layered" ? 0.35 : 1;
    ctx.fillStyle = colour;
    ctx.fillRect(part.left, top, Math.max(part.width - scale, scale), height);
    ctx.globalAlpha = 1;
    ctx.fillStyle = span.value === "layered" ? theme("ink") : inkOn(colour);
    paintName(ctx, nameOf(span.value), part.left, part.width, top + height / 2);
  }
  ctx.restore();
}

export function paintControl(u: uPlot, spans: Span<boolean>[]): void {
  const { ctx } = u;
  const scale = devicePixelRatio;
  const top = u.bbox.top - control.from * scale;
  const height = (control.from - control.to) * scale;
  ctx.save();
  for (const span of spans) {
    const part = across(u, span.from, span.to);
    if (!part) continue;
    if (span.value) {
      ctx.fillStyle = theme("control");
      ctx.fillRect(part.left, top, part.width, height);
    } else {
      ctx.fillStyle = layeredColour;
      ctx.fillRect(part.left, top + height / 2 - scale / 2, part.width, scale);
    }
  }
  ctx.restore();
}

function paintMark(ctx: CanvasRenderingContext2D, kind: string, x: number, y: number, size: number): void {
  ctx.beginPath();
  if (kind === "abort") {
    ctx.lineWidth = size * 0.55;
    ctx.moveTo(x - size, y - size);
    ctx.lineTo(x + size, y + size);
    ctx.moveTo(x + size, y - size);
    ctx.lineTo(x - size, y + size);
    ctx.stroke();
    return;
  }
  if (kind === "surface") {
    ctx.moveTo(x - size, y + size * 0.7);
    ctx.lineTo(x + size, y + size * 0.7);
    ctx.lineTo(x, y - size);
  } else if (kind === "control") {
    ctx.moveTo(x, y + size * 1.6);
    ctx.lineTo(x, y - size * 1.4);
    ctx.lineTo(x + size * 2, y - size * 0.5);
    ctx.lineTo(x, y + size * 0.4);
    ctx.lineWidth = size * 0.25;
    ctx.stroke();
  } else if (kind === "link") {
    ctx.arc(x, y, size * 0.8, 0, 2 * Math.PI);
  } else {
    ctx.moveTo(x - size, y - size * 0.7);
    ctx.lineTo(x + size, y - size * 0.7);
    ctx.lineTo(x, y + size);
  }
  ctx.fill();
}

/** Nearer than this, CSS pixels, marks of a kind are drawn as one. */
const together = 9;
/** With more lines than this through the plot they hide what is drawn there. */
const mostLines = 40;

interface Mark { kind: string; x: number; count: number }

/** The marks in view, from left to right; of a kind that is crowded, one for each stretch. */
function marksOf(u: uPlot, events: (FlightEvent & { time: number })[]): Mark[] {
  const last = new Map<string, Mark>();
  const out: Mark[] = [];
  for (const event of events) {
    if (event.time < (u.scales.x.min ?? 0) || event.time > (u.scales.x.max ?? 0)) continue;
    const x = Math.round(u.valToPos(event.time, "x", true));
    const before = last.get(event.kind);
    if (before && x - before.x < together * devicePixelRatio) {
      before.count += 1;
      continue;
    }
    const mark = { kind: event.kind, x, count: 1 };
    last.set(event.kind, mark);
    out.push(mark);
  }
  return out;
}

/** The marks above the plot, and their lines through it unless there are too many. */
export function paintEvents(u: uPlot, events: (FlightEvent & { time: number })[]): void {
  const { ctx } = u;
  const scale = devicePixelRatio;
  const bottom = u.bbox.top + u.bbox.height;
  const marksInView = marksOf(u, events);
  const lined = (flagged: boolean) => marksInView.filter((m) => kindOf(m.kind).flagged || !flagged).length <= mostLines;
  const [all, flagged] = [lined(false), lined(true)];
  ctx.save();
  for (const { kind: name, x } of marksInView) {
    const kind = kindOf(name);
    ctx.strokeStyle = ctx.fillStyle = theme(kind.colour);
    paintMark(ctx, name, x, u.bbox.top - (kind.flagged ? marks.flag : marks.other) * scale, marks.size * scale);
    if (!(kind.flagged ? flagged : all)) continue;
    for (const [width, colour] of [[3, theme("line-halo")], [1.25, theme(kind.flagged ? kind.colour : "event-line")]] as const) {
      ctx.beginPath();
      ctx.lineWidth = width * scale;
      ctx.strokeStyle = colour;
      ctx.setLineDash(kind.flagged ? [] : [4 * scale, 4 * scale]);
      ctx.moveTo(x, u.bbox.top);
      ctx.lineTo(x, bottom);
      ctx.stroke();
    }
    ctx.setLineDash([]);
  }
  ctx.restore();
}
