// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** Puts the page together. */

import { depthChart } from "./depth_chart";
import { byId, element, swatch } from "./dom";
import { eventList } from "./event_list";
import { Flight } from "./flight";
import { header } from "./header";
import { trackMap } from "./map";
import { otherCharts } from "./other_charts";
import { readout } from "./readout";
import { Line, TimeChart } from "./time_chart";
import { View } from "./view";

function lineColour(line: Line): string {
  return line.colour.startsWith("#") || line.colour.startsWith("rgb") ? line.colour : `var(--${line.colour})`;
}

/** A key to the lines; `toggle` makes them buttons. */
function legend(lines: Line[], onField = false, toggle?: (label: string, show: boolean) => void): HTMLElement {
  const out = element("div", { class: "legend" });
  for (const label of new Set(lines.map((l) => l.label))) {
    const line = lines.find((l) => l.label === label) as Line;
    const mark = swatch(lineColour(line), `line${line.dash ? " dashed" : ""}${onField ? " on-field" : ""}`);
    if (!toggle) {
      out.append(element("span", {}, mark, label));
      continue;
    }
    const button = element("button", { type: "button", "aria-pressed": String(!line.hidden) }, mark, label);
    button.addEventListener("click", () => {
      const show = button.getAttribute("aria-pressed") !== "true";
      button.setAttribute("aria-pressed", String(show));
      toggle(label, show);
    });
    out.append(button);
  }
  return out;
}

function zoomButtons(view: View): HTMLElement {
  const one = (label: string, name: string, act: () => void) => {
    const button = element("button", { type: "button", "aria-label": name, title: name }, label);
    button.addEventListener("click", act);
    return button;
  };
  return element("div", { class: "zoom" },
    one("◀", "earlier", () => view.pan(-0.5)), one("▶", "later", () => view.pan(0.5)),
    one("+", "zoom in", () => view.zoomBy(0.5, view.time)), one("−", "zoom out", () => view.zoomBy(2, view.time)),
    one("all", "show the whole flight", () => view.showAll()));
}

function timeCharts(flight: Flight, view: View): TimeChart[] {
  const host = byId("depth");
  const { chart, lines, onField, chooser } = depthChart(host, flight, view);
  byId("depth-head").append(legend(lines, onField, (label, show) => chart.toggle(label, show)), ...chooser, zoomButtons(view));
  const others = otherCharts(flight, view, (title, shown) => {
    const place = element("div", { class: "chart" });
    byId("others").append(element("div", { class: "head" }, element("h3", {}, title), legend(shown)), place);
    return place;
  });
  return [chart, ...others];
}

/** Canvases keep the colours they were drawn in: draw again when the theme changes and for paper. */
function followTheme(charts: TimeChart[]): void {
  const root = document.documentElement;
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => charts.forEach((chart) => chart.redraw()));
  addEventListener("beforeprint", () => { root.classList.add("paper"); charts.forEach((chart) => chart.toPaper()); });
  addEventListener("afterprint", () => { root.classList.remove("paper"); charts.forEach((chart) => chart.toScreen()); });
}

function start(): void {
  const flight = new Flight(JSON.parse(byId("flight").textContent ?? ""));
  header(byId("header"), flight);
  const view = new View(flight);
  eventList(byId("events"), flight, view);
  byId("events-card").hidden = flight.events.length === 0;
  if (flight.times.length === 0) {
    byId("empty").hidden = false;
    return;
  }
  byId("charts-card").hidden = false;
  byId("readout-card").hidden = false;
  byId("map-card").hidden = !trackMap(byId("map"), byId("map-legend"), flight, view);
  readout(byId("readout"), flight, view);
  const charts = timeCharts(flight, view);
  followTheme(charts);
  if (flight.figures.rows > flight.times.length) {
    byId("thinned").textContent = `${flight.times.length} of ${flight.figures.rows} rows are drawn, including every inflection; ${flight.log ? "`glidercc log --csv` writes all records" : "the CSV trace has all rows"}.`;
  }
  view.showAll();
  view.moveToRow(0);
  document.documentElement.dataset["ready"] = "yes";
}

start();
