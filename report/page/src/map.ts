// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** The track seen from above: equal scales, degrees and minutes where they are known, else metres. */

import { element, svg } from "./dom";
import { Flight, Pilot } from "./flight";
import { saveButtons, titled } from "./downloads";
import { degreesMinutes, fixed, length } from "./format";
import { LoggedPlace, loggedPlaces } from "./logged";
import { contours } from "./map_bottom";
import { edge, extentOf, Frame, frameFor, plotBox } from "./map_frame";
import { graticule, scaleBar } from "./map_grid";
import { Labels } from "./map_labels";
import { pilotColour } from "./palette";
import { Anchor, anchorOf, Current, currentsOf, fixesOf, Place, placeOf, Point, pointsOf, Track, tracksOf, trueCurrentsOf, waypointsOf } from "./track";
import { View } from "./view";

/** The arrow of the fastest current, px. */
const longestArrow = 60;
/** Below this, m/s, arrows stay short: such a current is none. */
const slowest = 0.05;
/** More arrows than this cover the track. */
const mostArrows = 24;
/** A place further off than this many times the track's extent is only pointed at. */
const farFactor = 1.2;
/** A waypoint this near to a place of the mission, m, is that place. */
const samePlace = 30;

const sizeOf = (places: Place[]): number => {
  const { west, east, south, north } = extentOf(places);
  return Math.max(east - west, north - south, 50);
};

function text(x: number, y: number, words: string, attributes: Record<string, string | number> = {}): SVGElement {
  return svg("text", { x, y, ...attributes }, words);
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

function farWaypoint(place: Waypoint, frame: Frame, from: Place, labels: Labels): SVGElement {
  const [dx, dy] = [place.x - from.x, -(place.y - from.y)];
  const far = Math.hypot(dx, dy);
  const [ux, uy] = [dx / far, dy / far];
  const plot = plotBox(frame);
  const middle = { x: plot.x + plot.width / 2, y: plot.y + plot.height / 2 };
  const reach = Math.min(Math.abs((plot.width / 2 - 20) / ux), Math.abs((plot.height / 2 - 20) / uy));
  const [x, y] = [middle.x + ux * reach, middle.y + uy * reach];
  const turn = (Math.atan2(uy, ux) * 180) / Math.PI;
  labels.keepOff(x, y, 9);
  const label = labels.beside(x, y, `${place.name}, ${length(far)}`, { class: "name" });
  return svg("g", { class: "waypoint" }, svg("path", { d: "M9 0L-6 6L-3 0L-6 -6Z", transform: `translate(${x} ${y}) rotate(${turn})` }), ...(label ? [label] : []));
}

function waypoints(chart: Chart, frame: Frame, labels: Labels): SVGElement[] {
  return chart.waypoints.map((place) => {
    if (!chart.near.has(place)) return farWaypoint(place, frame, chart.tracks[0].points[0], labels);
    const [x, y] = [frame.x(place.x), frame.y(place.y)];
    labels.keepOff(x, y, 7);
    const label = labels.beside(x, y, place.name, { class: "name" });
    return svg("g", { class: "waypoint" }, svg("path", { d: "M0 -7L7 0L0 7L-7 0Z", transform: `translate(${x} ${y})` }, svg("title", {}, place.name)),
      ...(label ? [label] : []));
  });
}

/** Where the mission logged a position; of many of one statement only the first has its words. */
function loggedMarks(chart: Chart, frame: Frame, labels: Labels): SVGElement[] {
  const named = new Set<string>();
  return chart.logged.map((place) => {
    const [x, y] = [frame.x(place.x), frame.y(place.y)];
    const first = !named.has(place.words);
    named.add(place.words);
    labels.keepOff(x, y, 5);
    const label = first && place.words !== "" ? labels.beside(x, y, place.words, { class: "place" }) : null;
    return svg("g", { class: "logged" }, svg("path", { d: "M0 -5L5 4H-5Z", transform: `translate(${x} ${y})` },
      svg("title", {}, `logged at ${chart.flight.clock(chart.flight.times[place.row])}: ${place.words} ${degreesMinutes(place.lat, "N", "S")} ${degreesMinutes(place.lon, "E", "W")}`)),
      ...(label ? [label] : []));
  });
}

/** The distances from a place that the mission compares with. */
function circles(chart: Chart, frame: Frame): SVGElement[] {
  return chart.circles.map((c) => svg("circle", { class: "watch", cx: frame.x(c.x), cy: frame.y(c.y), r: c.radius * frame.scale },
    svg("title", {}, `${length(c.radius)} around a place of the mission`)));
}

function caption(anchor: Anchor | null, start: Point): string {
  if (!anchor) return "";
  const lat = anchor.lat + (start.y - anchor.y) / anchor.perLat;
  const lon = anchor.lon + (start.x - anchor.x) / anchor.perLon;
  return `start ${degreesMinutes(lat, "N", "S")}  ${degreesMinutes(lon, "E", "W")}`;
}

function endMarks(frame: Frame, points: Point[], labels: Labels): SVGElement[] {
  const place = (p: Point) => ({ x: frame.x(p.x), y: frame.y(p.y) });
  const [a, b] = [place(points[0]), place(points[points.length - 1])];
  labels.keepOff(a.x, a.y, 6);
  labels.keepOff(b.x, b.y, 6);
  const words = [labels.beside(a.x, a.y, "start", { class: "place" }), labels.beside(b.x, b.y, "end", { class: "place" })];
  return [
    svg("circle", { class: "start", cx: a.x, cy: a.y, r: 6 }),
    svg("rect", { class: "end", x: b.x - 5, y: b.y - 5, width: 10, height: 10 }),
    ...words.filter((w): w is SVGElement => w !== null),
  ];
}

/** Each current as an arrow from where it was, in proportion to its speed. */
function arrows(chart: Chart, frame: Frame): SVGElement[] {
  const fastest = Math.max(fastestOf([...chart.currents, ...chart.trueCurrents]), slowest);
  const one = (c: Current, kind: string, words: string) => {
    const speed = Math.hypot(c.east, c.north);
    const [size, turn] = [(longestArrow * speed) / fastest, (Math.atan2(-c.north, c.east) * 180) / Math.PI];
    return svg("g", { class: kind, transform: `translate(${frame.x(c.x)} ${frame.y(c.y)}) rotate(${turn})` },
      svg("path", { d: `M0 0H${size}m-7 -4l7 4l-7 4` }), svg("title", {}, `${words}, ${fixed(speed, 2)} m/s`));
  };
  const moving = (list: Current[]) => list.filter((c) => c.east !== 0 || c.north !== 0);
  const few = (list: Current[]) => list.filter((_, i) => i % Math.ceil(list.length / mostArrows) === 0);
  return [...moving(chart.trueCurrents).map((c) => one(c, "true-current", "true current")),
    ...few(moving(chart.currents)).map((c) => one(c, "current", chart.flight.log ? "depth-averaged current" : "the vehicle's estimate of the current"))];
}

const fastestOf = (currents: Current[]) => currents.reduce((most, c) => Math.max(most, Math.hypot(c.east, c.north)), 0);

function legend(chart: Chart): HTMLElement[] {
  const entry = (shape: string, words: string) => element("span", {}, element("i", { class: `swatch ${shape}`, "aria-hidden": "true" }), words);
  const { flight } = chart;
  // The arrows of the true current are means.
  const fastest = fastestOf(chart.currents);
  const fastestTrue = fastestOf(pointsOf(flight, "true_current_x", "true_current_y").map((p) => ({ ...p, east: p.x, north: p.y })));
  const common = [
    ...(chart.circles.length > 0 ? [entry("watch-mark", "distance that the mission watches")] : []),
    ...(chart.logged.length > 0 ? [entry("logged-mark", "logged position")] : []),
    ...(flight.facts.bottom.depths.length > 0 ? [entry("line contour-line", "water depth")] : []),
  ];
  if (!flight.log) {
    return [entry("line state-line", "true track, in the state's colour"), entry("line dashed reckoned-line", "dead reckoned"),
      ...(fastest > 0 ? [entry("line current-line", `the vehicle's estimate of the current, up to ${fixed(fastest, 2)} m/s`)] : []),
      ...(fastestTrue > 0 ? [entry("line true-line", `true current, up to ${fixed(fastestTrue, 2)} m/s`)] : []), ...common];
  }
  return [
    entry("line state-line", `${chart.tracks[0].name === "GPS" ? "line between GPS fixes" : "dead-reckoned track"}, in the state's colour`),
    ...(chart.fixes.length > 0 ? [entry("fix-mark", "GPS fix")] : []),
    ...(new Set(flight.column("dr_leg") ?? []).size > 1 ? [entry("line dashed jump-line", "moved by a GPS fix")] : []),
    ...(fastest > 0 ? [entry("line current-line", `depth-averaged current, up to ${fixed(fastest, 2)} m/s`)] : []),
    ...(chart.tracks.some((t) => t.name === "simulated") ? [entry("line dashed simulated-line", "simulated flight")] : []), ...common,
  ];
}

interface Waypoint extends Place { name: string }
interface Circle extends Place { radius: number }

/** What the map shows, apart from its size. */
interface Chart {
  flight: Flight; anchor: Anchor | null; tracks: Track[]; waypoints: Waypoint[]; near: Set<Waypoint>; circles: Circle[]; fixes: Place[]; logged: (LoggedPlace & Place)[];
  currents: Current[]; trueCurrents: Current[];
}

/** From where the vehicle had reckoned itself to where a GPS fix has put it. */
function jumps(chart: Chart, frame: Frame): SVGElement[] {
  const legs = chart.flight.column("dr_leg");
  const { points } = chart.tracks[0];
  if (!legs) return [];
  return points.slice(1).flatMap((p, i) => (legs[p.row] === legs[points[i].row] ? []
    : [svg("path", { class: "jump", d: path([points[i], p], frame) }, svg("title", {}, "a GPS fix has moved the position"))]));
}

/** What the vehicle was steered to, by the names that the mission has for it, then the mission's other places. */
function namedWaypoints(flight: Flight, anchor: Anchor | null): Waypoint[] {
  const places = anchor ? flight.facts.places.map((p) => ({ ...placeOf(anchor, p.lat, p.lon), name: p.name })) : [];
  const isSame = (a: Place, b: Place) => Math.hypot(a.x - b.x, a.y - b.y) < samePlace;
  const steered = waypointsOf(flight, anchor).map((p, i) => ({ ...p, name: places.find((q) => isSame(p, q))?.name ?? `waypoint ${i + 1}` }));
  return [...steered, ...places.filter((p) => !steered.some((q) => isSame(p, q)))];
}

function chartOf(flight: Flight): Chart | null {
  const anchor = anchorOf(flight);
  const tracks = tracksOf(flight, anchor);
  if (tracks.length === 0) return null;
  const flown = tracks.flatMap((t) => t.points as Place[]);
  const places = namedWaypoints(flight, anchor);
  const reach = sizeOf(flown) * farFactor;
  const isNear = (p: Place) => flown.some((q) => Math.hypot(p.x - q.x, p.y - q.y) < reach);
  const circlesNear = anchor ? flight.facts.watches.map((c) => ({ ...placeOf(anchor, c.lat, c.lon), radius: c.radius })).filter((c) => isNear(c) && c.radius < 2 * reach) : [];
  return { flight, anchor, tracks, waypoints: places, near: new Set(places.filter(isNear)), circles: circlesNear, fixes: fixesOf(flight),
    logged: anchor ? loggedPlaces(flight).map((p) => ({ ...p, ...placeOf(anchor, p.lat, p.lon) })).filter(isNear) : [],
    currents: currentsOf(flight), trueCurrents: trueCurrentsOf(flight) };
}

/** All that must be in the plot. */
function shownPlaces(chart: Chart): Place[] {
  const around = chart.circles.flatMap((c) => [{ x: c.x - c.radius, y: c.y - c.radius }, { x: c.x + c.radius, y: c.y + c.radius }]);
  return [...chart.tracks.flatMap((t) => t.points as Place[]), ...chart.fixes, ...chart.near, ...around];
}

/** The picture, with an empty layer for the part of the track that is in range, and the cursor's mark. */
function picture(chart: Chart, frame: Frame): { root: SVGSVGElement; shown: SVGElement; here: SVGElement } {
  const [main, other] = chart.tracks;
  const root = svg("svg", { viewBox: `0 0 ${frame.width} ${frame.height}`, width: frame.width, height: frame.height, role: "img", "aria-label": "Track of the vehicle seen from above" });
  const shown = svg("g", { class: "track" });
  const here = svg("circle", { class: "here", r: 5.5 });
  const labels = new Labels(frame);
  // Words are given room in this order; the marks of the track are drawn last.
  const ends = endMarks(frame, main.points, labels);
  const marks = [...waypoints(chart, frame, labels), ...loggedMarks(chart, frame, labels)];
  const plot = svg("svg", { ...plotBox(frame), viewBox: Object.values(plotBox(frame)).join(" ") });
  plot.append(...contours(chart.flight.facts.bottom, frame, labels), ...circles(chart, frame));
  if (other) plot.append(svg("path", { class: chart.flight.log ? "simulated" : "reckoned", d: path(other.points, frame) }));
  plot.append(...jumps(chart, frame), svg("g", { class: "track faded" }, ...strokes(chart, frame, () => true)), shown, ...arrows(chart, frame),
    ...chart.fixes.map((p) => svg("circle", { class: "fix", cx: frame.x(p.x), cy: frame.y(p.y), r: 2.5 })), ...marks, ...ends);
  root.append(graticule(frame), plot, scaleBar(frame), svg("rect", { class: "frame", ...plotBox(frame) }),
    text(edge.left, edge.top - 9, caption(chart.anchor, main.points[0])), here);
  return { root, shown, here };
}

function strokes(chart: Chart, frame: Frame, keep: (p: Point) => boolean): SVGElement[] {
  return pieces(chart.tracks[0], chart.flight).map((piece) =>
    svg("path", { d: path(piece.points.filter(keep), frame), stroke: pilotColour(piece.pilot) }));
}

/** The attributes of a drawing that the style sheet gives. */
const painted = ["fill", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap", "stroke-linejoin", "opacity", "font-size", "font-weight", "font-family", "paint-order"];

/** The map as a picture by itself: the colours of the style sheet become attributes. */
async function pictureOf(root: SVGSVGElement, title: string): Promise<HTMLCanvasElement> {
  const copy = root.cloneNode(true) as SVGSVGElement;
  const from = root.querySelectorAll("*");
  copy.querySelectorAll("*").forEach((node, i) => {
    const style = getComputedStyle(from[i]);
    painted.forEach((name) => node.setAttribute(name, style.getPropertyValue(name)));
  });
  copy.querySelector(".here")?.remove();
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(new XMLSerializer().serializeToString(copy))}`;
  await image.decode();
  const scale = 2;
  return titled(image, root.width.baseVal.value * scale, root.height.baseVal.value * scale, title);
}

function saveMap(flight: Flight, chart: Chart, root: () => SVGSVGElement): HTMLElement {
  const { anchor } = chart;
  return saveButtons(flight, {
    title: "track",
    picture: () => pictureOf(root(), `${flight.title}: track`),
    table: () => ({
      head: ["time (s)", "east (m)", "north (m)", "latitude (deg)", "longitude (deg)"],
      rows: chart.tracks[0].points.map((p) => [flight.times[p.row], p.x, p.y,
        anchor ? anchor.lat + (p.y - anchor.y) / anchor.perLat : null, anchor ? anchor.lon + (p.x - anchor.x) / anchor.perLon : null]),
    }),
  });
}

/** Draws the map into `host`, again whenever its width changes; false when the flight has no positions. */
export function trackMap(host: HTMLElement, head: HTMLElement, key: HTMLElement, flight: Flight, view: View): boolean {
  const chart = chartOf(flight);
  if (!chart) return false;
  key.replaceChildren(...legend(chart));
  const points = chart.tracks[0].points;
  const extent = extentOf(shownPlaces(chart));
  const margin = fastestOf([...chart.currents, ...chart.trueCurrents]) > 0 ? longestArrow : 12;
  const usual = 640;
  let width = usual;
  let frame = frameFor(extent, width, margin, chart.anchor);
  let drawn = picture(chart, frame);
  const showRange = () => drawn.shown.replaceChildren(...strokes(chart, frame,
    (p) => flight.times[p.row] >= view.range[0] && flight.times[p.row] <= view.range[1]));
  const showCursor = () => {
    const at = nearestRow(points, view.row);
    drawn.here.setAttribute("cx", String(frame.x(at.x)));
    drawn.here.setAttribute("cy", String(frame.y(at.y)));
  };
  const draw = () => {
    frame = frameFor(extent, width, margin, chart.anchor);
    drawn = picture(chart, frame);
    drawn.root.addEventListener("pointermove", (event) => pointAt(event, points, frame, drawn.root, view));
    host.replaceChildren(drawn.root);
    showRange();
    showCursor();
  };
  draw();
  head.append(saveMap(flight, chart, () => drawn.root));
  new ResizeObserver(() => {
    if (host.clientWidth <= 0 || host.clientWidth === width) return;
    width = host.clientWidth;
    draw();
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
