// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The track seen from above: equal scales, a grid in metres, degrees where they are known. */

import { element, svg } from "./dom";
import { Flight, Pilot } from "./flight";
import { degreesMinutes, fixed, length, niceStep } from "./format";
import { pilotColour } from "./palette";
import { Anchor, anchorOf, Current, currentsOf, fixesOf, Place, Point, Track, tracksOf, waypointsOf } from "./track";
import { View } from "./view";

const edge = { left: 58, right: 14, top: 26, bottom: 40 };
/** The arrow of the fastest current, px. */
const longestArrow = 60;
/** A waypoint further off than this many times the track's extent is only pointed at. */
const farFactor = 1.2;

interface Size { width: number; height: number }
interface Frame extends Size { x: (east: number) => number; y: (north: number) => number; scale: number; west: number; east: number; south: number; north: number }

/** `margin`: pixels on each side that the places must leave free. */
function frameFor(places: Place[], size: Size, margin: number): Frame {
  const xs = places.map((p) => p.x);
  const ys = places.map((p) => p.y);
  const [west, east] = [xs.reduce((a, b) => Math.min(a, b)), xs.reduce((a, b) => Math.max(a, b))];
  const [south, north] = [ys.reduce((a, b) => Math.min(a, b)), ys.reduce((a, b) => Math.max(a, b))];
  const [w, h] = [size.width - edge.left - edge.right, size.height - edge.top - edge.bottom];
  const room = (all: number) => Math.min(all * 0.86, all - 2 * margin);
  const perMetre = Math.min(room(w) / Math.max(east - west, 10), room(h) / Math.max(north - south, 10));
  const [cx, cy] = [(west + east) / 2, (south + north) / 2];
  return {
    ...size,
    x: (v) => edge.left + w / 2 + (v - cx) * perMetre,
    y: (v) => edge.top + h / 2 - (v - cy) * perMetre,
    scale: perMetre,
    west: cx - w / 2 / perMetre, east: cx + w / 2 / perMetre,
    south: cy - h / 2 / perMetre, north: cy + h / 2 / perMetre,
  };
}

const extent = (places: Place[]): number => {
  const span = (of: (p: Place) => number) =>
    places.reduce((a, p) => Math.max(a, of(p)), -Infinity) - places.reduce((a, p) => Math.min(a, of(p)), Infinity);
  return Math.max(span((p) => p.x), span((p) => p.y), 50);
};

function text(x: number, y: number, words: string, attributes: Record<string, string | number> = {}): SVGElement {
  return svg("text", { x, y, ...attributes }, words);
}

function grid(frame: Frame): SVGElement {
  const out = svg("g", { class: "grid" });
  const step = niceStep(Math.max(frame.east - frame.west, frame.north - frame.south), 8);
  const inKm = step >= 1000;
  const label = (v: number) => fixed(inKm ? v / 1000 : v, 0);
  for (let v = Math.ceil(frame.west / step) * step; v <= frame.east; v += step) {
    out.append(svg("line", { x1: frame.x(v), x2: frame.x(v), y1: edge.top, y2: frame.height - edge.bottom }));
    out.append(text(frame.x(v), frame.height - edge.bottom + 16, label(v), { "text-anchor": "middle" }));
  }
  for (let v = Math.ceil(frame.south / step) * step; v <= frame.north; v += step) {
    out.append(svg("line", { x1: edge.left, x2: frame.width - edge.right, y1: frame.y(v), y2: frame.y(v) }));
    out.append(text(edge.left - 7, frame.y(v) + 4, label(v), { "text-anchor": "end" }));
  }
  const unit = inKm ? "km" : "m";
  out.append(text((edge.left + frame.width - edge.right) / 2, frame.height - 6, `east (${unit})`, { "text-anchor": "middle" }));
  const middle = (edge.top + frame.height - edge.bottom) / 2;
  out.append(text(14, middle, `north (${unit})`, { "text-anchor": "middle", transform: `rotate(-90 14 ${middle})` }));
  return out;
}

function scaleBar(frame: Frame): SVGElement {
  const metres = niceStep(frame.east - frame.west, 5);
  const width = metres * frame.scale;
  const [right, y] = [frame.width - edge.right - 14, frame.height - edge.bottom - 16];
  return svg("g", { class: "scale" },
    svg("path", { d: `M${right - width} ${y - 5}v5h${width}v-5`, fill: "none" }),
    text(right - width / 2, y - 8, length(metres), { "text-anchor": "middle" }));
}

/** Points closer than half a pixel to the last one drawn add nothing. */
function path(points: Point[], frame: Frame): string {
  let out = "";
  let [lastX, lastY] = [NaN, NaN];
  points.forEach((p, i) => {
    const [x, y] = [frame.x(p.x), frame.y(p.y)];
    if (i > 0 && i < points.length - 1 && Math.hypot(x - lastX, y - lastY) < 0.5) return;
    out += `${i === 0 ? "M" : "L"}${x.toFixed(1)} ${y.toFixed(1)}`;
    [lastX, lastY] = [x, y];
  });
  return out;
}

/** The track cut where the state changes; a piece begins at the last point of the one before, unless a GPS fix has moved it. */
function pieces(track: Track, flight: Flight): { pilot: Pilot; points: Point[] }[] {
  const out: { pilot: Pilot; points: Point[] }[] = [];
  const legs = flight.column("dr_leg");
  let leg: number | null = null;
  for (const point of track.points) {
    const pilot = flight.pilot(point.row);
    const open = out[out.length - 1];
    const moved = open !== undefined && (legs?.[point.row] ?? null) !== leg;
    leg = legs?.[point.row] ?? null;
    if (!moved) open?.points.push(point);
    if (!open || moved || open.pilot !== pilot) out.push({ pilot, points: [point] });
  }
  return out;
}

function farWaypoint(place: Place, frame: Frame, from: Place): SVGElement {
  const [dx, dy] = [place.x - from.x, -(place.y - from.y)];
  const far = Math.hypot(dx, dy);
  const [ux, uy] = [dx / far, dy / far];
  const middle = { x: (edge.left + frame.width - edge.right) / 2, y: (edge.top + frame.height - edge.bottom) / 2 };
  const half = { x: (frame.width - edge.left - edge.right) / 2 - 20, y: (frame.height - edge.top - edge.bottom) / 2 - 20 };
  const reach = Math.min(Math.abs(half.x / ux), Math.abs(half.y / uy));
  const [x, y] = [middle.x + ux * reach, middle.y + uy * reach];
  const turn = (Math.atan2(uy, ux) * 180) / Math.PI;
  return svg("g", { class: "waypoint" },
    svg("path", { d: "M9 0L-6 6L-3 0L-6 -6Z", transform: `translate(${x} ${y}) rotate(${turn})` }),
    text(x - ux * 14, y + (uy > 0 ? -14 : 22), `waypoint, ${length(far)}`, { "text-anchor": ux > 0 ? "end" : "start" }));
}

function waypoints(places: Place[], frame: Frame, near: Set<Place>, from: Place): SVGElement[] {
  return places.map((place, i) => (near.has(place)
    ? svg("g", { class: "waypoint" },
      svg("path", { d: "M0 -7L7 0L0 7L-7 0Z", transform: `translate(${frame.x(place.x)} ${frame.y(place.y)})` }),
      text(frame.x(place.x) + 10, frame.y(place.y) + 4, `waypoint ${i + 1}`))
    : farWaypoint(place, frame, from)));
}

function caption(anchor: Anchor | null, start: Point): string {
  if (!anchor) return "";
  const lat = anchor.lat + (start.y - anchor.y) / anchor.perLat;
  const lon = anchor.lon + (start.x - anchor.x) / anchor.perLon;
  return `start ${degreesMinutes(lat, "N", "S")}  ${degreesMinutes(lon, "E", "W")}`;
}

function endMarks(frame: Frame, points: Point[]): SVGElement[] {
  const [first, last] = [points[0], points[points.length - 1]];
  const place = (p: Point) => ({ x: frame.x(p.x), y: frame.y(p.y) });
  const [a, b] = [place(first), place(last)];
  // Start's name stands above its mark, the end's below, both towards the middle of the map.
  const inward = (x: number) => (x > frame.width / 2 ? "end" : "start");
  return [
    svg("circle", { class: "start", cx: a.x, cy: a.y, r: 6 }),
    text(a.x, a.y - 12, "start", { class: "place", "text-anchor": inward(a.x) }),
    svg("rect", { class: "end", x: b.x - 5, y: b.y - 5, width: 10, height: 10 }),
    text(b.x, b.y + 21, "end", { class: "place", "text-anchor": inward(b.x) }),
  ];
}

/** Each estimate as an arrow from where it was made, in proportion to the speed of the current. */
function arrows(currents: Current[], frame: Frame): SVGElement[] {
  const fastest = fastestOf(currents);
  return currents.filter((c) => c.east !== 0 || c.north !== 0).map((c) => {
    const speed = Math.hypot(c.east, c.north);
    const [size, turn] = [(longestArrow * speed) / fastest, (Math.atan2(-c.north, c.east) * 180) / Math.PI];
    return svg("g", { class: "current", transform: `translate(${frame.x(c.x)} ${frame.y(c.y)}) rotate(${turn})` },
      svg("path", { d: `M0 0H${size}m-7 -4l7 4l-7 4` }), svg("title", {}, `depth-averaged current, ${fixed(speed, 2)} m/s`));
  });
}

const fastestOf = (currents: Current[]) => currents.reduce((most, c) => Math.max(most, Math.hypot(c.east, c.north)), 0);

function legend(chart: Chart): HTMLElement[] {
  const entry = (shape: string, words: string) => element("span", {}, element("i", { class: `swatch ${shape}`, "aria-hidden": "true" }), words);
  if (!chart.flight.log) return [entry("line state-line", "true track, in the state's colour"), entry("line dashed reckoned-line", "dead reckoned")];
  const fastest = fastestOf(chart.currents);
  return [
    entry("line state-line", `${chart.tracks[0].name === "GPS" ? "line between GPS fixes" : "dead-reckoned track"}, in the state's colour`),
    ...(chart.fixes.length > 0 ? [entry("fix-mark", "GPS fix")] : []),
    ...(fastest > 0 ? [entry("line current-line", `depth-averaged current, up to ${fixed(fastest, 2)} m/s`)] : []),
    ...(chart.tracks.some((t) => t.name === "simulated") ? [entry("line dashed simulated-line", "simulated flight")] : []),
  ];
}

/** What the map shows, apart from its size. */
interface Chart {
  flight: Flight; anchor: Anchor | null; tracks: Track[]; waypoints: Place[]; near: Set<Place>; fixes: Place[]; currents: Current[];
}

function chartOf(flight: Flight): Chart | null {
  const anchor = anchorOf(flight);
  const tracks = tracksOf(flight, anchor);
  if (tracks.length === 0) return null;
  const flown = tracks.flatMap((t) => t.points as Place[]);
  const [places, reach] = [waypointsOf(flight, anchor), extent(flown) * farFactor];
  const near = new Set(places.filter((p) => flown.some((q) => Math.hypot(p.x - q.x, p.y - q.y) < reach)));
  return { flight, anchor, tracks, waypoints: places, near, fixes: fixesOf(flight), currents: currentsOf(flight) };
}

const frameBox = (frame: Frame) =>
  ({ x: edge.left, y: edge.top, width: frame.width - edge.left - edge.right, height: frame.height - edge.top - edge.bottom });

/** The picture, with an empty layer for the part of the track that is in range, and the cursor's mark. */
function picture(chart: Chart, frame: Frame): { root: SVGSVGElement; shown: SVGElement; here: SVGElement } {
  const [main, other] = chart.tracks;
  const root = svg("svg", { viewBox: `0 0 ${frame.width} ${frame.height}`, role: "img", "aria-label": "Track of the glider seen from above" });
  const shown = svg("g", { class: "track" });
  const here = svg("circle", { class: "here", r: 5.5 });
  root.append(grid(frame));
  if (other) root.append(svg("path", { class: chart.flight.log ? "simulated" : "reckoned", d: path(other.points, frame) }));
  root.append(svg("g", { class: "track faded" }, ...strokes(chart, frame, () => true)), shown, ...arrows(chart.currents, frame),
    ...chart.fixes.map((p) => svg("circle", { class: "fix", cx: frame.x(p.x), cy: frame.y(p.y), r: 2.5 })),
    ...waypoints(chart.waypoints, frame, chart.near, main.points[0]), ...endMarks(frame, main.points), scaleBar(frame),
    svg("rect", { class: "frame", ...frameBox(frame) }), text(edge.left, edge.top - 9, caption(chart.anchor, main.points[0])), here);
  return { root, shown, here };
}

function strokes(chart: Chart, frame: Frame, keep: (p: Point) => boolean): SVGElement[] {
  return pieces(chart.tracks[0], chart.flight).map((piece) =>
    svg("path", { d: path(piece.points.filter(keep), frame), stroke: pilotColour(piece.pilot) }));
}

/** Draws the map into `host`, again whenever its width changes; false when the flight has no positions. */
export function trackMap(host: HTMLElement, key: HTMLElement, flight: Flight, view: View): boolean {
  const chart = chartOf(flight);
  if (!chart) return false;
  key.replaceChildren(...legend(chart));
  const points = chart.tracks[0].points;
  const everywhere = [...chart.tracks.flatMap((t) => t.points as Place[]), ...chart.fixes, ...chart.near];
  const margin = chart.currents.length > 0 ? longestArrow : 0;
  let frame = frameFor(everywhere, { width: 640, height: 480 }, margin);
  let drawn = picture(chart, frame);
  const showRange = () => drawn.shown.replaceChildren(...strokes(chart, frame,
    (p) => flight.times[p.row] >= view.range[0] && flight.times[p.row] <= view.range[1]));
  const showCursor = () => {
    const at = nearestRow(points, view.row);
    drawn.here.setAttribute("cx", String(frame.x(at.x)));
    drawn.here.setAttribute("cy", String(frame.y(at.y)));
  };
  const draw = (width: number) => {
    frame = frameFor(everywhere, { width, height: Math.min(Math.max(width * 0.8, 300), 520) }, margin);
    drawn = picture(chart, frame);
    drawn.root.addEventListener("pointermove", (event) => pointAt(event, points, frame, drawn.root, view));
    host.replaceChildren(drawn.root);
    showRange();
    showCursor();
  };
  draw(640);
  new ResizeObserver(() => {
    if (host.clientWidth > 0 && host.clientWidth !== frame.width) draw(host.clientWidth);
  }).observe(host);
  view.onRange(showRange);
  view.onCursor(showCursor);
  return true;
}

/** Moves the cursor to the point of the track under the pointer, if one is near. */
function pointAt(event: PointerEvent, points: Point[], frame: Frame, root: SVGSVGElement, view: View): void {
  const box = root.getBoundingClientRect();
  const x = ((event.clientX - box.left) / box.width) * frame.width;
  const y = ((event.clientY - box.top) / box.height) * frame.height;
  const distance = (p: Point) => Math.hypot(frame.x(p.x) - x, frame.y(p.y) - y);
  let best = points[0];
  for (const p of points) if (distance(p) < distance(best)) best = p;
  if (distance(best) < 24) view.moveToRow(best.row);
}

/** The point of the row nearest to `row`; `points` ascend by row. */
function nearestRow(points: Point[], row: number): Point {
  let low = 0;
  let high = points.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (points[middle].row < row) low = middle + 1;
    else high = middle;
  }
  return points[low];
}
