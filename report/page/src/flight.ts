// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The flight as the compiler's side wrote it into the page, and the quick look-ups that all views share. */

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
  shallowest: number | null;
  deepest: number | null;
  yos: number;
  distance: number | null;
  madeGood: number | null;
  track: "none" | "true" | "dead-reckoned";
  coldest: number | null;
  warmest: number | null;
  states: { name: string; visits: number; time: number }[];
  layered: number | null;
}

interface TraceJson {
  mission: string;
  scenario: string;
  way: string;
  seed: number;
  states: string[];
  columns: Column[];
  rows: (number | null)[];
  events: FlightEvent[];
  field: Field;
}

export type Values = (number | null)[];

/** A stretch of time in which something stayed the same. `to` is where the next one begins. */
export interface Span<T> { from: number; to: number; value: T }

export class Flight {
  readonly figures: Figures;
  readonly mission: string;
  readonly scenario: string;
  readonly way: string;
  readonly seed: number;
  readonly stateNames: string[];
  readonly columns: Column[];
  readonly events: FlightEvent[];
  readonly field: Field | null;
  /** Vehicle time of each row, ascending, s. */
  readonly times: number[];
  private readonly values = new Map<string, Values>();

  constructor(json: { figures: Figures; trace: TraceJson }) {
    const t = json.trace;
    this.figures = json.figures;
    this.mission = t.mission;
    this.scenario = t.scenario;
    this.way = t.way;
    this.seed = t.seed;
    this.stateNames = t.states;
    this.columns = t.columns;
    this.events = t.events;
    this.field = soundField(t.field);
    const rows = rowsInOrder(t);
    const width = t.columns.length;
    t.columns.forEach((column, c) => {
      if (!this.values.has(column.name)) {
        this.values.set(column.name, rows.map((row) => t.rows[row * width + c]));
      }
    });
    this.times = (this.values.get("time") ?? []) as number[];
  }

  /** The values of a column, or null when the trace has none or never a value in it. */
  column(name: string): Values | null {
    const values = this.values.get(name);
    return values && values.some((v) => v !== null) ? values : null;
  }

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

  stateName(id: number): string { return this.stateNames[id] ?? `state ${id}`; }

  /** Runs of equal values of `column`, null included. */
  spans(column: string): Span<number | null>[] {
    const values = this.values.get(column);
    const out: Span<number | null>[] = [];
    if (!values) return out;
    values.forEach((value, row) => {
      const open = out[out.length - 1];
      if (open) open.to = this.times[row];
      if (!open || open.value !== value) out.push({ from: this.times[row], to: this.times[row], value });
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
