// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** What all views share: the time under the cursor and the stretch of time that is shown. */

import { Flight } from "./flight";

export class View {
  readonly full: [number, number];
  range: [number, number];
  row: number;
  private readonly cursorListeners: (() => void)[] = [];
  private readonly rangeListeners: (() => void)[] = [];

  constructor(private readonly flight: Flight) {
    const times = flight.times;
    const [first, last] = [times[0] ?? 0, times[times.length - 1] ?? 1];
    this.full = last > first ? [first, last] : [first - 1, first + 1];
    this.range = [...this.full];
    this.row = flight.times.length > 0 ? 0 : -1;
  }

  get time(): number { return this.flight.times[this.row] ?? this.full[0]; }

  onCursor(listener: () => void): void { this.cursorListeners.push(listener); }
  onRange(listener: () => void): void { this.rangeListeners.push(listener); }

  /** Moves the cursor to the row nearest to `time`; `reveal` also shifts the range so that it is shown. */
  moveTo(time: number, reveal = false): void { this.moveToRow(this.flight.rowAt(time), reveal); }

  moveToRow(row: number, reveal = false): void {
    this.row = Math.min(Math.max(row, 0), this.flight.times.length - 1);
    if (reveal && (this.time < this.range[0] || this.time > this.range[1])) {
      const half = (this.range[1] - this.range[0]) / 2;
      this.zoom(this.time - half, this.time + half);
    }
    this.cursorListeners.forEach((listener) => listener());
  }

  /** Shows `from` to `to`, moved or cut to lie inside the flight; never less than 2 s. */
  zoom(from: number, to: number): void {
    const span = Math.min(Math.max(to - from, 2), this.full[1] - this.full[0]);
    const middle = (from + to) / 2;
    const start = Math.min(Math.max(middle - span / 2, this.full[0]), this.full[1] - span);
    this.range = [start, start + span];
    this.rangeListeners.forEach((listener) => listener());
  }

  /** Shows `factor` times as much, keeping `at` where it is. */
  zoomBy(factor: number, at: number): void {
    const [from, to] = this.range;
    const anchor = Math.min(Math.max(at, from), to);
    this.zoom(anchor - (anchor - from) * factor, anchor + (to - anchor) * factor);
  }

  pan(part: number): void {
    const shift = (this.range[1] - this.range[0]) * part;
    this.zoom(this.range[0] + shift, this.range[1] + shift);
  }

  showAll(): void { this.zoom(...this.full); }
}
