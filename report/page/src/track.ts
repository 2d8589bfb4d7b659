// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** Where the glider was, in metres east and north, whatever columns say so. */

import { Flight, lowerBound, Values } from "./flight";

export interface Point { row: number; x: number; y: number }
export interface Track { name: string; points: Point[] }
/** The place of a point on Earth, and metres per degree there. */
export interface Anchor { x: number; y: number; lat: number; lon: number; perLat: number; perLon: number }
export interface Place { x: number; y: number }

const radians = Math.PI / 180;

/** Lengths of a degree on the WGS 84 ellipsoid at latitude `lat`, m: the usual series (e.g. Snyder 1987, eq. 3-18 ff.). */
function metresPerDegree(lat: number): { perLat: number; perLon: number } {
  const p = lat * radians;
  return {
    perLat: 111132.954 - 559.822 * Math.cos(2 * p) + 1.175 * Math.cos(4 * p),
    perLon: 111412.84 * Math.cos(p) - 93.5 * Math.cos(3 * p) + 0.118 * Math.cos(5 * p),
  };
}

function pairs(a: Values, b: Values): Point[] {
  const out: Point[] = [];
  a.forEach((x, row) => {
    const y = b[row];
    if (x !== null && y !== null) out.push({ row, x, y });
  });
  return out;
}

export function pointsOf(flight: Flight, east: string, north: string): Point[] {
  const [x, y] = [flight.column(east), flight.column(north)];
  return x && y ? pairs(x, y) : [];
}

/** A place known both in metres and in degrees; from degrees alone the first one becomes the origin. */
export function anchorOf(flight: Flight): Anchor | null {
  const tries = [["true_lat", "true_lon", "true_x", "true_y"], ["m_lat", "m_lon", "m_x_lmc", "m_y_lmc"], ["m_lat", "m_lon", "dr_x", "dr_y"],
    ["m_gps_lat", "m_gps_lon", "gps_x", "gps_y"]];
  for (const [lat, lon, x, y] of tries) {
    const degrees = pointsOf(flight, lon, lat);
    const metres = new Map(pointsOf(flight, x, y).map((p) => [p.row, p]));
    const both = degrees.find((p) => metres.has(p.row));
    const at = both && metres.get(both.row);
    if (both && at) return { x: at.x, y: at.y, lat: both.y, lon: both.x, ...metresPerDegree(both.y) };
  }
  for (const [lat, lon] of tries) {
    const first = pointsOf(flight, lon, lat)[0];
    if (first) return { x: 0, y: 0, lat: first.y, lon: first.x, ...metresPerDegree(first.y) };
  }
  return null;
}

function fromDegrees(points: Point[], anchor: Anchor | null): Point[] {
  if (!anchor) return [];
  return points.map((p) => ({ row: p.row, ...placeOf(anchor, p.y, p.x) }));
}

/** Of a log: the dead-reckoned track, or at least the GPS fixes, then the simulated one. */
function logTracks(flight: Flight): Track[] {
  const one = (name: string, x: string, y: string): Track => ({ name, points: pointsOf(flight, x, y) });
  const [reckoned, fixes, simulated] = [one("dead reckoned", "dr_x", "dr_y"), one("GPS", "gps_x", "gps_y"), one("simulated", "sim_x", "sim_y")];
  return [reckoned.points.length > 0 ? reckoned : fixes, simulated].filter((t) => t.points.length > 0);
}

/** The GPS fixes of a log. */
export function fixesOf(flight: Flight): Place[] { return pointsOf(flight, "gps_x", "gps_y"); }

/** A depth-averaged current, m/s, and where the vehicle was when it had estimated it. */
export interface Current extends Place { east: number; north: number }

/** The vehicle's estimates of the current, each once. */
export function currentsOf(flight: Flight): Current[] {
  const [east, north] = flight.log ? ["current_x", "current_y"] : ["m_water_vx", "m_water_vy"];
  const places = flight.log ? [...pointsOf(flight, "gps_x", "gps_y"), ...pointsOf(flight, "dr_x", "dr_y")].sort((a, b) => a.row - b.row)
    : pointsOf(flight, "true_x", "true_y");
  return pointsOf(flight, east, north).filter((p, i, all) => i === 0 || p.x !== all[i - 1].x || p.y !== all[i - 1].y).flatMap((p) => {
    const at = places[lowerBound(places.map((place) => place.row), p.row)] ?? places[places.length - 1];
    return at ? [{ x: at.x, y: at.y, east: p.x, north: p.y }] : [];
  });
}

/** At how many points of the track the true current is shown. */
const truePoints = 8;

/** The mean current of each part of a simulated flight, at the part's middle. */
export function trueCurrentsOf(flight: Flight): Current[] {
  const places = pointsOf(flight, "true_x", "true_y");
  const flow = new Map(pointsOf(flight, "true_current_x", "true_current_y").map((p) => [p.row, p]));
  const part = Math.max(1, Math.ceil(places.length / truePoints));
  const out: Current[] = [];
  for (let from = 0; from < places.length; from += part) {
    const of = places.slice(from, from + part).flatMap((p) => flow.get(p.row) ?? []);
    const middle = places[Math.min(from + Math.floor(part / 2), places.length - 1)];
    const mean = (value: (p: Point) => number) => of.reduce((sum, p) => sum + value(p), 0) / of.length;
    if (of.length > 0) out.push({ x: middle.x, y: middle.y, east: mean((p) => p.x), north: mean((p) => p.y) });
  }
  return out;
}

/** A place on Earth in metres; the shorter way round, also across 180°. */
export function placeOf(anchor: Anchor, lat: number, lon: number): Place {
  const east = lon - anchor.lon;
  return { x: anchor.x + (east - 360 * Math.round(east / 360)) * anchor.perLon, y: anchor.y + (lat - anchor.lat) * anchor.perLat };
}

/** The true track and the dead-reckoned one, those there are, the true one first. */
export function tracksOf(flight: Flight, anchor: Anchor | null): Track[] {
  if (flight.log) return logTracks(flight);
  const one = (name: string, x: string, y: string, lat: string, lon: string): Track => {
    const metres = pointsOf(flight, x, y);
    return { name, points: metres.length > 0 ? metres : fromDegrees(pointsOf(flight, lon, lat), anchor) };
  };
  return [
    one("true track", "true_x", "true_y", "true_lat", "true_lon"),
    one("dead reckoned", "m_x_lmc", "m_y_lmc", "m_lat", "m_lon"),
  ].filter((t) => t.points.length > 0);
}

/** A flight that names more waypoints than this is steered towards moving points, which are no waypoints. */
const mostWaypoints = 100;

/** The different waypoints that were steered for, in order; the first mostWaypoints of them. */
export function waypointsOf(flight: Flight, anchor: Anchor | null): Place[] {
  const metres = pointsOf(flight, "c_wpt_x_lmc", "c_wpt_y_lmc");
  const all = metres.length > 0 ? metres : fromDegrees(pointsOf(flight, "c_wpt_lon", "c_wpt_lat"), anchor);
  const out: Place[] = [];
  for (const { x, y } of all) {
    if (out.length === mostWaypoints) break;
    if (!out.some((p) => Math.hypot(p.x - x, p.y - y) < 1)) out.push({ x, y });
  }
  return out;
}
