// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** One chart over time: a uPlot whose cursor and range are those of the View, usable by mouse, touch and keys. */

import uPlot from "uplot";
import { element } from "./dom";
import { Flight, Values } from "./flight";
import { clock, digitsFor, fixed, utcMark } from "./format";
import { theme } from "./palette";
import { View } from "./view";

export interface Line {
  label: string;
  values: Values;
  /** In a saved table, where `values` leaves some out. */
  all?: Values;
  /** Its name in a saved table, with the unit. */
  head?: string;
  /** A custom property of style.css, or a colour. */
  colour: string;
  width: number;
  dash?: number[];
  stepped?: boolean;
  /** A wider line drawn under it, to lift it off a coloured ground. */
  halo?: { colour: string; width: number };
  hidden?: boolean;
  /** Drawn as points: its values are far apart. */
  points?: boolean;
  /** Left out while many rows share a pixel and something else shows the same. */
  onlyIfSparse?: () => boolean;
}

export interface ChartOptions {
  label: string;
  height: number;
  /** Downward axis, 0 at the top. */
  inverted?: boolean;
  range: [number, number];
  /** A mark of the axis of values, in words; `step` is between two. */
  mark?: (value: number, step: number) => string;
  lines: Line[];
  /** Space above and to the right of the plot, CSS pixels. */
  top: number;
  right: number;
  paintUnder?: (u: uPlot) => void;
  paintOver?: (u: uPlot) => void;
  /** The values at the cursor in words, for assistive technology. */
  describe: (row: number) => string;
}

const colour = (name: string) => (name.startsWith("#") || name.startsWith("rgb") ? name : theme(name));
const steps = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800, 21600, 43200, 86400, 172800, 604800];

/** A quantity of which a log has few values: they are far apart, so they are drawn as points. */
const isSparse = (line: Line) => line.values.filter((v) => v !== null).length < 100;

function seriesOf(lines: Line[], logged: boolean): uPlot.Series[] {
  const one = (line: Line, stroke: string, width: number): uPlot.Series => ({
    label: line.label,
    show: !line.hidden,
    stroke: () => colour(stroke),
    width,
    ...(line.dash && stroke === line.colour ? { dash: line.dash } : {}),
    ...(line.stepped && uPlot.paths.stepped ? { paths: uPlot.paths.stepped({ align: 1 }) } : {}),
    points: { show: (u: uPlot) => (u.data[0].length < 2 || line.points === true || (logged && isSparse(line)) ? true : undefined) as boolean, size: line.points ? 6 : 4 },
    spanGaps: false,
  });
  return lines.flatMap((line) => [
    ...(line.halo ? [one(line, line.halo.colour, line.halo.width)] : []),
    one(line, line.colour, line.width),
  ]);
}

/** Marks of the time axis: round times since the start, of a log round times of UTC. */
function timeAxis(flight: Flight): Partial<uPlot.Axis> {
  const { log } = flight;
  if (!log) return { values: (_: uPlot, at: number[]) => at.map(clock) };
  return {
    splits: (_u: uPlot, _axis: number, min: number, max: number, step: number) => {
      const first = Math.ceil((log.utc + min) / step) * step - log.utc;
      return Array.from({ length: Math.max(0, Math.floor((max - first) / step) + 1) }, (_, i) => first + i * step);
    },
    values: (_: uPlot, at: number[], _axis: number, _space: number, step: number) => at.map((t) => utcMark(log.utc + t, step)),
  };
}

const labelFont = "12px system-ui, sans-serif";
let ruler: CanvasRenderingContext2D | null = null;
let room = 52;

/** The width of every chart's axis of values, in CSS pixels: that of the longest label of the page so far. */
function roomFor(labels: string[] | null): number {
  const besides = 14;
  ruler ??= document.createElement("canvas").getContext("2d");
  if (ruler) {
    ruler.font = labelFont;
    for (const label of labels ?? []) room = Math.max(room, Math.ceil(ruler.measureText(label).width) + besides);
  }
  return room;
}

function axes({ height, mark }: ChartOptions, flight: Flight): uPlot.Axis[] {
  const common = {
    stroke: () => theme("muted"),
    grid: { stroke: () => theme("grid"), width: 1 },
    ticks: { stroke: () => theme("grid"), width: 1, size: 5 },
    font: labelFont,
  };
  return [
    { ...common, incrs: steps, space: 70, size: 30, ...timeAxis(flight) },
    { ...common, size: (_: uPlot, labels: string[] | null) => roomFor(labels), space: height > 200 ? 36 : 24, values: (_: uPlot, at: number[]) => {
      const step = at.length > 1 ? Math.abs(at[1] - at[0]) : 1;
      if (mark) return at.map((v) => mark(v, step));
      const digits = digitsFor(step);
      return at.map((v) => fixed(v, digits));
    } },
  ];
}

export class TimeChart {
  readonly plot: uPlot;
  private readonly line = element("div", { class: "cursor" });
  private readonly dot = element("div", { class: "dot" });

  constructor(private readonly host: HTMLElement, private readonly flight: Flight, private readonly view: View,
              private readonly options: ChartOptions) {
    const data = options.lines.flatMap((line) => (line.halo ? [line.values, line.values] : [line.values]));
    this.plot = new uPlot(this.config(), [flight.times, ...data] as uPlot.AlignedData, host);
    this.plot.over.append(this.line, this.dot);
    this.listen();
    view.onCursor(() => this.showCursor());
    view.onRange(() => this.showRange());
    new ResizeObserver(() => this.resize()).observe(host);
    this.showRange();
  }

  /** Shows or hides the line of this label. */
  toggle(label: string, show: boolean): void {
    this.plot.series.forEach((series, i) => {
      if (i > 0 && series.label === label) this.plot.setSeries(i, { show });
    });
  }

  /** The numbers of its lines, as they are shown. */
  table(): { head: string[]; rows: (number | null)[][] } {
    const { lines } = this.options;
    return {
      head: [this.flight.log ? "time (s since 1970)" : "time (s)", ...lines.map((line) => line.head ?? line.label)],
      rows: this.flight.times.map((time, row) => [time + (this.flight.log?.utc ?? 0), ...lines.map((line) => (line.all ?? line.values)[row] ?? null)]),
    };
  }

  redraw(): void { this.plot.redraw(false, true); }

  /** As wide as a sheet of A4 or Letter between its margins, and drawn anew. */
  toPaper(): void { this.plot.setSize({ width: 690, height: this.options.height }); }

  toScreen(): void { this.plot.setSize({ width: this.host.clientWidth, height: this.options.height }); }

  private config(): uPlot.Options {
    const o = this.options;
    return {
      width: Math.max(this.host.clientWidth, 280),
      height: o.height,
      padding: [o.top, o.right, 0, 0],
      legend: { show: false },
      cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: false, setScale: false } },
      scales: { x: { time: false, range: () => this.view.range }, y: { range: o.range, dir: o.inverted ? -1 : 1 } },
      series: [{}, ...seriesOf(o.lines, this.flight.log !== null)],
      axes: axes(o, this.flight),
      hooks: {
        drawClear: [(u: uPlot) => { this.thinLines(u); u.ctx.globalAlpha = 1; o.paintUnder?.(u); }],
        draw: [(u: uPlot) => { u.ctx.globalAlpha = 1; o.paintOver?.(u); }],
        setSelect: [(u: uPlot) => this.takeSelection(u)],
      },
    };
  }

  /** Where many rows share a pixel, lines let the ground through; halos would cover all. */
  private thinLines(u: uPlot): void {
    const [from, to] = this.view.range.map((time) => this.flight.rowAt(time));
    const dense = to - from > 3 * u.over.clientWidth;
    const parts = this.options.lines.flatMap((line) => (line.halo ? [{ line, halo: true }, { line, halo: false }] : [{ line, halo: false }]));
    u.series.slice(1).forEach((series, i) => {
      const { line, halo } = parts[i];
      series.alpha = !dense ? 1 : halo || line.onlyIfSparse?.() ? 0 : 0.6;
    });
  }

  private takeSelection(u: uPlot): void {
    const { left, width } = u.select;
    if (width < 4) return;
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.view.zoom(u.posToVal(left, "x"), u.posToVal(left + width, "x"));
  }

  private listen(): void {
    const over = this.plot.over;
    const time = (event: MouseEvent) => this.plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x");
    over.addEventListener("pointermove", (event) => this.view.moveTo(time(event)));
    over.addEventListener("pointerdown", (event) => this.view.moveTo(time(event)));
    over.addEventListener("dblclick", () => this.view.showAll());
    over.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !event.shiftKey) return;
      event.preventDefault();
      this.view.zoomBy((event.deltaY || event.deltaX) > 0 ? 1.25 : 0.8, time(event));
    }, { passive: false });
    over.tabIndex = 0;
    over.setAttribute("role", "slider");
    over.setAttribute("aria-label", `${this.options.label}: time under the cursor`);
    over.addEventListener("keydown", (event) => this.key(event));
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const view = this.view;
    const far = event.shiftKey ? 10 : 1;
    const actions: Record<string, () => void> = {
      ArrowLeft: () => view.moveToRow(view.row - far, true),
      ArrowRight: () => view.moveToRow(view.row + far, true),
      PageUp: () => view.moveToRow(view.row - 50, true),
      PageDown: () => view.moveToRow(view.row + 50, true),
      Home: () => view.moveTo(view.full[0], true),
      End: () => view.moveTo(view.full[1], true),
      "+": () => view.zoomBy(0.5, view.time),
      "-": () => view.zoomBy(2, view.time),
      "0": () => view.showAll(),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  private showRange(): void {
    this.plot.setScale("x", { min: this.view.range[0], max: this.view.range[1] });
    this.showCursor();
  }

  private showCursor(): void {
    const { view, plot } = this;
    const left = plot.valToPos(view.time, "x");
    const shown = view.row >= 0 && view.time >= view.range[0] && view.time <= view.range[1];
    this.line.style.display = shown ? "" : "none";
    this.line.style.transform = `translateX(${left}px)`;
    const value = this.options.lines[this.options.lines.length - 1]?.values[view.row] ?? null;
    this.dot.style.display = shown && value !== null ? "" : "none";
    this.dot.style.transform = `translate(${left}px, ${plot.valToPos(value ?? 0, "y")}px)`;
    plot.over.setAttribute("aria-valuemin", String(view.full[0]));
    plot.over.setAttribute("aria-valuemax", String(view.full[1]));
    plot.over.setAttribute("aria-valuenow", String(view.time));
    plot.over.setAttribute("aria-valuetext", `${this.flight.clock(view.time)}, ${this.options.describe(view.row)}`);
  }

  private resize(): void {
    const width = this.host.clientWidth;
    if (width > 0 && width !== this.plot.width) this.plot.setSize({ width, height: this.options.height });
    this.showCursor();
  }
}
