// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The charts below the depth: what was ordered beside what was measured, on the same time. */

import { Flight, Values } from "./flight";
import { quantity, shownFactor, shownUnit } from "./format";
import { rightMargin } from "./depth_chart";
import { Line, TimeChart } from "./time_chart";
import { View } from "./view";

interface Panel {
  title: string;
  measured: string;
  commanded?: string;
  /** The least height of the range, in the column's unit. */
  least: number;
  /** Wraps round at 360°. */
  round?: boolean;
}

const panels: Panel[] = [
  { title: "Pitch", measured: "m_pitch", commanded: "c_pitch", least: 0.2 },
  { title: "Heading, magnetic", measured: "m_heading", commanded: "c_heading", least: 0.35, round: true },
  { title: "Buoyancy pump", measured: "m_ballast_pumped", commanded: "c_ballast_pumped", least: 20 },
  { title: "Oil volume", measured: "m_de_oil_vol", commanded: "c_de_oil_vol", least: 20 },
  { title: "Vertical speed", measured: "m_depth_rate", least: 0.1 },
  { title: "Battery", measured: "m_battery", least: 0.5 },
  { title: "Power", measured: "power", least: 1 },
  { title: "Energy used", measured: "energy", least: 1 },
];

/** In the shown unit; a heading that passes north leaves a gap instead of a stroke across the chart. */
function shown(values: Values, unit: string, round: boolean): Values {
  const factor = shownFactor(unit);
  const out = values.map((v) => (v === null ? null : v * factor));
  if (!round) return out;
  return out.map((v, i) => (v !== null && i > 0 && out[i - 1] !== null && Math.abs(v - out[i - 1]!) > 180 ? null : v));
}

function rangeOf(lines: Line[], least: number): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const line of lines) {
    for (const value of line.values) {
      if (value === null) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  const half = Math.max((high - low) * 0.56, least / 2);
  return [(low + high) / 2 - half, (low + high) / 2 + half];
}

export interface PanelChart { title: string; unit: string; host: HTMLElement; lines: Line[] }

/** One chart for each panel whose measured column has values, made in the host that `place` gives. */
export function otherCharts(flight: Flight, view: View, place: (title: string, lines: Line[]) => HTMLElement): TimeChart[] {
  return panels.filter((p) => flight.column(p.measured)).map((p) => {
    const unit = flight.columns.find((c) => c.name === p.measured)?.unit ?? "";
    const measured = flight.column(p.measured) as Values;
    const commanded = p.commanded ? flight.column(p.commanded) : null;
    const lines: Line[] = [];
    if (commanded) {
      lines.push({ label: "commanded", values: shown(commanded, unit, p.round ?? false), colour: "commanded", width: 1.6, stepped: true });
    }
    lines.push({ label: "measured", values: shown(measured, unit, p.round ?? false), colour: "ink", width: 1.6 });
    const title = shownUnit(unit) === "" ? p.title : `${p.title} (${shownUnit(unit)})`;
    return new TimeChart(place(title, lines), flight, view, {
      label: p.title, height: 132, top: 8, right: rightMargin, lines,
      range: rangeOf(lines, p.least * shownFactor(unit)),
      describe: (row) => {
        const value = measured[row] ?? null;
        return value === null ? `${p.title} not known` : `${p.title} ${quantity(value, unit)}`;
      },
    });
  });
}
