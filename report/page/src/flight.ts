// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The flight as the compiler's side wrote it into the page, and the quick look-ups that all views share. */

import { clock, utcText } from "./format";

export interface Column { name: string; unit: string }

export interface FlightEvent {
  time: number | null;
  missionTime: number | null;
  kind: string;
  what: string;
  why: string;
}

export interface Field { unit: string; times: number[]; depths: number[]; values: (number | null)[] }

export interface Figures {
  rows: number;
  duration: number | null;
  /** The part of it in which a log has no records. */
  gaps: number;
  shallowest: number | null;
  deepest: number | null;
  yos: number;
  /** Above this depth, m, the vehicle is at the surface. */
  surfaceDepth: number;
  distance: number | null;
  madeGood: number | null;
  /** The greatest distance of the reckoned position from the true one, m. */
  apart: number | null;
  /** Wh; what is not known is null. */
  energy: { used: number | null; known: number; partlyKnown: boolean; capacity: number | null; toGo: number | null; daysLeft: number | null; atMost: number | null; consumers: { device: string; used: number }[] };
  track: "none" | "true" | "dead-reckoned";
  coldest: number | null;
  warmest: number | null;
  states: { id: number; name: string; stretches: number; time: number }[];
  layered: number | null;
  stateless: number | null;
}

/** A requirement or an assumption of the mission, and what this flight did. */
export interface Promised { text: string; verdict: "held" | "violated" | "not checked" | "not decided"; time: number | null; words: string }

/** A value of a `log` statement; `half` is what it is of a position: "latitude", "longitude" or "". */
export interface Logged { column: string; text: string; value: string; half: string }

/** What the mission says about its flight, and the bottom around it. Columns have the vehicle's names. */
export interface Facts {
  /** The sensors that the mission lists. */
  listed: string[];
  /** Those that its conditions read, in order. */
  read: string[];
  logged: Logged[];
  promises: Promised[];
  places: { name: string; lat: number; lon: number }[];
  /** Distances that the mission compares with; m. */
  watches: { lat: number; lon: number; radius: number }[];
  /** Depths on a grid east and north of the start, m: x by y, y fastest. Empty: it is flat. */
  bottom: { x: number[]; y: number[]; depths: number[] };
}

/** A dive and the climb after it: s, m, m/s. */
export interface Yo { start: number; duration: number; deepest: number; down: number | null; up: number | null; surfaced: boolean }

const noFacts: Facts = { listed: [], read: [], logged: [], promises: [], places: [], watches: [], bottom: { x: [], y: [], depths: [] } };

/** What went wrong (with a code), or what else to know of the flight. */
export interface Warning { code: string; slug: string; message: string; hint: string }

/** What only a flight that a real vehicle has logged has. */
export interface VehicleLog {
  vehicle: string;
  /** UTC of time 0, s since 1970. */
  utc: number;
  /** The simulated flight that is drawn beside it; "": none. */
  beside: string;
  /** Where it has no records, from and to, by time. */
  gaps: [number, number][];
}

interface TraceJson {
  mission: string;
  scenario: string;
  way: string;
  ownControl: string;
  seed: number;
  states: string[];
  columns: Column[];
  rows: (number | null)[];
  events: FlightEvent[];
  field: Field;
  log?: VehicleLog;
}

export type Values = (number | null)[];

export type Pilot = number | "sbc" | "layered";

/** A stretch of time in which something stayed the same. `to` is where the next one begins, or a gap of the log. */
export interface Span<T> { from: number; to: number; value: T }

export class Flight {
  readonly figures: Figures;
  readonly warnings: Warning[];
  readonly facts: Facts;
  readonly yos: Yo[];
  readonly mission: string;
  readonly scenario: string;
  readonly way: string;
  /** What flies while the SBC is not in control. */
  readonly ownControl: string;
  readonly seed: number;
  readonly stateNames: string[];
  readonly columns: Column[];
  readonly events: FlightEvent[];
  readonly field: Field | null;
  readonly log: VehicleLog | null;
  /** Vehicle time of each row, ascending, s. */
  readonly times: number[];
  /** The columns that have a value somewhere. */
  private readonly values = new Map<string, Values>();

  constructor(json: { figures: Figures; warnings?: Warning[]; facts?: Facts; yos?: Yo[]; trace: TraceJson }) {
    const t = json.trace;
    this.figures = json.figures;
    this.warnings = json.warnings ?? [];
    this.facts = json.facts ?? noFacts;
    this.yos = json.yos ?? [];
    this.mission = t.mission;
    this.scenario = t.scenario;
    this.way = t.way;
    this.ownControl = t.ownControl;
    this.seed = t.seed;
    this.stateNames = t.states;
    this.columns = t.columns;
    this.events = t.events;
    this.field = soundField(t.field);
    this.log = t.log ?? null;
    const rows = rowsInOrder(t);
    const width = t.columns.length;
    t.columns.forEach((column, c) => {
      const values = rows.map((row) => t.rows[row * width + c]);
      if (!this.values.has(column.name) && values.some((v) => v !== null)) this.values.set(column.name, values);
    });
    this.times = (this.values.get("time") ?? []) as number[];
  }

  /** The values of a column, or null when the trace has none or never a value in it. */
  column(name: string): Values | null { return this.values.get(name) ?? null; }

  /** The first of `names` that has values. */
  firstOf(...names: string[]): string | null {
    return names.find((name) => this.column(name) !== null) ?? null;
  }

  /** The row whose time is nearest to `time`; -1 when there are no rows. */
  rowAt(time: number): number {
    const above = lowerBound(this.times, time);
    if (above === 0) return this.times.length === 0 ? -1 : 0;
    if (above === this.times.length) return above - 1;
    return time - this.times[above - 1] <= this.times[above] - time ? above - 1 : above;
  }

  /** The mission, for a log after its vehicle. */
  get title(): string {
    const mission = this.mission === "" ? "A flight" : this.mission;
    return this.log ? `${this.log.vehicle}: ${mission}` : mission;
  }

  /** How a time is written: since the start, for a log UTC, with its date if the log is of several days. */
  clock(time: number): string {
    if (!this.log) return clock(time);
    const text = utcText(this.log.utc + time);
    const last = this.times[this.times.length - 1] ?? 0;
    return utcText(this.log.utc).slice(0, 10) === utcText(this.log.utc + last).slice(0, 10) ? text.slice(11) : text;
  }

  /** True while the SBC flies: the column hook_active, or a current state where there is none. */
  inControl(row: number): boolean {
    const active = this.column("hook_active");
    return active ? (active[row] ?? 0) > 0 : (this.column("state")?.[row] ?? null) !== null;
  }

  /** Who decides: the number of a state, `sbc` for a mission without states, or `layered`: what the vehicle has for itself. */
  pilot(row: number): Pilot {
    const state = this.column("state")?.[row] ?? null;
    return state !== null ? state : this.inControl(row) ? "sbc" : "layered";
  }

  pilotName(pilot: Pilot): string {
    if (pilot === "layered") return this.log ? "state not known" : this.ownControl;
    return pilot === "sbc" ? "SBC" : this.stateNames[pilot] ?? `state ${pilot}`;
  }

  /** Whether nothing was recorded from this row to the next. */
  private gapAfter(row: number): boolean {
    const [from, to] = [this.times[row], this.times[row + 1]];
    return to !== undefined && (this.log?.gaps ?? []).some((gap) => gap[0] <= from && to <= gap[1]);
  }

  /** Runs of rows for which `of` gives the same; none where nothing was recorded. */
  spans<T>(of: (row: number) => T): Span<T>[] {
    const out: Span<T>[] = [];
    this.times.forEach((time, row) => {
      const cut = row > 0 && this.gapAfter(row - 1);
      if (cut && this.gapAfter(row)) return;
      const value = of(row);
      const open = out[out.length - 1];
      if (open && !cut) open.to = time;
      if (!open || cut || open.value !== value) out.push({ from: time, to: time, value });
    });
    return out;
  }
}

/** The first index whose value is not below `x`. */
export function lowerBound(sorted: ArrayLike<number>, x: number): number {
  let low = 0;
  let high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] < x) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** The rows that have a time, by time: charts and look-ups need them ascending. */
function rowsInOrder(t: TraceJson): number[] {
  const width = t.columns.length;
  const time = t.columns.findIndex((c) => c.name === "time");
  if (time < 0) return [];
  const at = (row: number) => t.rows[row * width + time] as number;
  const rows: number[] = [];
  for (let row = 0; (row + 1) * width <= t.rows.length; ++row) {
    if (t.rows[row * width + time] !== null) rows.push(row);
  }
  return rows.sort((a, b) => at(a) - at(b));
}

/** The field if its parts fit together, else null. */
function soundField(field: Field): Field | null {
  const { times, depths, values } = field;
  const ascending = (list: number[]) => list.every((v, i) => v !== null && (i === 0 || v > list[i - 1]));
  const sound = times.length > 0 && depths.length > 1 && values.length === times.length * depths.length &&
    ascending(times) && ascending(depths);
  return sound ? field : null;
}
