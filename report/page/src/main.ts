// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** Puts the page together. */

import { depthChart } from "./depth_chart";
import { byId, element, swatch } from "./dom";
import { saveButtons, titled } from "./downloads";
import { eventList } from "./event_list";
import { Flight } from "./flight";
import { header } from "./header";
import { loggedTable } from "./logged";
import { trackMap } from "./map";
import { otherCharts } from "./other_charts";
import { readout } from "./readout";
import { promiseTable, yoTable } from "./tables";
import { Line, TimeChart } from "./time_chart";
import { View } from "./view";
import { water } from "./water";
import { XyChart } from "./xy_chart";

function lineColour(line: Line): string {
  return line.colour.startsWith("#") || line.colour.startsWith("rgb") ? line.colour : `var(--${line.colour})`;
}

/** A key to the lines; `toggle` makes them buttons. */
function legend(lines: Line[], toggle?: (label: string, show: boolean) => void): HTMLElement {
  const out = element("div", { class: "legend" });
  for (const label of new Set(lines.map((l) => l.label))) {
    const line = lines.find((l) => l.label === label) as Line;
    const mark = swatch(lineColour(line), line.points ? "dots" : `line${line.dash ? " dashed" : ""}`);
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

function saveChart(flight: Flight, title: string, chart: () => TimeChart): HTMLElement {
  return saveButtons(flight, {
    title,
    picture: () => { const { canvas } = chart().plot.ctx; return titled(canvas, canvas.width, canvas.height, title); },
    table: () => chart().table(),
  });
}

function timeCharts(flight: Flight, view: View): TimeChart[] {
  const host = byId("depth");
  const { chart, lines, chooser } = depthChart(host, flight, view);
  byId("depth-head").append(legend(lines, (label, show) => chart.toggle(label, show)), ...chooser,
    saveChart(flight, "Depth (m)", () => chart), zoomButtons(view));
  const others = otherCharts(flight, view, (title, shown, made) => {
    const place = element("div", { class: "chart" });
    byId("others").append(element("div", { class: "head" }, element("h3", {}, title), legend(shown), saveChart(flight, title, made)), place);
    return place;
  });
  return [chart, ...others];
}

/** Canvases keep the colours they were drawn in: draw again when the theme changes and for paper. */
function followTheme(charts: TimeChart[], plots: XyChart[]): void {
  const root = document.documentElement;
  const redraw = () => { charts.forEach((chart) => chart.redraw()); plots.forEach((plot) => plot.draw()); };
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  addEventListener("beforeprint", () => { root.classList.add("paper"); charts.forEach((chart) => chart.toPaper()); plots.forEach((plot) => plot.draw()); });
  addEventListener("afterprint", () => { root.classList.remove("paper"); charts.forEach((chart) => chart.toScreen()); plots.forEach((plot) => plot.draw()); });
}

function start(): void {
  const flight = new Flight(JSON.parse(byId("flight").textContent ?? ""));
  header(byId("header"), flight);
  const view = new View(flight);
  promiseTable(flight);
  eventList(byId("events"), flight, view);
  byId("events-card").hidden = flight.events.length === 0;
  if (flight.times.length === 0) {
    byId("empty").hidden = false;
    return;
  }
  byId("charts-card").hidden = false;
  byId("readout-card").hidden = false;
  byId("map-card").hidden = !trackMap(byId("map"), byId("map-head"), byId("map-legend"), flight, view);
  readout(byId("readout"), flight, view);
  const charts = timeCharts(flight, view);
  const { sections, plots } = water(flight, view);
  loggedTable(byId("logged"), flight, view);
  yoTable(flight, view);
  // A long label of a later chart widens all axes, so that their times stay below each other. uPlot draws first in microtasks.
  queueMicrotask(() => [...charts, ...sections].forEach((chart) => chart.redraw()));
  followTheme([...charts, ...sections], plots);
  if (flight.figures.rows > flight.times.length) {
    byId("thinned").textContent = `${flight.times.length} of ${flight.figures.rows} rows are drawn, including every inflection; ${flight.log ? "`glidercc log --csv` writes all records" : "the CSV trace has all rows"}.`;
  }
  view.showAll();
  view.moveToRow(0);
  document.documentElement.dataset["ready"] = "yes";
}

start();
