// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The head of the page: which flight this is, and what it came to. */

import { element, swatch } from "./dom";
import { Figures, Flight, Warning } from "./flight";
import { clock, fixed, length, quantity, utcText } from "./format";
import { layeredColour, pilotColour } from "./palette";

const ways = new Map(Object.entries({
  "in-process": "flown in process",
  host: "flown by the host binary",
  ts7800: "flown by the TS-7800 (ARM9) binary",
  ts5500: "flown by the TS-5500 (486) binary",
  pizero2: "flown by the Pi Zero 2 (ARMv7) binary",
  cm4: "flown by the Compute Module 4 (ARMv8) binary",
}));

function figuresOf(f: Figures): [string, string][] {
  const out: [string, string][] = [];
  if (f.duration !== null) out.push(["duration", clock(f.duration)]);
  if (f.duration !== null && f.gaps > 0) out.push(["with records", clock(f.duration - f.gaps)]);
  if (f.deepest !== null) out.push(["deepest", `${fixed(f.deepest, 1)} m`]);
  out.push(["yos", String(f.yos)]);
  if (f.distance !== null) out.push([f.track === "dead-reckoned" ? "dead-reckoned track" : "over ground", length(f.distance)]);
  if (f.madeGood !== null) out.push(["made good", length(f.madeGood)]);
  if (f.apart !== null) out.push(["dead-reckoned and true position", `up to ${f.apart < 1000 ? `${fixed(f.apart, 0)} m` : `${fixed(f.apart / 1000, 1)} km`} apart`]);
  if (f.warmest !== null && f.coldest !== null) out.push(["water measured", `${fixed(f.coldest, 1)}–${fixed(f.warmest, 1)} °C`]);
  return out;
}

interface Part { name: string; size: number; text: string; colour: string }

/** A bar cut in proportion to the sizes of its parts, with its legend. */
function shareBar(title: string, parts: Part[]): HTMLElement {
  const bar = element("div", { class: "shares", "aria-hidden": "true" });
  const list = element("ul", { class: "share-list", "aria-label": title });
  for (const part of parts) {
    const piece = element("i");
    piece.style.flexGrow = String(part.size);
    piece.style.background = part.colour;
    bar.append(piece);
    list.append(element("li", {}, swatch(part.colour), element("b", {}, part.name), ` ${part.text}`));
  }
  return element("div", { class: "share-bar" }, element("p", { class: "share-title" }, title), bar, list);
}

/** The time in each state. */
function timeShares(flight: Flight): HTMLElement | null {
  const f = flight.figures;
  const times = (count: number) => (count === 1 ? ", current once" : `, current ${count} times`);
  const parts = f.states.map((s) => ({ name: s.name, size: s.time, text: clock(s.time) + times(s.stretches), colour: pilotColour(s.id) }));
  const other = (name: string, time: number, colour: string) => parts.push({ name, size: time, text: clock(time), colour });
  if (f.stateless) other("SBC", f.stateless, pilotColour("sbc"));
  if (parts.length === 0) return null;
  if (f.layered) other(flight.pilotName("layered"), f.layered, layeredColour);
  return shareBar("time in each state", parts);
}

/** What each device has taken from the batteries. */
function energyShares({ energy }: Figures): HTMLElement | null {
  if (energy.consumers.length === 0) return null;
  const total = energy.consumers.reduce((sum, one) => sum + one.used, 0);
  return shareBar("energy by device", energy.consumers.map((one, i) => ({ name: one.device, size: one.used,
    text: `${quantity(one.used, "Wh")} (${percent(one.used / total)})`, colour: pilotColour(i) })));
}

/** What must be known before any figure: red if the flight went wrong. */
function warningList(warnings: Warning[]): HTMLElement {
  const failed = warnings.some((w) => w.code !== "");
  return element("ul", { class: failed ? "warnings failed" : "warnings", role: "alert" }, ...warnings.map((w) =>
    element("li", {}, w.message, ...(w.code === "" ? [] : [" ", element("code", {}, `${w.code} ${w.slug}`)]))));
}

/** How the flight came about: when it was logged, or how it was simulated. */
function origin(flight: Flight): string[] {
  if (!flight.log) return [flight.scenario === "" ? "" : `scenario ${flight.scenario}`, flight.way === "none" ? `flown by ${flight.ownControl} alone` : ways.get(flight.way) ?? flight.way, `seed ${flight.seed}`];
  const last = flight.times[flight.times.length - 1] ?? 0;
  const [from, to] = [utcText(flight.log.utc), utcText(flight.log.utc + last)];
  const beside = flight.log.beside === "" ? "" : `simulated flight: ${flight.log.beside}`;
  return ["log of the vehicle", `${from} to ${from.slice(0, 10) === to.slice(0, 10) ? to.slice(11) : to} UTC`, beside];
}

/** What the vehicle has used up by its last record, and how long the rest lasts. */
function energyOf({ energy }: Figures): [string, string][] {
  if (energy.used === null) return [];
  const share = (part: number) => (energy.capacity === null ? "" : ` (${percent(part / energy.capacity)} of the pack)`);
  return [
    [energy.partlyKnown ? `energy used in ${clock(energy.known)}, not known for the rest` : "energy used",
      `${quantity(energy.used, "Wh")}${share(energy.used)}`],
    ...(energy.toGo === null ? [] : [["energy to go", `${quantity(energy.toGo, "Wh")}${energy.capacity === null ? "" : ` (${percent(energy.toGo / energy.capacity)})`}`] as [string, string]]),
    ...(energy.atMost === null ? [] : [["bound, until the mission ends", `at most ${quantity(energy.atMost, "Wh")}`] as [string, string]]),
    ...(energy.daysLeft === null ? [] : [["left at this rate", days(energy.daysLeft)] as [string, string]]),
  ];
}

const days = (count: number) => (count < 2 ? `${fixed(count * 24, 1)} h` : `${fixed(count, count < 10 ? 1 : 0)} days`);
const percent = (part: number) => `${fixed(part * 100, part < 0.1 ? 2 : 1)} %`;

export function header(host: HTMLElement, flight: Flight): void {
  const { title } = flight;
  document.title = `${title}: flight report`;
  const facts = [...origin(flight), `${flight.events.length} event${flight.events.length === 1 ? "" : "s"}`];
  const tiles = element("dl", { class: "tiles" }, ...[...figuresOf(flight.figures), ...energyOf(flight.figures)].map(([name, value]) =>
    element("div", {}, element("dt", {}, name), element("dd", {}, value))));
  const shares = [timeShares(flight), energyShares(flight.figures)].filter((bar) => bar !== null);
  host.replaceChildren(element("h1", {}, title), element("p", { class: "facts" }, facts.filter((x) => x !== "").join(" · ")),
    ...(flight.warnings.length === 0 ? [] : [warningList(flight.warnings)]), tiles, ...shares);
}
