// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** Building elements. Text from the flight only ever becomes a text node, so that it stays inert. */

type Child = Node | string;

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, string> = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  Object.entries(attributes).forEach(([name, value]) => made.setAttribute(name, value));
  made.append(...children);
  return made;
}

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K, attributes: Record<string, string | number> = {}, ...children: Child[]): SVGElementTagNameMap[K] {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  Object.entries(attributes).forEach(([name, value]) => made.setAttribute(name, String(value)));
  made.append(...children);
  return made;
}

const coordinate = String.raw`\d+(?:\.\d+)?(?: \d+(?:\.\d+)?)?`;
const position = new RegExp(String.raw`(${coordinate} [NS](?: ${coordinate} [EW])?\b|${coordinate} [EW]\b)`);

/** `text` with its positions, as `39 10.498 N`, each on one line. */
export function unbroken(text: string): Child[] {
  return text.split(position).map((part, i) => (i % 2 === 1 ? element("span", { class: "unbroken" }, part) : part));
}

/** The element of index.html with this id. */
export function byId(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element ${id}`);
  return found;
}

/** A square of `colour` to stand before a name. */
export function swatch(colour: string, shape = ""): HTMLElement {
  const made = element("i", { class: `swatch ${shape}`, "aria-hidden": "true" });
  made.style.color = colour;
  return made;
}
