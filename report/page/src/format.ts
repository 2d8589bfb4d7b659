// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** How quantities are written. */

/** `41:40`, or `3:02:05` from an hour on. */
export function clock(seconds: number): string {
  const sign = seconds < 0 ? "−" : "";
  const whole = Math.round(Math.abs(seconds));
  const two = (n: number) => String(n).padStart(2, "0");
  const [h, m, s] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  return sign + (h > 0 ? `${h}:${two(m)}:${two(s)}` : `${m}:${two(s)}`);
}

/** `2019-08-09 15:24:32` for seconds since 1970. */
export function utcText(seconds: number): string {
  return new Date(Math.floor(seconds) * 1000).toISOString().slice(0, 19).replace("T", " ");
}

/** A mark of a UTC axis whose marks are `step` s apart: `15:24`, and the date `08-09` at midnight. */
export function utcMark(seconds: number, step: number): string {
  const text = utcText(seconds);
  if (step >= 86400 || text.endsWith(" 00:00:00")) return text.slice(5, 10);
  return step < 60 ? text.slice(11) : text.slice(11, 16);
}

export function fixed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−");
}

/** How many decimals the multiples of `step` need to be written without rounding: 1 for 2.5. */
export function digitsFor(step: number): number {
  let digits = 0;
  for (let scaled = step; digits < 9 && Math.abs(scaled - Math.round(scaled)) > 1e-6 * scaled; scaled *= 10) digits += 1;
  return digits;
}

/** A length in m below 10 km, else in km. */
export function length(metres: number): string {
  return Math.abs(metres) < 10000 ? `${fixed(metres, 0)} m` : `${fixed(metres / 1000, 1)} km`;
}

/** `39° 10.500′ N`. */
export function degreesMinutes(degrees: number, positive: string, negative: string): string {
  const thousandths = Math.round(Math.abs(degrees) * 60000);
  const minutes = ((thousandths % 60000) / 1000).toFixed(3).padStart(6, "0");
  return `${Math.floor(thousandths / 60000)}° ${minutes}′ ${degrees < 0 ? negative : positive}`;
}

const shownUnits = new Map([["degC", "°C"], ["ug/l", "µg/L"], ["ug/L", "µg/L"], ["uM", "µmol/L"], ["ntu", "NTU"], ["nodim", ""], ["kg/m3", "kg/m³"], ["cc", "cm³"], ["deg", "°"], ["rad", "°"], ["id", ""], ["1", ""], ["timestamp", "UTC"]]);

/** The unit in which values of `unit` are shown: angles in degrees. */
export function shownUnit(unit: string): string {
  return shownUnits.get(unit) ?? unit;
}

/** What a value in `unit` is multiplied by to be shown in shownUnit(unit). */
export function shownFactor(unit: string): number { return unit === "rad" ? 180 / Math.PI : 1; }

const digitsOf = new Map([["m", 1], ["rad", 1], ["degC", 2], ["s", 0], ["V", 2], ["cc", 0], ["m/s", 3], ["A", 3], ["W", 2], ["Wh", 1], ["%", 1], ["in", 2], ["inHg", 2], ["bar", 2],
  ["dbar", 2], ["S/m", 3]]);

/** Units of instruments that measure over several powers of ten: three significant digits. */
const significant = new Set(["ug/l", "ug/L", "ntu", "uM"]);

function threeDigits(value: number): string {
  const digits = value === 0 ? 0 : Math.min(Math.max(2 - Math.floor(Math.log10(Math.abs(value))), 0), 6);
  return fixed(value, digits);
}

/** A value of a column as text with its shown unit. */
export function quantity(value: number, unit: string): string {
  if (unit === "timestamp") return `${utcText(value)} UTC`;
  const digits = digitsOf.get(unit);
  const number = significant.has(unit) ? threeDigits(value) : digits === undefined ? String(Number(value.toPrecision(6))).replace("-", "−")
    : fixed(value * shownFactor(unit), digits);
  const shown = shownUnit(unit);
  return shown === "" ? number : shown === "°" ? `${number}°` : `${number} ${shown}`;
}

/** A round step (1, 2 or 5 times a power of ten) that cuts `span` into at most `most` parts. */
export function niceStep(span: number, most: number): number {
  const rough = span / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * ([1, 2, 5, 10].find((m) => m * power >= rough * 0.999) ?? 10);
}
