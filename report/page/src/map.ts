// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The track seen from above: equal scales, a grid in metres, degrees where they are known. */

import { svg } from "./dom";
import { Flight } from "./flight";
import { degreesMinutes, fixed, length, niceStep } from "./format";
import { stateColour } from "./palette";
import { Anchor, anchorOf, Place, Point, Track, tracksOf, waypointsOf } from "./track";
import { View } from "./view";

const size = { width: 640, height: 520 };
const edge = { left: 58, right: 14, top: 26, bottom: 40 };
/** A waypoint further off than this many times the track's extent is only pointed at. */
const farFactor = 1.2;

interface Frame { x: (east: number) => number; y: (north: number) => number; scale: number; west: number; east: number; south: number; north: number }

function frameFor(places: Place[]): Frame {
  const xs = places.map((p) => p.x);
  const ys = places.map((p) => p.y);
  const [west, east] = [xs.reduce((a, b) => Math.min(a, b)), xs.reduce((a, b) => Math.max(a, b))];
  const [south, north] = [ys.reduce((a, b) => Math.min(a, b)), ys.reduce((a, b) => Math.max(a, b))];
  const [w, h] = [size.width - edge.left - edge.right, size.height - edge.top - edge.bottom];
  const perMetre = Math.min(w / Math.max(east - west, 10), h / Math.max(north - south, 10)) * 0.86;
  const [cx, cy] = [(west + east) / 2, (south + north) / 2];
  return {
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
    out.append(svg("line", { x1: frame.x(v), x2: frame.x(v), y1: edge.top, y2: size.height - edge.bottom }));
    out.append(text(frame.x(v), size.height - edge.bottom + 16, label(v), { "text-anchor": "middle" }));
  }
  for (let v = Math.ceil(frame.south / step) * step; v <= frame.north; v += step) {
    out.append(svg("line", { x1: edge.left, x2: size.width - edge.right, y1: frame.y(v), y2: frame.y(v) }));
    out.append(text(edge.left - 7, frame.y(v) + 4, label(v), { "text-anchor": "end" }));
  }
  const unit = inKm ? "km" : "m";
  out.append(text((edge.left + size.width - edge.right) / 2, size.height - 6, `east (${unit})`, { "text-anchor": "middle" }));
  const middle = (edge.top + size.height - edge.bottom) / 2;
  out.append(text(14, middle, `north (${unit})`, { "text-anchor": "middle", transform: `rotate(-90 14 ${middle})` }));
  return out;
}

function scaleBar(frame: Frame): SVGElement {
  const metres = niceStep(frame.east - frame.west, 5);
  const width = metres * frame.scale;
  const [right, y] = [size.width - edge.right - 14, size.height - edge.bottom - 16];
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

/** The track cut where the state changes; a piece begins at the last point of the one before. */
function pieces(track: Track, flight: Flight): { state: number | null; points: Point[] }[] {
  const states = flight.column("state");
  const out: { state: number | null; points: Point[] }[] = [];
  for (const point of track.points) {
    const state = states ? states[point.row] : null;
    const open = out[out.length - 1];
    open?.points.push(point);
    if (!open || open.state !== state) out.push({ state, points: [point] });
  }
  return out;
}

function farWaypoint(place: Place, from: Place): SVGElement {
  const [dx, dy] = [place.x - from.x, -(place.y - from.y)];
  const far = Math.hypot(dx, dy);
  const [ux, uy] = [dx / far, dy / far];
  const middle = { x: (edge.left + size.width - edge.right) / 2, y: (edge.top + size.height - edge.bottom) / 2 };
  const half = { x: (size.width - edge.left - edge.right) / 2 - 20, y: (size.height - edge.top - edge.bottom) / 2 - 20 };
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
    : farWaypoint(place, from)));
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
  const close = Math.hypot(a.x - b.x, a.y - b.y) < 30;
  return [
    svg("circle", { class: "start", cx: a.x, cy: a.y, r: 6 }),
    text(a.x - 10, a.y - 9, "start", { class: "place", "text-anchor": "end" }),
    svg("rect", { class: "end", x: b.x - 5, y: b.y - 5, width: 10, height: 10 }),
    text(b.x + 10, b.y + (close ? 18 : 4), "end", { class: "place" }),
  ];
}

/** Draws the map into `host`; false when the flight has no positions. */
export function trackMap(host: HTMLElement, flight: Flight, view: View): boolean {
  const anchor = anchorOf(flight);
  const tracks = tracksOf(flight, anchor);
  if (tracks.length === 0) return false;
  const [main, other] = tracks;
  const flown = tracks.flatMap((t) => t.points as Place[]);
  const all = waypointsOf(flight, anchor);
  const start = main.points[0];
  const reach = extent(flown) * farFactor;
  const near = new Set(all.filter((p) => flown.some((q) => Math.hypot(p.x - q.x, p.y - q.y) < reach)));
  const frame = frameFor([...flown, ...near]);

  const picture = svg("svg", { viewBox: `0 0 ${size.width} ${size.height}`, role: "img", "aria-label": "Track of the glider seen from above" });
  const clip = svg("clipPath", { id: "map-frame" },
    svg("rect", { x: edge.left, y: edge.top, width: size.width - edge.left - edge.right, height: size.height - edge.top - edge.bottom }));
  picture.append(svg("defs", {}, clip), grid(frame));
  if (other) picture.append(svg("path", { class: "reckoned", d: path(other.points, frame) }));
  const cut = pieces(main, flight);
  const layer = (name: string) => svg("g", { class: name });
  const [faded, shown] = [layer("track faded"), layer("track")];
  const draw = (into: SVGElement, keep: (p: Point) => boolean) => into.replaceChildren(...cut.map((piece) =>
    svg("path", { d: path(piece.points.filter(keep), frame), stroke: stateColour(piece.state) })));
  draw(faded, () => true);
  picture.append(faded, shown, ...waypoints(all, frame, near, start), ...endMarks(frame, main.points), scaleBar(frame));
  picture.append(svg("rect", { class: "frame", x: edge.left, y: edge.top, width: size.width - edge.left - edge.right, height: size.height - edge.top - edge.bottom }));
  picture.append(text(edge.left, edge.top - 9, caption(anchor, start)));
  const here = svg("circle", { class: "here", r: 5.5 });
  picture.append(here);
  host.replaceChildren(picture);

  view.onRange(() => draw(shown, (p) => flight.times[p.row] >= view.range[0] && flight.times[p.row] <= view.range[1]));
  view.onCursor(() => {
    const at = nearestRow(main.points, view.row);
    here.setAttribute("cx", String(frame.x(at.x)));
    here.setAttribute("cy", String(frame.y(at.y)));
  });
  picture.addEventListener("pointermove", (event) => {
    const box = picture.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * size.width;
    const y = ((event.clientY - box.top) / box.height) * size.height;
    let best = main.points[0];
    const distance = (p: Point) => Math.hypot(frame.x(p.x) - x, frame.y(p.y) - y);
    for (const p of main.points) if (distance(p) < distance(best)) best = p;
    if (distance(best) < 24) view.moveToRow(best.row);
  });
  return true;
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
