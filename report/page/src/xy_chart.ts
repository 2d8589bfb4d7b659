// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** A chart of one measured quantity over another, coloured by the time of the flight. */

import { element } from "./dom";
import { digitsFor, fixed, niceStep } from "./format";
import { css, Scale, theme } from "./palette";

/** A point; `part` is how far into the flight it was measured, 0 to 1. */
export interface XyPoint { x: number; y: number; part: number }

/** A line of equal value, in the chart's units. */
export interface Isoline { label: string; points: { x: number; y: number }[] }

export interface XyOptions {
  label: string;
  xTitle: string;
  yTitle: string;
  /** Depth: 0 at the top. */
  inverted?: boolean;
  points: XyPoint[];
  isolines?: Isoline[];
  colours: Scale;
  height: number;
}

const edge = { left: 52, right: 12, top: 12, bottom: 44 };

function spanOf(values: number[], margin: number): [number, number] {
  const low = values.reduce((a, b) => Math.min(a, b), Infinity);
  const high = values.reduce((a, b) => Math.max(a, b), -Infinity);
  const extra = Math.max((high - low) * margin, Math.abs(high) * 1e-4, 1e-6);
  return [low - extra, high + extra];
}

/** Where values are on the canvas, CSS pixels. */
interface Frame { x: (v: number) => number; y: (v: number) => number; xs: [number, number]; ys: [number, number]; width: number; height: number }

function frameOf(o: XyOptions, width: number): Frame {
  const xs = spanOf(o.points.map((p) => p.x), 0.04);
  const ys = o.inverted ? [0, spanOf(o.points.map((p) => p.y), 0.04)[1]] as [number, number] : spanOf(o.points.map((p) => p.y), 0.04);
  const [w, h] = [width - edge.left - edge.right, o.height - edge.top - edge.bottom];
  const down = (v: number) => ((v - ys[0]) / (ys[1] - ys[0])) * h;
  return {
    x: (v) => edge.left + ((v - xs[0]) / (xs[1] - xs[0])) * w,
    y: (v) => (o.inverted ? edge.top + down(v) : edge.top + h - down(v)),
    xs, ys, width, height: o.height,
  };
}

function ticks([low, high]: [number, number], most: number): { values: number[]; digits: number } {
  const step = niceStep(high - low, most);
  const values: number[] = [];
  for (let v = Math.ceil(low / step) * step; v <= high + step * 1e-9; v += step) values.push(v);
  return { values, digits: digitsFor(step) };
}

function paintAxes(ctx: CanvasRenderingContext2D, frame: Frame, o: XyOptions): void {
  const [right, bottom] = [frame.width - edge.right, frame.height - edge.bottom];
  ctx.strokeStyle = theme("grid");
  ctx.fillStyle = theme("muted");
  ctx.font = "12px system-ui, sans-serif";
  ctx.lineWidth = 1;
  const line = (x0: number, y0: number, x1: number, y1: number) => { ctx.beginPath(); ctx.moveTo(x0, y0); ctx.lineTo(x1, y1); ctx.stroke(); };
  ctx.textAlign = "center";
  const across = ticks(frame.xs, Math.max(2, Math.floor((right - edge.left) / 60)));
  across.values.forEach((v) => { line(frame.x(v), edge.top, frame.x(v), bottom); ctx.fillText(fixed(v, across.digits), frame.x(v), bottom + 16); });
  ctx.textAlign = "right";
  const down = ticks(frame.ys, 6);
  down.values.forEach((v) => { line(edge.left, frame.y(v), right, frame.y(v)); ctx.fillText(fixed(v, down.digits), edge.left - 6, frame.y(v) + 4); });
  ctx.strokeStyle = theme("edge");
  ctx.strokeRect(edge.left, edge.top, right - edge.left, bottom - edge.top);
  ctx.textAlign = "center";
  ctx.fillText(o.xTitle, (edge.left + right) / 2, bottom + 35);
  ctx.save();
  ctx.translate(13, (edge.top + bottom) / 2);
  ctx.rotate(-Math.PI / 2);
  ctx.fillText(o.yTitle, 0, 0);
  ctx.restore();
}

function paintIsolines(ctx: CanvasRenderingContext2D, frame: Frame, lines: Isoline[]): void {
  ctx.strokeStyle = theme("muted");
  ctx.fillStyle = theme("muted");
  ctx.setLineDash([4, 3]);
  ctx.lineWidth = 0.8;
  ctx.font = "11px system-ui, sans-serif";
  ctx.textAlign = "right";
  for (const { label, points } of lines) {
    ctx.beginPath();
    points.forEach((p, i) => (i === 0 ? ctx.moveTo(frame.x(p.x), frame.y(p.y)) : ctx.lineTo(frame.x(p.x), frame.y(p.y))));
    ctx.stroke();
    const end = points.filter((p) => frame.y(p.y) > edge.top + 10).pop();
    if (end) ctx.fillText(label, frame.x(end.x) - 3, frame.y(end.y) - 3);
  }
  ctx.setLineDash([]);
}

function paintPoints(ctx: CanvasRenderingContext2D, frame: Frame, o: XyOptions): void {
  for (const p of o.points) {
    ctx.fillStyle = css(o.colours(p.part));
    ctx.fillRect(frame.x(p.x) - 1.25, frame.y(p.y) - 1.25, 2.5, 2.5);
  }
}

export class XyChart {
  readonly canvas = element("canvas", { role: "img" });

  constructor(private readonly host: HTMLElement, private readonly options: XyOptions) {
    this.canvas.setAttribute("aria-label", options.label);
    host.append(this.canvas);
    this.draw();
    new ResizeObserver(() => this.draw()).observe(host);
  }

  draw(): void {
    const width = Math.max(this.host.clientWidth, 200);
    const { height } = this.options;
    const scale = devicePixelRatio;
    [this.canvas.width, this.canvas.height] = [width * scale, height * scale];
    const ctx = this.canvas.getContext("2d");
    if (!ctx || this.options.points.length === 0) return;
    ctx.scale(scale, scale);
    const frame = frameOf(this.options, width);
    paintAxes(ctx, frame, this.options);
    ctx.save();
    ctx.beginPath();
    ctx.rect(edge.left, edge.top, width - edge.left - edge.right, height - edge.top - edge.bottom);
    ctx.clip();
    paintIsolines(ctx, frame, this.options.isolines ?? []);
    paintPoints(ctx, frame, this.options);
    ctx.restore();
  }
}
